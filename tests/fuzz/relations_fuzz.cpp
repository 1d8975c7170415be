#include "eval/metrics/relations.hpp"

#include <cmath>

#include "tests/fuzz/fuzz_input.hpp"

// SLAM-benchmark relations, plain and gzipped, and their error on a short path.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cogslam;
  const MemoryFile file(text_of(data, size));
  read_or_complain([&] {
    const std::vector<Relation> relations = read_relations(file.path());
    const std::vector<Time> stamps{Time::from_seconds(1.0), Time::from_seconds(2.0), Time::from_seconds(1.5)};
    const std::vector<Pose2> path{{0, 0, 0}, {1, 0, 0}, {7, 1, 1}};
    const RelationErrors errors = relation_errors(relations, stamps, path, path);
    promise(errors.all.count + errors.unmatched == relations.size());
    promise(std::isfinite(errors.all.trans_std) && std::isfinite(errors.all.rot_std));
  });
  return 0;
}
