#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "sensors/readings.hpp"

namespace cogslam {

struct FlowConfig {
  int points = 100;               ///< corners looked for
  double corner_quality = 0.01;   ///< weakest corner kept, as a share of the strongest (Shi & Tomasi 1994)
  double corner_distance = 12;    ///< between two corners, at least [pixel]
  int window = 15;                ///< side of the square compared around a point [pixel]
  int levels = 3;                 ///< of the picture pyramid
  int iterations = 20;            ///< at most, on each level
  double min_texture = 0.0;       ///< points with less (see FlowPair) are not followed
  double step_tolerance = 0.003;  ///< [pixel] iterations end below this; larger ones leave motion unreported
};

/// A floor point in two pictures [pixel], in CameraModel's image frame.
struct FlowPair {
  Eigen::Vector2d before{0.0, 0.0};
  Eigen::Vector2d now{0.0, 0.0};
  /// What there is to hold on to: the smaller eigenvalue of the window's mean squared gradient [grey^2 / pixel^2].
  double texture = 0.0;
};

/// Smaller eigenvalue [grey^2 / pixel^2] that nothing but independent pixel noise of deviation `noise` [grey] gives on
/// average: the gradient is taken with Scharr's kernel, whose squared weights sum to 236 / 32^2.
double texture_of_noise(double noise);

/// Follows corners from a reference picture to later pictures by pyramidal Lucas-Kanade flow (Bouguet 2000, OpenCV).
/// The local mean is taken off every picture first, and with it vignette, shadows and changes of light.
class FlowTracker {
 public:
  explicit FlowTracker(const FlowConfig& config);
  ~FlowTracker();

  [[nodiscard]] bool has_reference() const;

  /// Makes `image` the reference, with new corners.
  void start(const FloorImage& image);

  /// Takes in the picture that is compared with the reference from now on.
  void look(const FloorImage& image);

  /// By how far the whole picture has moved since the reference [pixel], from the peak of the phase correlation (Kuglin
  /// & Hines 1975). Good to a pixel for any shift up to half the picture and turns of a few degrees; slow (1.5 ms).
  [[nodiscard]] Eigen::Vector2d shift() const;

  /// Where a point of the reference is expected now: the search starts there and reaches about 5 pixels.
  using Prediction = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

  /// The points of the reference that are found again. Pairs too near the border, where part of the window would be
  /// missing, are left out.
  [[nodiscard]] std::vector<FlowPair> track(const Prediction& predicted) const;

  /// How many points of the reference show enough texture to be followed.
  [[nodiscard]] int points() const;

  /// Makes the picture last looked at the reference. Its points are `points`, or new corners where these have become
  /// fewer than two thirds of the wanted number.
  void rebase(const std::vector<Eigen::Vector2d>& points);

 private:
  struct State;
  FlowConfig config_;
  std::unique_ptr<State> state_;
};

}  // namespace cogslam
