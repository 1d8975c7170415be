#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

#include "eval/report/canvas.hpp"

namespace cogslam {

enum class TextAnchor { kLeft, kMiddle, kRight };

inline constexpr int kLetterWidth = 12;   ///< room for one letter of a chart [pixels]
inline constexpr int kLetterHeight = 16;  ///< [pixels]

/// What a chart is drawn with: one for each kind of file. Pixels, x to the right, y downwards.
class ChartPen {
 public:
  virtual ~ChartPen() = default;
  virtual void line(std::span<const Eigen::Vector2d> points, double width, Colour colour) = 0;
  virtual void polygon(std::span<const Eigen::Vector2d> corners, Colour colour) = 0;
  /// The pale area between two lines over the same x, ascending.
  virtual void band(std::span<const Eigen::Vector2d> low, std::span<const Eigen::Vector2d> high, Colour colour) = 0;
  virtual void rectangle(double x, double y, double width, double height, Colour colour) = 0;
  /// `y` is the top of the letters.
  virtual void text(double x, double y, std::string_view text, TextAnchor anchor) = 0;
  /// Everything drawn so far, as the content of a file.
  virtual std::string bytes() = 0;
};

/// Scalable vector graphics; text stays text.
class SvgPen : public ChartPen {
 public:
  SvgPen(int width, int height);
  void line(std::span<const Eigen::Vector2d> points, double width, Colour colour) override;
  void polygon(std::span<const Eigen::Vector2d> corners, Colour colour) override;
  void band(std::span<const Eigen::Vector2d> low, std::span<const Eigen::Vector2d> high, Colour colour) override;
  void rectangle(double x, double y, double width, double height, Colour colour) override;
  void text(double x, double y, std::string_view text, TextAnchor anchor) override;
  std::string bytes() override { return svg_ + "</svg>\n"; }

 private:
  std::string svg_;
};

class PngPen : public ChartPen {
 public:
  PngPen(int width, int height);
  void line(std::span<const Eigen::Vector2d> points, double width, Colour colour) override;
  void polygon(std::span<const Eigen::Vector2d> corners, Colour colour) override;
  void band(std::span<const Eigen::Vector2d> low, std::span<const Eigen::Vector2d> high, Colour colour) override;
  void rectangle(double x, double y, double width, double height, Colour colour) override;
  void text(double x, double y, std::string_view text, TextAnchor anchor) override;
  std::string bytes() override;

 private:
  Canvas canvas_;
};

}  // namespace cogslam
