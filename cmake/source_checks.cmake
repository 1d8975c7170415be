# Tests of the sources themselves: who includes whom, and the format.
add_test(NAME layers COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -P ${PROJECT_SOURCE_DIR}/cmake/check_layers.cmake)
add_test(NAME layers_names_planted_violations
  COMMAND ${CMAKE_COMMAND} -DCHECK=${PROJECT_SOURCE_DIR}/cmake/check_layers.cmake
    -DTREE=${PROJECT_BINARY_DIR}/planted -P ${PROJECT_SOURCE_DIR}/tests/layers/check_planted.cmake)

find_program(CLANG_FORMAT clang-format)
if(CLANG_FORMAT)
  add_test(NAME format COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DCLANG_FORMAT=${CLANG_FORMAT}
    -P ${PROJECT_SOURCE_DIR}/cmake/check_format.cmake)
else()
  add_test(NAME format COMMAND ${CMAKE_COMMAND} -E echo "clang-format is not installed: skipped")
  set_tests_properties(format PROPERTIES SKIP_REGULAR_EXPRESSION "skipped")
endif()
