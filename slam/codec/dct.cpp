#include "slam/codec/dct.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.hpp"

namespace cogslam {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t kBlock = 8;  // lines that are gathered at once: doubles in a cache line

// Spelled out: the operator of std::complex also looks after infinities, which takes longer than the product.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

Complex unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace

DctLines::DctLines(std::size_t length) : length_(length), fft_(length), in_(length), out_(length) {
  const auto n = static_cast<double>(length);
  for (std::size_t k = 0; 2 * k <= length; ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k) / (2.0 * n);
    turn_.push_back(unit(angle) / std::sqrt(2.0 * n));
    half_turn_.push_back(unit(-4.0 * angle));
  }
  if (length % 2 == 0) half_.emplace(length / 2);
}

// Below, v is a line with its even samples forwards, then its odd ones backwards, and V its spectrum: c_k and c_(n-k)
// are the real part and minus the imaginary part of e^(-i pi k / 2n) V_k, but for their scale.

void DctLines::forward_pair(const double* a, const double* b, double* to_a, double* to_b) {
  const std::size_t n = length();
  for (std::size_t j = 0; j < n; j += 2) in_[j / 2] = {a[j], b[j]};
  for (std::size_t j = 1; j < n; j += 2) in_[n - 1 - j / 2] = {a[j], b[j]};
  fft_.forward(in_, out_);
  to_a[0] = std::numbers::sqrt2 * turn_[0].real() * out_[0].real();
  to_b[0] = std::numbers::sqrt2 * turn_[0].real() * out_[0].imag();
  for (std::size_t k = 1; 2 * k <= n; ++k) {
    // The spectra of the two real lines are the parts of Z that are symmetric and antisymmetric in k.
    const Complex z = out_[k], mirror = out_[n - k], turn = turn_[k];
    const double a_re = z.real() + mirror.real(), a_im = z.imag() - mirror.imag();
    const double b_re = z.imag() + mirror.imag(), b_im = mirror.real() - z.real();
    to_a[k] = turn.real() * a_re + turn.imag() * a_im;
    to_b[k] = turn.real() * b_re + turn.imag() * b_im;
    to_a[n - k] = turn.imag() * a_re - turn.real() * a_im;
    to_b[n - k] = turn.imag() * b_re - turn.real() * b_im;
  }
}

void DctLines::inverse_pair(const double* a, const double* b, double* to_a, double* to_b) {
  const std::size_t n = length();
  // Z = V_a + i V_b, conjugated, so that the forward transform is the inverse one.
  const double first = std::numbers::sqrt2 * turn_[0].real();
  in_[0] = {first * a[0], -first * b[0]};
  for (std::size_t k = 1; 2 * k <= n; ++k) {
    const Complex v_a = product(turn_[k], {a[k], -a[n - k]}), v_b = product(turn_[k], {b[k], -b[n - k]});
    in_[k] = {v_a.real() - v_b.imag(), -v_a.imag() - v_b.real()};
    in_[n - k] = {v_a.real() + v_b.imag(), v_a.imag() - v_b.real()};
  }
  fft_.forward(in_, out_);
  for (std::size_t j = 0; j < n; ++j) {
    const Complex v = out_[j % 2 == 0 ? j / 2 : n - 1 - j / 2];
    to_a[j] = v.real();
    to_b[j] = -v.imag();
  }
}

/// The even and odd samples of v as the parts of complex ones: V is put together from the halves of their spectrum.
void DctLines::forward_one(const double* in, double* out) {
  const std::size_t n = length(), h = n / 2;
  const auto v = [&](std::size_t j) { return j < h ? in[2 * j] : in[2 * (n - 1 - j) + 1]; };
  for (std::size_t j = 0; j < h; ++j) in_[j] = {v(2 * j), v(2 * j + 1)};
  half_->forward({in_.data(), h}, {out_.data(), h});
  const Complex first = out_[0];
  out[0] = std::numbers::sqrt2 * turn_[0].real() * (first.real() + first.imag());
  out[h] = 2.0 * turn_[h].real() * (first.real() - first.imag());
  for (std::size_t k = 1; k < h; ++k) {
    const Complex z = out_[k], mirror = std::conj(out_[h - k]);
    const Complex odd = product(half_turn_[k], z - mirror);  // 2i w_k times the spectrum of the odd samples
    const Complex w = product(std::conj(turn_[k]), z + mirror + Complex(odd.imag(), -odd.real()));
    out[k] = w.real();
    out[n - k] = -w.imag();
  }
}

void DctLines::inverse_one(const double* in, double* out) {
  const std::size_t n = length(), h = n / 2;
  const auto V = [&](std::size_t k) { return product(turn_[k], {in[k], -in[n - k]}); };
  const double first = std::numbers::sqrt2 * turn_[0].real() * in[0], middle = 2.0 * turn_[h].real() * in[h];
  in_[0] = {first + middle, middle - first};
  for (std::size_t k = 1; k < h; ++k) {
    const Complex here = V(k), mirror = std::conj(V(h - k));
    const Complex odd = product(std::conj(half_turn_[k]), here - mirror);
    // Conjugated, so that the forward transform is the inverse one.
    in_[k] = std::conj(here + mirror + Complex(-odd.imag(), odd.real()));
  }
  half_->forward({in_.data(), h}, {out_.data(), h});
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t i = j % 2 == 0 ? j / 2 : n - 1 - j / 2;
    out[j] = i % 2 == 0 ? out_[i / 2].real() : -out_[i / 2].imag();
  }
}

void DctLines::whole_lines(Pair pair, One one, const double* in, double* out, std::size_t count,
                           std::size_t line_step) {
  std::size_t i = 0;
  for (; i + 1 < count; i += 2) {
    const std::size_t a = i * line_step, b = a + line_step;
    (this->*pair)(in + a, in + b, out + a, out + b);
  }
  if (i == count) return;
  const std::size_t last = i * line_step;
  if (half_) {
    (this->*one)(in + last, out + last);
  } else {
    (this->*pair)(in + last, in + last, out + last, out + last);
  }
}

/// Lines that are not whole are gathered, some next to each other at a time: a walk down one column of an image meets
/// a new cache line at each step.
void DctLines::all_lines(Pair pair, One one, const double* in, double* out, std::size_t count, std::size_t line_step,
                         std::size_t step) {
  if (step == 1) return whole_lines(pair, one, in, out, count, line_step);
  const std::size_t n = length();
  block_.resize(kBlock * n);
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const std::size_t lines = std::min(kBlock, count - begin), offset = begin * line_step;
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < lines; ++i) block_[i * n + j] = in[offset + i * line_step + j * step];
    }
    whole_lines(pair, one, block_.data(), block_.data(), lines, n);
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < lines; ++i) out[offset + i * line_step + j * step] = block_[i * n + j];
    }
  }
}

void DctLines::forward(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step) {
  all_lines(&DctLines::forward_pair, &DctLines::forward_one, in, out, count, line_step, step);
}

void DctLines::inverse(const double* in, double* out, std::size_t count, std::size_t line_step, std::size_t step) {
  all_lines(&DctLines::inverse_pair, &DctLines::inverse_one, in, out, count, line_step, step);
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
