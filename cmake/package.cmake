# `cpack -G DEB` makes two packages: cogslam (the program) and cogslam-dev (the library).
set(CPACK_PACKAGE_NAME cogslam)
set(CPACK_PACKAGE_VENDOR "cogslam")
set(CPACK_PACKAGE_CONTACT "cogslam maintainers <cogslam@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME cogslam)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Simulates a robot with LiDAR, compass and floor camera, estimates its path and
map with a particle filter that keeps its maps plain or compressed, and scores
each variant against the truth. The same filter runs on recorded robot logs.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS libosmesa6)  # loaded when a camera is rendered, so shlibdeps cannot see it

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME cogslam-dev)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "The library: headers, static libraries and the CMake package.
find_package(cogslam CONFIG) gives the target cogslam::cogslam.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "cogslam (= ${PROJECT_VERSION}), libeigen3-dev, libyaml-cpp-dev, zlib1g-dev,\
 libbox2d-dev, libopencv-core-dev, libopencv-imgproc-dev, libopencv-video-dev, libopencv-calib3d-dev, libceres-dev,\
 libpng-dev, nlohmann-json3-dev, libfmt-dev, liblz4-dev, libzstd-dev, libsqlite3-dev")
include(CPack)
