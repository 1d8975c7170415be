# Installs the build into a scratch folder and builds and runs a consumer against it.
#   cmake -DBUILD=<build folder> -DSOURCE=<repository> -DCXX=<compiler> -P check.cmake
set(scratch ${BUILD}/consumer)
file(REMOVE_RECURSE ${scratch})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE complained)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${ARGN}\n${said}${complained}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${scratch}/usr)
# Whoever installs it may move it, and has neither our sources nor our build.
file(RENAME ${scratch}/usr ${scratch}/moved)
file(GLOB_RECURSE configs ${scratch}/moved/lib/*.cmake)
foreach(config ${configs})
  file(READ ${config} text)
  if(text MATCHES "${SOURCE}")
    message(FATAL_ERROR "${config} names the folder that it was built from")
  endif()
endforeach()
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${scratch}/build -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS}" -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DCMAKE_PREFIX_PATH=${scratch}/moved)
run(${CMAKE_COMMAND} --build ${scratch}/build)
run(${scratch}/build/filter_alone)
run(${scratch}/build/consumer ${scratch}/moved/share/cogslam/scenarios/flat.yaml)
if(NOT said MATCHES "flat: [0-9]+ readings, 2 variants, [0-9]+ surfaces, a picture of [0-9]+ bytes")
  message(FATAL_ERROR "the consumer said: ${said}")
endif()
run(${scratch}/moved/bin/cogslam validate ${scratch}/moved/share/cogslam/scenarios/cluttered.yaml --quiet)
file(REMOVE_RECURSE ${scratch})
