#include "eval/sweep/episode_result.hpp"

#include <nlohmann/json.hpp>

namespace cogslam {

std::string to_json(const EpisodeResult& result) {
  using Json = nlohmann::ordered_json;
  const Json json{{"schema", 1},
                  {"key", result.key},
                  {"readings_key", result.readings_key},
                  {"baseline", result.baseline.empty() ? Json(nullptr) : Json(result.baseline)},
                  {"true_poses", result.true_poses},
                  {"program", result.program},
                  {"run", Json::parse(to_json(result.run))}};
  return json.dump(2) + "\n";
}

}  // namespace cogslam
