# What `cmake --install` lays down: the program with its papers, and the library for find_package(cogslam CONFIG).
include(CMakePackageConfigHelpers)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/cogslam)
set_target_properties(cogslam_library PROPERTIES EXPORT_NAME cogslam)
set_target_properties(cogslam_options PROPERTIES EXPORT_NAME options)

# The program.
install(TARGETS cogslam RUNTIME COMPONENT program)
install(DIRECTORY scenarios DESTINATION ${CMAKE_INSTALL_DATADIR}/cogslam COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES README.md CONTRIBUTING.md CHANGELOG.md LICENSE ${PROJECT_BINARY_DIR}/generated/changelog.gz
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program RENAME copyright)
if(COGSLAM_PAGE_PARTS)  # of what is bundled in the program for its pages
  install(FILES ${COGSLAM_PAGE_PARTS}/notices.txt DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
    RENAME copyright_of_page_parts)
endif()
set(generated ${PROJECT_BINARY_DIR}/generated)
install(FILES ${generated}/cogslam.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${generated}/bash/cogslam DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  COMPONENT program)
install(FILES ${generated}/zsh/cogslam DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program
  RENAME _cogslam)
install(FILES ${generated}/fish/cogslam DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
  COMPONENT program RENAME cogslam.fish)

# The library: headers under include/cogslam, since they include each other from the root.
install(TARGETS cogslam_library cogslam_options cogslam_core cogslam_worlds cogslam_sim cogslam_sensors cogslam_slam
    cogslam_odometry cogslam_mobile_sensing cogslam_eval
  EXPORT cogslamTargets
  ARCHIVE COMPONENT library)
foreach(layer core worlds sim sensors slam eval)
  install(DIRECTORY ${layer} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cogslam COMPONENT library
    FILES_MATCHING PATTERN *.hpp PATTERN web EXCLUDE)
endforeach()
install(EXPORT cogslamTargets NAMESPACE cogslam:: DESTINATION ${config_dir} COMPONENT library)
configure_package_config_file(cmake/cogslamConfig.cmake.in ${PROJECT_BINARY_DIR}/cogslamConfig.cmake
  INSTALL_DESTINATION ${config_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cogslamConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/cogslamConfig.cmake ${PROJECT_BINARY_DIR}/cogslamConfigVersion.cmake
  cmake/FindOpenCV.cmake DESTINATION ${config_dir} COMPONENT library)
