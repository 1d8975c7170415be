#include "slam/codec/dct.hpp"

#include <cmath>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "core/check.hpp"

namespace cogslam {

struct DctLines::Plan {
  using Complex = std::complex<double>;

  explicit Plan(std::size_t n)
      : turn(n), scale(n), in(n), out(n), fft(Eigen::default_fft_impl<double>(), Eigen::FFT<double>::Unscaled) {
    for (std::size_t k = 0; k < n; ++k) {
      const double angle = std::numbers::pi * static_cast<double>(k) / (2.0 * static_cast<double>(n));
      turn[k] = {std::cos(angle), std::sin(angle)};
      scale[k] = std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(n));
    }
    if (n > 1) {  // the first use makes the tables of a length
      fft.fwd(out.data(), in.data(), static_cast<Eigen::Index>(n));
      fft.inv(out.data(), in.data(), static_cast<Eigen::Index>(n));
    }
  }

  /// Even samples forwards, then odd ones backwards: the DCT of a line is the real part of the turned FFT of that.
  [[nodiscard]] std::size_t shuffled(std::size_t j) const { return j % 2 == 0 ? j / 2 : in.size() - 1 - j / 2; }

  void forward(const double* a, const double* b, double* to_a, double* to_b, std::size_t step);
  void inverse(const double* a, const double* b, double* to_a, double* to_b, std::size_t step);

  std::vector<Complex> turn;  ///< e^(i pi k / 2n)
  std::vector<double> scale;  ///< s_k
  std::vector<Complex> in, out;
  Eigen::FFT<double> fft;
};

void DctLines::Plan::forward(const double* a, const double* b, double* to_a, double* to_b, std::size_t step) {
  const std::size_t n = in.size();
  for (std::size_t j = 0; j < n; ++j) in[shuffled(j)] = {a[j * step], b[j * step]};
  fft.fwd(out.data(), in.data(), static_cast<Eigen::Index>(n));
  for (std::size_t k = 0; k < n; ++k) {
    // The spectra of the two real lines are the parts of Z that are symmetric and antisymmetric in k.
    const Complex z = out[k], mirror = out[k == 0 ? 0 : n - k];
    const double a_re = 0.5 * (z.real() + mirror.real()), a_im = 0.5 * (z.imag() - mirror.imag());
    const double b_re = 0.5 * (z.imag() + mirror.imag()), b_im = 0.5 * (mirror.real() - z.real());
    to_a[k * step] = scale[k] * (turn[k].real() * a_re + turn[k].imag() * a_im);
    to_b[k * step] = scale[k] * (turn[k].real() * b_re + turn[k].imag() * b_im);
  }
}

void DctLines::Plan::inverse(const double* a, const double* b, double* to_a, double* to_b, std::size_t step) {
  const std::size_t n = in.size();
  const double norm = 1.0 / static_cast<double>(n);
  for (std::size_t k = 0; k < n; ++k) {
    // V_k = e^(i pi k / 2n) (c_k - i c_(n-k)), c in the scale of the plain sums and c_n = 0.
    const double unscale = norm / scale[k];
    const std::size_t mirror = k == 0 ? 0 : n - k;
    const double a_re = a[k * step] * unscale, a_im = k == 0 ? 0.0 : -a[mirror * step] * unscale;
    const double b_re = b[k * step] * unscale, b_im = k == 0 ? 0.0 : -b[mirror * step] * unscale;
    const double re = a_re - b_im, im = a_im + b_re;  // of V_a + i V_b, before the turn
    in[k] = {turn[k].real() * re - turn[k].imag() * im, turn[k].real() * im + turn[k].imag() * re};
  }
  fft.inv(out.data(), in.data(), static_cast<Eigen::Index>(n));
  for (std::size_t j = 0; j < n; ++j) {
    to_a[j * step] = out[shuffled(j)].real();
    to_b[j * step] = out[shuffled(j)].imag();
  }
}

DctLines::DctLines(std::size_t length) : length_(length), plan_(std::make_unique<Plan>(length)) { EXPECTS(length > 0); }

DctLines::~DctLines() = default;
DctLines::DctLines(DctLines&&) noexcept = default;
DctLines& DctLines::operator=(DctLines&&) noexcept = default;

// Nothing in a plan but its length outlives a call.
DctLines::DctLines(const DctLines& other) : DctLines(other.length_) {}
DctLines& DctLines::operator=(const DctLines& other) { return *this = DctLines(other.length_); }

void DctLines::forward(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step) {
  for (std::size_t i = 0; i < count; i += 2) {
    const std::size_t a = i * line_step, b = (i + 1 < count ? i + 1 : i) * line_step;
    if (length_ == 1) {
      out[a] = in[a], out[b] = in[b];
    } else {
      plan_->forward(in + a, in + b, out + a, out + b, step);
    }
  }
}

void DctLines::inverse(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step) {
  for (std::size_t i = 0; i < count; i += 2) {
    const std::size_t a = i * line_step, b = (i + 1 < count ? i + 1 : i) * line_step;
    if (length_ == 1) {
      out[a] = in[a], out[b] = in[b];
    } else {
      plan_->inverse(in + a, in + b, out + a, out + b, step);
    }
  }
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
