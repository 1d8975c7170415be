#include "slam/codec/dct.hpp"

#include <cmath>
#include <numbers>

#include "core/check.hpp"

namespace cogslam {

struct DctLines::Pair {
  const double* a;
  const double* b;
  double* to_a;
  double* to_b;

  /// Lines i and i + 1 of `count`; the last of an odd number stands for both.
  Pair(const double* in, double* out, std::size_t i, std::size_t count, std::size_t line_step)
      : a(in + i * line_step),
        b(in + (i + 1 < count ? i + 1 : i) * line_step),
        to_a(out + (a - in)),
        to_b(out + (b - in)) {}
};

DctLines::DctLines(std::size_t length) : fft_(length), turn_(length), scale_(length), in_(length), out_(length) {
  const auto n = static_cast<double>(length);
  for (std::size_t k = 0; k < length; ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k) / (2.0 * n);
    turn_[k] = {std::cos(angle), std::sin(angle)};
    scale_[k] = std::sqrt((k == 0 ? 1.0 : 2.0) / n);
  }
}

/// Even samples forwards, then odd ones backwards: the DCT of a line is the real part of the turned FFT of that.
std::size_t DctLines::shuffled(std::size_t j) const { return j % 2 == 0 ? j / 2 : length() - 1 - j / 2; }

void DctLines::forward(const Pair& pair, std::size_t step) {
  const std::size_t n = length();
  for (std::size_t j = 0; j < n; ++j) in_[shuffled(j)] = {pair.a[j * step], pair.b[j * step]};
  fft_.forward(in_, out_);
  for (std::size_t k = 0; k < n; ++k) {
    // The spectra of the two real lines are the parts of Z that are symmetric and antisymmetric in k.
    const std::complex<double> z = out_[k], mirror = out_[k == 0 ? 0 : n - k], turn = turn_[k];
    const double a_re = 0.5 * (z.real() + mirror.real()), a_im = 0.5 * (z.imag() - mirror.imag());
    const double b_re = 0.5 * (z.imag() + mirror.imag()), b_im = 0.5 * (mirror.real() - z.real());
    pair.to_a[k * step] = scale_[k] * (turn.real() * a_re + turn.imag() * a_im);
    pair.to_b[k * step] = scale_[k] * (turn.real() * b_re + turn.imag() * b_im);
  }
}

void DctLines::inverse(const Pair& pair, std::size_t step) {
  const std::size_t n = length();
  for (std::size_t k = 0; k < n; ++k) {
    // V_k = e^(i pi k / 2n) (c_k - i c_(n-k)), c in the scale of the plain sums and c_n = 0.
    const double unscale = 1.0 / (scale_[k] * static_cast<double>(n));
    const std::size_t mirror = k == 0 ? 0 : n - k;
    const double a_re = pair.a[k * step] * unscale, a_im = k == 0 ? 0.0 : -pair.a[mirror * step] * unscale;
    const double b_re = pair.b[k * step] * unscale, b_im = k == 0 ? 0.0 : -pair.b[mirror * step] * unscale;
    const double re = a_re - b_im, im = a_im + b_re;  // of V_a + i V_b, before the turn
    const std::complex<double> turn = turn_[k];
    // Conjugated, so that the forward transform is the inverse one.
    in_[k] = {turn.real() * re - turn.imag() * im, -(turn.real() * im + turn.imag() * re)};
  }
  fft_.forward(in_, out_);
  for (std::size_t j = 0; j < n; ++j) {
    pair.to_a[j * step] = out_[shuffled(j)].real();
    pair.to_b[j * step] = -out_[shuffled(j)].imag();
  }
}

void DctLines::forward(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step) {
  for (std::size_t i = 0; i < count; i += 2) forward(Pair(in, out, i, count, line_step), step);
}

void DctLines::inverse(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step) {
  for (std::size_t i = 0; i < count; i += 2) inverse(Pair(in, out, i, count, line_step), step);
}

void Dct1d::forward(std::span<const double> values, std::span<double> coefficients) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  lines_.forward(values.data(), coefficients.data(), 1, 0, 1);
}

void Dct1d::inverse(std::span<const double> coefficients, std::span<double> values) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  lines_.inverse(coefficients.data(), values.data(), 1, 0, 1);
}

void Dct2d::forward(std::span<const double> values, std::span<double> coefficients) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  const std::size_t width = along_x_.length(), height = along_y_.length();
  along_x_.forward(values.data(), coefficients.data(), height, width, 1);
  along_y_.forward(coefficients.data(), coefficients.data(), width, 1, width);
}

void Dct2d::inverse(std::span<const double> coefficients, std::span<double> values) {
  EXPECTS(values.size() == cells() && coefficients.size() == size());
  const std::size_t width = along_x_.length(), height = along_y_.length();
  along_x_.inverse(coefficients.data(), values.data(), height, width, 1);
  along_y_.inverse(values.data(), values.data(), width, 1, width);
}

}  // namespace cogslam
