# Configures cmake/page.cmake alone as on a machine without npm, and with a registry that does not answer: it must say
# so, and the page must come without script but with its style.
#   cmake -DROOT=<repository> -DBUILD=<folder> -P check_without_npm.cmake
cmake_minimum_required(VERSION 3.25)

# configure(<folder> <exit 0 expected> <words expected> <options>...)
function(configure name good words)
  set(folder ${BUILD}/${name})
  file(REMOVE_RECURSE ${folder})
  file(WRITE ${folder}/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(page LANGUAGES NONE)\n"
    "include(${ROOT}/cmake/page.cmake)\nadd_custom_target(page ALL DEPENDS \${COGSLAM_PAGE_SOURCE})\n")
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${folder} -B ${folder}/build ${ARGN}
    RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(FIND "${said}" "${words}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${name}: expected \"${words}\" in: ${said}")
  endif()
  if(good AND NOT code EQUAL 0 OR NOT good AND code EQUAL 0)
    message(FATAL_ERROR "${name}: exit code ${code}: ${said}")
  endif()
  if(NOT good)
    return()
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder}/build COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
  file(READ ${folder}/build/page_built_in.cpp source)
  string(REGEX MATCH "kRunPageScript =\n    R\"page_text\\(\\)page_text\";" script "${source}")
  string(FIND "${source}" "prefers-color-scheme" style)
  if(script STREQUAL "" OR style EQUAL -1)
    message(FATAL_ERROR "${name}: expected a style and no script in page_built_in.cpp")
  endif()
endfunction()

set(none -DNPM=)
configure(absent ON "the pages of runs will be static, without replay, since npm is not installed" ${none})
configure(demanded OFF "no replay: npm is not installed" ${none} -DCOGSLAM_PAGE=ON)
configure(off ON "Page: static, since COGSLAM_PAGE is OFF" -DCOGSLAM_PAGE=OFF)
find_program(FALSE false)
configure(failing ON "since npm could not install its parts" -DNPM=${FALSE} -DNODE=${FALSE})
