#include "tests/cli/broken_input.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace cogslam {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = COGSLAM_SOURCE_DIR "/tests/broken";

BrokenInput parse(const fs::path& file) {
  BrokenInput input{.name = (file.parent_path().filename() / file.stem()).string()};
  std::ifstream in(file);
  for (std::string line; std::getline(in, line) && !line.empty();) {
    const std::string key = line.substr(0, line.find(": ")), value = line.substr(std::min(line.size(), key.size() + 2));
    if (key == "run") {
      input.run = value;
    } else if (key == "make") {
      input.make = value;
    } else if (key == "as") {
      input.as = value;
    } else if (key == "exit") {
      input.exit = std::stoi(value);
    } else {
      throw std::runtime_error(file.string() + ": unknown key '" + key + "'");
    }
  }
  std::ostringstream rest;
  rest << in.rdbuf();
  input.message = rest.str();
  return input;
}

std::string repeated(std::string_view text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out.append(text);
  return out;
}

std::string many_keys() {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "k" + std::to_string(i) + ": 1\n";
  return text;
}

std::string room_of(const std::string& corners, const std::string& more) {
  return "drive: {waypoints: [{x_m: 1, y_m: 0}]}\nworld:\n  kind: polygons\n  walls:\n    - corners_m: [" + corners +
         "]\n" + more;
}

std::string many_corners() {
  std::string corners = "[0, 0]";
  for (int i = 0; i < 60000; ++i) corners += ", [" + std::to_string(i % 100) + ", 1]";
  return room_of(corners, "");
}

/// Upright and level slats that all cross each other.
std::string comb() {
  std::string slats = "  obstacles:\n";
  for (int i = 0; i < 2400; ++i) {
    const std::string at = std::to_string(-40.0 + i / 62.0), next = std::to_string(-39.99 + i / 62.0);
    slats += "    - corners_m: [[" + at + ", -45], [" + next + ", -45], [" + next + ", 45], [" + at + ", 45]]\n";
    slats += "    - corners_m: [[-45, " + at + "], [45, " + at + "], [45, " + next + "], [-45, " + next + "]]\n";
  }
  return room_of("[-50, -50], [50, -50], [50, 50], [-50, 50]", slats);
}

using Maker = std::function<void(const fs::path&)>;

Maker text(const std::function<std::string()>& content) {
  return [content](const fs::path& file) { std::ofstream(file, std::ios::binary) << content(); };
}

const std::map<std::string, Maker>& makers() {
  static const std::map<std::string, Maker> kMakers{
      {"nothing", [](const fs::path&) {}},
      {"folder", [](const fs::path& file) { fs::create_directory(file); }},
      {"symlink_loop", [](const fs::path& file) { fs::create_symlink(file, file); }},
      {"pipe", [](const fs::path& file) { mkfifo(file.c_str(), 0600); }},
      {"device", [](const fs::path& file) { fs::create_symlink("/dev/zero", file); }},
      {"unreadable",
       [](const fs::path& file) {
         std::ofstream(file) << "seed: 1\n";
         fs::permissions(file, fs::perms::none);
       }},
      {"keys", text(many_keys)},
      {"corners", text(many_corners)},
      {"comb", text(comb)},
      {"brackets", text([] { return repeated("[", 10000); })},
      {"megabytes", text([] { return repeated("# nothing to see here\n", 100000); })},
      {"long_line", text([] { return repeated("FLASER ", 300000); })},
      {"sparse_recording",
       [](const fs::path& file) {
         std::ofstream(file, std::ios::binary) << "COGSREAD" << std::string("\1\0\0\0", 4);
         fs::resize_file(file, std::uintmax_t{10} << 30);
       }},
  };
  return kMakers;
}

}  // namespace

std::vector<BrokenInput> broken_inputs() {
  std::vector<BrokenInput> inputs;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot)) {
    if (entry.path().extension() == ".expected") inputs.push_back(parse(entry.path()));
  }
  std::sort(inputs.begin(), inputs.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return inputs;
}

fs::path input_file(const BrokenInput& input, const fs::path& folder) {
  if (!input.make.empty()) {
    const fs::path file = folder / "broken";
    makers().at(input.make)(file);
    return file;
  }
  const fs::path stem = kRoot / input.name;
  for (const auto& entry : fs::directory_iterator(stem.parent_path())) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(stem.filename().string() + ".") && entry.path().extension() != ".expected")
      return entry.path();
  }
  throw std::runtime_error("no input beside " + stem.string() + ".expected");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace cogslam
