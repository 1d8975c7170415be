#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cogslam {

struct Moments {
  double count = 0.0;
  double mean = 0.0;
  double variance = 0.0;
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
};

inline Moments moments(const std::vector<double>& values) {
  Moments m;
  m.count = static_cast<double>(values.size());
  for (const double v : values) {
    m.mean += v / m.count;
    m.min = std::min(m.min, v);
    m.max = std::max(m.max, v);
  }
  for (const double v : values) m.variance += (v - m.mean) * (v - m.mean) / (m.count - 1.0);
  return m;
}

/// Pearson's correlation of two lists of one length.
inline double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const Moments ma = moments(a), mb = moments(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - ma.mean) * (b[i] - mb.mean);
  return sum / (ma.count - 1.0) / std::sqrt(ma.variance * mb.variance);
}

inline std::vector<double> flatten(const std::vector<std::vector<double>>& rows) {
  std::vector<double> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  return all;
}

}  // namespace cogslam
