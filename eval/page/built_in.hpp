#pragma once

// Made by the build out of eval/page/web (cmake/page.cmake).

namespace cogslam {

extern const char* const kPageStyle;
extern const char* const kRunPageScript;    ///< empty where npm was absent
extern const char* const kSweepPageScript;  ///< empty where npm was absent
extern const char* const kPageNotices;      ///< of what is bundled in the scripts

}  // namespace cogslam
