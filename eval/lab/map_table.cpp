#include "eval/lab/map_table.hpp"

#include <fmt/format.h>

#include "eval/lab/yardstick.hpp"

namespace cogslam {
namespace {

std::string count(const std::optional<std::size_t>& value) { return value ? fmt::format("{}", *value) : "-"; }

}  // namespace

std::string map_csv(const std::vector<MapScore>& scores) {
  std::string text =
      "basis,compressor,recovery,percent,m,mse_log_odds,mse_probability,converged,bytes_u32,bytes_u16,bytes_bitmap,"
      "not_valid\n";
  for (const MapScore& s : scores) {
    text += fmt::format("{},{},{},{},", s.basis, s.compressor, s.recovery, s.percent);
    if (s.not_valid) {
      text += fmt::format(",,,,,,,\"{}\"\n", *s.not_valid);
      continue;
    }
    text += fmt::format("{},{},{},{},{},{},{},\n", s.m, s.mse_log_odds, s.mse_probability, s.converged ? 1 : 0,
                        count(s.bytes_u32), count(s.bytes_u16), count(s.bytes_bitmap));
  }
  return text;
}

std::string map_table(const std::vector<MapScore>& scores) {
  std::string text = fmt::format("{:<14}{:<11}{:<18}{:>6}{:>7}{:>12}{:>12}{:>9}{:>9}{:>9}{:>12}{:>12}\n", "basis",
                                 "compressor", "recovery", "%", "m", "MSE l-odds", "MSE prob", "B u32", "B u16",
                                 "B bitmap", "compress ms", "recover ms");
  for (const MapScore& s : scores) {
    text += fmt::format("{:<14}{:<11}{:<18}{:>6}", s.basis, s.compressor, s.recovery, s.percent);
    if (s.not_valid) {
      text += fmt::format("  not valid: {}\n", *s.not_valid);
      continue;
    }
    text += fmt::format("{:>7}{:>12.4g}{:>12.4g}{:>9}{:>9}{:>9}{:>12.3f}{:>12.3f}{}\n", s.m, s.mse_log_odds,
                        s.mse_probability, count(s.bytes_u32), count(s.bytes_u16), count(s.bytes_bitmap), s.compress_ms,
                        s.recover_ms, s.converged ? "" : "  not converged");
  }
  return text;
}

std::string yardstick_table(const Grid<float>& map) {
  std::string text =
      fmt::format("{:<14}{:>10}{:>15}{:>14}{:>12}\n", "yardstick", "bytes", "bits per cell", "MSE l-odds", "MSE prob");
  const auto cells = static_cast<double>(map.frame().size());
  for (const Yardstick yardstick : kYardsticks) {
    const std::string bytes = encode_map(yardstick, map);
    const MapMse mse = map_mse(map, decode_map(yardstick, bytes, map.frame()));
    text += fmt::format("{:<14}{:>10}{:>15.3f}{:>14.4g}{:>12.4g}\n", name_of(yardstick), bytes.size(),
                        8.0 * static_cast<double>(bytes.size()) / cells, mse.log_odds, mse.probability);
  }
  return text;
}

}  // namespace cogslam
