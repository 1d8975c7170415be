// Reads scenarios as lines of JSON, {"name": file name, "text": YAML, "set": [[key, value], ...]}, and answers each
// with a line: {"resolved": YAML} or {"error": message}. So a script can ask the readers thousands of questions a
// second.
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "eval/scenario.hpp"

int main() {
  using cogslam::ConfigSection;
  for (std::string line; std::getline(std::cin, line);) {
    const nlohmann::json question = nlohmann::json::parse(line);
    nlohmann::json answer;
    try {
      ConfigSection file = ConfigSection::parse(question.at("text"), question.at("name"));
      for (const auto& [key, value] : question.value("set", std::vector<std::pair<std::string, std::string>>{})) {
        file.override_value(key, value);
      }
      answer["resolved"] = cogslam::read_scenario(std::move(file), "scenario").resolved;
    } catch (const cogslam::InputError& error) {
      answer["error"] = error.what();
    }
    std::cout << answer.dump() << "\n";
  }
}
