#pragma once

#include <string>
#include <vector>

#include "eval/page/html.hpp"
#include "eval/run_folder.hpp"

namespace cogslam {

/// A picture of the page, a PNG file.
struct PagePicture {
  std::size_t variant = 0;  ///< that it shows
  bool map = false;         ///< of its map, else of its paths
  std::string png;
};

/// A page grows to this and no further, pictures apart: the player shows fewer moments of longer runs.
constexpr std::size_t kPlayerBytesMost = 8'000'000;

/// One run as a self-contained HTML document: scores with plain words, pictures, curves, and, where `parts` holds a
/// script, a player. Runs without a trace have neither curves nor player. Costs are left out: the same run has the same
/// page, byte for byte.
std::string run_page(const RunFiles& files, const std::vector<PagePicture>& pictures, const PageParts& parts,
                     std::size_t player_bytes_most = kPlayerBytesMost);

}  // namespace cogslam
