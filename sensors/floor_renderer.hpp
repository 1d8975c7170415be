#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "worlds/floor_texture.hpp"

namespace cogslam {

/// Draws the floor with OSMesa (Mesa's llvmpipe, in memory, no display). libOSMesa is loaded when the first renderer is
/// made, never at program start: it brings LLVM (49 MB, 0.35 s), which a replay must not pay for.
///
/// Rendering runs on the calling thread (LP_NUM_THREADS=0 unless the environment says otherwise); pictures are the same
/// for any number of threads, but may differ by 1-3 grey values between CPUs without AVX and with it.
class FloorRenderer {
 public:
  /// Throws InputError where libOSMesa cannot be loaded or has no context of this size to give.
  FloorRenderer(const FloorTexture& texture, int width, int height);
  ~FloorRenderer();
  FloorRenderer(const FloorRenderer&) = delete;
  FloorRenderer& operator=(const FloorRenderer&) = delete;

  /// Floor points [m] in the map frame under the picture's corners: upper left, upper right, lower right, lower left.
  using Corners = std::array<Eigen::Vector2d, 4>;

  /// Fills `grey` (width x height, row 0 at the top). The floor is mip-mapped and filtered tri-linearly. A camera that
  /// looks straight down sees a plane by a similarity, so the corners say all there is to say about its pose.
  void render(const Corners& corners_map, std::span<std::uint8_t> grey);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace cogslam
