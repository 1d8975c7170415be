# Plants a small tree with one violation of every kind and expects check_layers.cmake to name each, and nothing else.
#   cmake -DCHECK=<check_layers.cmake> -DTREE=<scratch folder> -P check_planted.cmake
file(REMOVE_RECURSE ${TREE})

function(expect_verdict expected_result)
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${TREE} -P ${CHECK} RESULT_VARIABLE result ERROR_VARIABLE said)
  if((result EQUAL 0) EQUAL (expected_result STREQUAL "fails"))
    message(FATAL_ERROR "expected that the check ${expected_result}, it returned ${result}:\n${said}")
  endif()
  string(REGEX MATCHALL "\n *[a-z_/]+\\.[ch]pp includes" named "${said}")
  list(LENGTH named count)
  list(LENGTH ARGN expected_count)
  if(NOT count EQUAL expected_count)
    message(FATAL_ERROR "expected ${expected_count} violations, ${count} were named:\n${said}")
  endif()
  foreach(violation ${ARGN})
    string(FIND "${said}" "${violation}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "not named: ${violation}\n${said}")
    endif()
  endforeach()
endfunction()

# All of this is allowed.
file(WRITE ${TREE}/core/rng.cpp "#include \"core/rng.hpp\"\n#include <Random123/philox.h>\n#include <vector>\n")
file(WRITE ${TREE}/sim/world.cpp "#include <box2d/box2d.h>\n#include \"worlds/world.hpp\"\n")
file(WRITE ${TREE}/sensors/readings.hpp "#include \"core/pose2.hpp\"\n")
file(WRITE ${TREE}/slam/fast_slam.cpp "#include \"sensors/readings.hpp\"\n#include \"slam/map/store.hpp\"\n")
file(WRITE ${TREE}/slam/match/matcher.cpp "#include <ceres/tiny_solver.h>\n")
file(WRITE ${TREE}/eval/episode.cpp "#include \"sim/truth.hpp\"\n#include <nlohmann/json.hpp>\n")
expect_verdict(passes)

# Each of these breaks the rule once.
file(WRITE ${TREE}/core/peek.cpp "#include \"slam/fast_slam.hpp\"\n")
file(WRITE ${TREE}/worlds/moving.hpp "#include \"sim/simulation.hpp\"\n")
file(WRITE ${TREE}/slam/cheat.cpp "#include \"sim/truth.hpp\"\n")
file(WRITE ${TREE}/slam/round_about.cpp "# include <worlds/world.hpp>\n")
file(WRITE ${TREE}/sensors/camera_model.hpp "#include \"sensors/lidar.hpp\"\n")
file(WRITE ${TREE}/sim/leak.hpp "#include <box2d/b_body.h>\n")
file(WRITE ${TREE}/slam/solver.cpp "#include \"ceres/ceres.h\"\n")
expect_verdict(fails
  "core/peek.cpp includes slam/fast_slam.hpp"
  "worlds/moving.hpp includes sim/simulation.hpp"
  "slam/cheat.cpp includes sim/truth.hpp"
  "slam/round_about.cpp includes <worlds/world.hpp>, ours in angle brackets"
  "sensors/camera_model.hpp includes sensors/lidar.hpp"
  "sim/leak.hpp includes <box2d/b_body.h>, whose home is elsewhere"
  "slam/solver.cpp includes ceres/ceres.h")

file(REMOVE_RECURSE ${TREE})
