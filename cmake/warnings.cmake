# Every target of ours compiles with these; third-party headers come in as system includes.
add_library(cogslam_options INTERFACE)
target_compile_features(cogslam_options INTERFACE cxx_std_20)
set(warnings -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-missing-field-initializers
  # GCC 12 warns of overlapping copies inside std::string where there are none (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${COGSLAM_WERROR}>:-Werror>)
target_compile_options(cogslam_options INTERFACE
  # Those who link the installed library choose their own warnings.
  "$<BUILD_INTERFACE:${warnings}>"
  # Scores must not depend on whether a CPU fuses multiply and add.
  -ffp-contract=off
  # A program names its own files, not where they were built.
  $<BUILD_INTERFACE:-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=>)
# Includes name our folders from the root, so the root of an installed tree is a folder of its own.
target_include_directories(cogslam_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/cogslam>)
