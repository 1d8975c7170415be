#pragma once

#include "worlds/world.hpp"

namespace cogslam {

/// The floor that can be reached from the start of a world without crossing a surface. Decided by geometry, not on a
/// raster, so a gap of any width counts, and walls that do not quite close leak.
///
/// The plane is cut into vertical slabs at every corner and crossing of surfaces; within a slab, the surfaces are
/// stacked and bound one face between each two (slab decomposition, de Berg et al., Computational Geometry, ch. 6.1).
/// Faces of neighbouring slabs that share a piece of their common border, not covered by an upright surface, are
/// joined. Gaps and corners that differ by less than a nanometre are the same.
///
/// n surfaces cost O(n^2) to build at worst, far less where most lie apart along x, and O(log n) to ask. Loops may
/// touch, overlap and enclose each other. Throws InputError where surfaces would be cut into more than 10^7 pieces.
class FreeSpace {
 public:
  explicit FreeSpace(const World& world);

  /// Whether `p_map` [m] can be reached from the start. A point on a surface counts to either side.
  [[nodiscard]] bool contains(const Eigen::Vector2d& p_map) const { return face_of(p_map) == start_face_; }

  /// False where the start can reach infinity: the walls do not close, or the start lies outside.
  [[nodiscard]] bool is_closed() const { return start_face_ != outside_; }

 private:
  /// The surfaces that span one slab, from the lowest up, and the face above and below each.
  struct Slab {
    std::vector<Segment> surfaces;  ///< a.x < b.x
    std::vector<int> faces;         ///< one more than surfaces; faces[0] lies below all
  };

  /// Stacks the surfaces; gives back those that stand upright, by border.
  std::vector<std::vector<Segment>> fill_slabs(const std::vector<Segment>& surfaces);
  void join(const Slab& left, const Slab& right, double x, const std::vector<Segment>& upright);
  [[nodiscard]] int root(int face) const;
  [[nodiscard]] int face_of(const Eigen::Vector2d& p) const;

  std::vector<double> borders_;  ///< ascending; slab i ends at borders_[i], the last one never
  std::vector<Slab> slabs_;      ///< the first and the last hold no surface
  std::vector<int> parents_;     ///< union-find over faces; each names its root once all are joined
  int start_face_ = 0;
  int outside_ = 0;
};

}  // namespace cogslam
