# Every target of ours compiles with these; third-party headers come in as system includes.
add_library(cogslam_options INTERFACE)
target_compile_features(cogslam_options INTERFACE cxx_std_20)
target_compile_options(cogslam_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-missing-field-initializers
  # GCC 12 warns of overlapping copies inside std::string where there are none (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${COGSLAM_WERROR}>:-Werror>
  # Scores must not depend on whether a CPU fuses multiply and add.
  -ffp-contract=off
  # A program names its own files, not where they were built.
  -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)
target_include_directories(cogslam_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/cogslam>)
