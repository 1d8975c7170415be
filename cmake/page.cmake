# The scripts of pages (eval/page/web): their parts come from npm, once per lock file, while configuring; esbuild joins
# them into one file for each kind of page while building. Without npm the program writes static pages. Sets COGSLAM_PAGE_SOURCE, a C++ file
# with style, scripts and notices, and COGSLAM_PAGE_PARTS, the folder with node_modules, or nothing.
set(PAGE_WEB ${CMAKE_CURRENT_LIST_DIR}/../eval/page/web)
get_filename_component(PAGE_WEB ${PAGE_WEB} ABSOLUTE)
set(PAGE_BUILD ${CMAKE_CURRENT_BINARY_DIR}/page)
find_program(NPM npm)
find_program(NODE NAMES node nodejs)

# Installs what package-lock.json names, and nothing else, into the build folder. `result`: empty, or why not.
function(cogslam_install_page_parts result)
  set(${result} "" PARENT_SCOPE)
  if(NOT NPM OR NOT NODE)
    set(${result} "npm is not installed" PARENT_SCOPE)
    return()
  endif()
  file(SHA256 ${PAGE_WEB}/package-lock.json lock)
  if(EXISTS ${PAGE_BUILD}/installed-${lock})
    return()
  endif()
  file(REMOVE_RECURSE ${PAGE_BUILD})
  file(COPY ${PAGE_WEB}/package.json ${PAGE_WEB}/package-lock.json DESTINATION ${PAGE_BUILD})
  message(STATUS "Page: installing its parts by npm")
  execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
    WORKING_DIRECTORY ${PAGE_BUILD} RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said TIMEOUT 300)
  if(code EQUAL 0)
    file(WRITE ${PAGE_BUILD}/installed-${lock} "")
  else()
    string(STRIP "${said}" said)
    set(${result} "npm could not install its parts: ${said}" PARENT_SCOPE)
  endif()
endfunction()

set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PAGE_WEB}/package-lock.json)
set(page_obstacle "COGSLAM_PAGE is OFF")
if(NOT COGSLAM_PAGE STREQUAL "OFF")
  cogslam_install_page_parts(page_obstacle)
endif()
set(COGSLAM_PAGE_PARTS "" CACHE INTERNAL "Folder of the parts of the page")
set(page_script "")
if(page_obstacle STREQUAL "")
  set(COGSLAM_PAGE_PARTS ${PAGE_BUILD} CACHE INTERNAL "")
  set(page_script ${PAGE_BUILD}/run.js ${PAGE_BUILD}/sweep.js ${PAGE_BUILD}/notices.txt)
  file(GLOB page_sources CONFIGURE_DEPENDS ${PAGE_WEB}/src/*)
  add_custom_command(OUTPUT ${page_script}
    COMMAND ${NODE} ${PAGE_WEB}/build.mjs ${PAGE_BUILD}
    DEPENDS ${page_sources} ${PAGE_WEB}/build.mjs ${PAGE_WEB}/package-lock.json COMMENT "Joining the pages' scripts" VERBATIM)
  message(STATUS "Page: with replay")
elseif(COGSLAM_PAGE STREQUAL "ON")
  message(FATAL_ERROR "Page: no replay: ${page_obstacle}")
elseif(COGSLAM_PAGE STREQUAL "OFF")
  message(STATUS "Page: static, since ${page_obstacle}")
else()
  message(WARNING "Page: the pages of runs will be static, without replay, since ${page_obstacle}")
endif()

set(COGSLAM_PAGE_SOURCE ${CMAKE_CURRENT_BINARY_DIR}/page_built_in.cpp)
add_custom_command(OUTPUT ${COGSLAM_PAGE_SOURCE}
  COMMAND ${CMAKE_COMMAND} -DOUT=${COGSLAM_PAGE_SOURCE} -DSTYLE=${PAGE_WEB}/page.css "-DSCRIPT=${page_script}"
    -P ${CMAKE_CURRENT_LIST_DIR}/embed_page.cmake
  DEPENDS ${PAGE_WEB}/page.css ${page_script} ${CMAKE_CURRENT_LIST_DIR}/embed_page.cmake
  COMMENT "Embedding the page" VERBATIM)
