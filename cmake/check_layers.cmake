# Checks which folder includes which, and that every third-party header stays in its home (docs/architecture.md).
#   cmake -DROOT=<repository> -P cmake/check_layers.cmake
cmake_minimum_required(VERSION 3.25)

set(DOORS sensors/readings.hpp sensors/camera_model.hpp)  # all that slam sees of the truth side
set(ALLOW_core core)
set(ALLOW_worlds core worlds)
set(ALLOW_sim core worlds sim)
set(ALLOW_sensors core worlds sim sensors)
set(ALLOW_slam core slam ${DOORS})
set(ALLOW_eval core worlds sim sensors slam eval)
set(ALLOW_cli core worlds sim sensors slam eval cli)

# Each entry: headers that begin so @ files that may include them.
set(HOMES
  "box2d/@^sim/[^/]*\\.cpp$"
  "GL/@^sensors/floor_[^/]*\\.cpp$"
  "opencv2/@^(slam/(odometry|mobile_sensing)/[^/]*|worlds/map_contours)\\.cpp$"
  "ceres/@^slam/(odometry|match|mobile_sensing)/[^/]*\\.cpp$"
  "yaml-cpp/@^core/config[^/]*\\.cpp$"
  "zlib\\.h@^(core/text_file|sensors/[a-z_/]*|eval/page/packed)\\.cpp$"
  "Random123/@^(core/rng|sensors/pixel_noise)\\.cpp$"  # a picture draws a million numbers at once
  "nlohmann/@^eval/"
  "png\\.h@^(eval/|worlds/map_image_png\\.cpp$)"
  "sqlite3\\.h@^eval/sweep/"
  "lz4\\.h@^eval/lab/"
  "zstd\\.h@^eval/lab/"
  "CLI/@^cli/"
  "fmt/@^(eval|cli)/")

set(bad "")

function(check_folder source target allow)
  string(REGEX REPLACE "/.*" "" folder ${target})
  if(NOT folder IN_LIST allow AND NOT target IN_LIST allow)
    set(bad "${bad}  ${source} includes ${target}\n" PARENT_SCOPE)
  endif()
endfunction()

function(check_home source target)
  foreach(entry ${HOMES})
    string(REGEX MATCH "^[^@]*" header "${entry}")
    string(REGEX REPLACE "^[^@]*@" "" home "${entry}")
    if(target MATCHES "^${header}" AND NOT source MATCHES "${home}")
      set(bad "${bad}  ${source} includes <${target}>, whose home is elsewhere\n" PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

foreach(layer core worlds sim sensors slam eval cli)
  file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${layer}/*.hpp ${ROOT}/${layer}/*.cpp)
  foreach(source ${sources})
    set(allow ${ALLOW_${layer}})
    if(source IN_LIST DOORS)
      set(allow core ${DOORS})  # else the door would let through what stands behind it
    endif()
    file(STRINGS ${ROOT}/${source} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line ${lines})
      if(line MATCHES "include[ \t]*\"([^\"]+)\"")
        check_folder(${source} ${CMAKE_MATCH_1} "${allow}")
      elseif(line MATCHES "include[ \t]*<([^>]+)>")
        set(target ${CMAKE_MATCH_1})
        check_home(${source} ${target})
        # Our own folders come in quotes; angle brackets must not be a way around the rule.
        if(target MATCHES "^(core|worlds|sim|sensors|slam|eval|cli)/")
          set(bad "${bad}  ${source} includes <${target}>, ours in angle brackets\n")
        endif()
      endif()
    endforeach()
  endforeach()
endforeach()

if(bad)
  message(FATAL_ERROR "layer rule broken:\n${bad}")
endif()
