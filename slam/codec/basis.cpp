#include "slam/codec/basis.hpp"

#include <algorithm>
#include <array>

#include "core/check.hpp"

namespace cogslam {
namespace {

struct Named {
  std::string_view name;
  BasisKind kind;
};
constexpr std::array kNames{
    Named{"haar", BasisKind::kHaar},         Named{"haar_standard", BasisKind::kHaarStandard},
    Named{"haar_1d", BasisKind::kHaar1d},    Named{"dct", BasisKind::kDct},
    Named{"dct_1d", BasisKind::kDct1d},      Named{"hadamard", BasisKind::kHadamard},
    Named{"identity", BasisKind::kIdentity},
};

}  // namespace

std::string_view name_of(BasisKind kind) { return std::ranges::find(kNames, kind, &Named::kind)->name; }

std::optional<BasisKind> basis_kind(std::string_view name) {
  const auto found = std::ranges::find(kNames, name, &Named::name);
  return found == kNames.end() ? std::nullopt : std::optional(found->kind);
}

void IdentityBasis::forward(std::span<const double> values, std::span<double> coefficients) {
  EXPECTS(values.size() == length && coefficients.size() == length);
  std::copy(values.begin(), values.end(), coefficients.begin());
}

void IdentityBasis::inverse(std::span<const double> coefficients, std::span<double> values) {
  forward(coefficients, values);
}

Basis::Any Basis::make(BasisKind kind, int width, int height) {
  EXPECTS(width > 0 && height > 0);
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  switch (kind) {
    case BasisKind::kHaar:
      return HaarBasis(width, height);
    case BasisKind::kHaarStandard:
      return HaarStandardBasis(w, h);
    case BasisKind::kHaar1d:
      return Haar1dBasis(w * h);
    case BasisKind::kDct:
      return Dct2d(w, h);
    case BasisKind::kDct1d:
      return Dct1d(w * h);
    case BasisKind::kHadamard:
      return HadamardBasis(w, h);
    case BasisKind::kIdentity:
      break;
  }
  return IdentityBasis{w * h};
}

Basis::Basis(BasisKind kind, int width, int height)
    : kind_(kind),
      basis_(make(kind, width, height)),
      cells_(std::visit([](const auto& basis) { return basis.cells(); }, basis_)),
      size_(std::visit([](const auto& basis) { return basis.size(); }, basis_)) {}

void Basis::forward(std::span<const double> values, std::span<double> coefficients) {
  std::visit([&](auto& basis) { basis.forward(values, coefficients); }, basis_);
}

void Basis::inverse(std::span<const double> coefficients, std::span<double> values) {
  std::visit([&](auto& basis) { basis.inverse(coefficients, values); }, basis_);
}

}  // namespace cogslam
