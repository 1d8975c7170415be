# One static library and one test program per folder.

# cogslam_layer(worlds LINKS cogslam_core ...): all sources of the folder, except those named in EXCEPT.
function(cogslam_layer name)
  cmake_parse_arguments(ARG "" "" "LINKS;SYSTEM;EXCEPT" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  foreach(pattern ${ARG_EXCEPT})
    list(FILTER sources EXCLUDE REGEX ${pattern})
  endforeach()
  if(NOT sources)  # headers only
    add_library(cogslam_${name} INTERFACE)
    set_target_properties(cogslam_${name} PROPERTIES EXPORT_NAME ${name})
    target_link_libraries(cogslam_${name} INTERFACE cogslam_options Eigen3::Eigen ${ARG_LINKS})
    return()
  endif()
  add_library(cogslam_${name} STATIC ${sources})
  target_link_libraries(cogslam_${name} PUBLIC cogslam_options Eigen3::Eigen ${ARG_LINKS} PRIVATE ${ARG_SYSTEM})
  set_target_properties(cogslam_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${name})
endfunction()

# cogslam_tests(worlds LINKS ...): tests/worlds/*_test.cpp as one program, each TEST a ctest of its own.
function(cogslam_tests name)
  cmake_parse_arguments(ARG "" "" "LINKS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${name}_tests ${sources})
  target_link_libraries(${name}_tests PRIVATE cogslam_${name} ${ARG_LINKS} cogslam_test_support GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name}_tests PRIVATE COGSLAM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(COGSLAM_PCH)
    target_precompile_headers(${name}_tests REUSE_FROM cogslam_test_pch)
    target_compile_options(${name}_tests PRIVATE -fpch-preprocess)  # else ccache cannot look through it
  endif()
  gtest_discover_tests(${name}_tests DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()
