# Debian 12 packages, each with one home (docs/architecture.md). Everything here is found, nothing is fetched.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(yaml-cpp REQUIRED)                # core/config
find_package(ZLIB REQUIRED)                    # core/text_file: logs come gzipped
find_package(box2d REQUIRED)                   # sim
find_library(OSMESA_LIBRARY OSMesa REQUIRED)   # sensors/floor_camera
find_package(OpenCV REQUIRED COMPONENTS core imgproc video calib3d)  # slam/odometry
find_package(Ceres REQUIRED)                   # slam/odometry, slam/match
find_package(PNG REQUIRED)                     # eval/report
find_package(nlohmann_json REQUIRED)           # eval
find_package(SQLite3 REQUIRED)                  # eval/sweep
find_library(LZ4_LIBRARY lz4 REQUIRED)         # eval/lab
find_library(ZSTD_LIBRARY zstd REQUIRED)       # eval/lab
find_package(fmt REQUIRED)                     # eval, cli
find_package(CLI11 REQUIRED)                   # cli
if(COGSLAM_TESTS)
  find_package(GTest REQUIRED)
endif()
if(COGSLAM_BENCH)
  find_package(benchmark REQUIRED)
endif()
