#include "eval/sense/path_correction.hpp"

#include <cmath>

#include "core/check.hpp"

namespace cogslam {

std::string PathCorrectionConfig::check() const {
  if (const std::string wrong = map.check(); !wrong.empty()) return wrong;
  if (samples < 1 || samples > map.cells()) {
    return "samples: expected 1 to " + std::to_string(map.cells()) + ", the cells of a partial map, found " +
           std::to_string(samples);
  }
  return offset.check();
}

std::vector<CorrectedLook> correct_path(std::span<const PathLook> looks, const PathCorrectionConfig& config,
                                        std::uint32_t seed) {
  EXPECTS(config.check().empty());
  EXPECTS(!looks.empty());
  OffsetChain chain(config.offset, looks.front().T_map_base);
  std::vector<CorrectedLook> corrected;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    CorrectedLook look;
    look.map = recover_from_samples(partial_map(config.map, looks[i].scan), config.samples, seed,
                                    static_cast<std::uint32_t>(i));
    const Pose2 moved = i == 0 ? Pose2{} : looks[i - 1].T_odom_base.inverse() * looks[i].T_odom_base;
    look.offset = chain.push(look.map, moved);
    look.T_map_base = chain.pose();
    corrected.push_back(std::move(look));
  }
  return corrected;
}

PathDeviation path_deviation(std::span<const PathLook> looks, std::span<const Pose2> T_map_base) {
  EXPECTS(!looks.empty() && looks.size() == T_map_base.size());
  PathDeviation squares;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const Pose2 T_corridor_map = Pose2{0.0, 0.0, looks[i].corridor_heading}.inverse();
    const Eigen::Vector2d error = T_corridor_map * (T_map_base[i].position() - looks[i].T_map_base.position());
    const double turn = angle_difference(T_map_base[i].theta, looks[i].T_map_base.theta);
    squares.heading += turn * turn;
    squares.across += error.y() * error.y();
    squares.along += error.x() * error.x();
  }
  const auto n = static_cast<double>(looks.size());
  return {std::sqrt(squares.heading / n), std::sqrt(squares.across / n), std::sqrt(squares.along / n)};
}

}  // namespace cogslam
