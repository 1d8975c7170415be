#include "eval/report/world_svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "tests/support/temporary_folder.hpp"
#include "worlds/hallway.hpp"
#include "worlds/map_contours.hpp"
#include "worlds/rooms.hpp"
#include "worlds/world_map.hpp"

namespace cogslam {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Parses a drawing with Python's own XML reader, and says what it shows once printed, in metres of the world.
constexpr char kMeasure[] = R"(
import re, sys, xml.etree.ElementTree as tree
root = tree.parse(sys.argv[1]).getroot()
tag = '{http://www.w3.org/2000/svg}'
assert root.tag == tag + 'svg', root.tag
left, top, width, height = map(float, root.get('viewBox').split())
millimetres = [float(re.fullmatch(r'([0-9.]+)mm', root.get(side)).group(1)) for side in ('width', 'height')]
title = root.find(tag + 'title').text
scale = float(title.rsplit('1:', 1)[1])
points = []
for path in root.iter(tag + 'path'):
    if path.get('id') in ('walls', 'obstacles'):
        numbers = [float(n) for n in re.findall(r'-?[0-9.]+(?:e-?[0-9]+)?', path.get('d'))]
        points += list(zip(numbers[::2], numbers[1::2]))
inside = all(left <= x <= left + width and top <= -y <= top + height for x, y in points)
xs, ys = zip(*points)
print(len(points), min(xs), min(ys), max(xs), max(ys), millimetres[0] * scale / 1000 / width,
      millimetres[1] * scale / 1000 / height, int(inside), title)
)";

struct Measured {
  std::size_t corners = 0;
  double left = 0, low = 0, right = 0, high = 0, metre_x = 0, metre_y = 0;
  int inside = 0;
  std::string title;
};

Measured measure(const std::string& svg) {
  const TemporaryFolder folder;
  const std::string script = folder.file("measure.py", kMeasure), file = folder.file("world.svg", svg);
  const std::unique_ptr<FILE, int (*)(FILE*)> out(popen(("python3 " + script + " " + file).c_str(), "r"), pclose);
  Measured m;
  std::array<char, 200> title{};
  if (out == nullptr || std::fscanf(out.get(), "%zu %lf %lf %lf %lf %lf %lf %d %199[^\n]", &m.corners, &m.left, &m.low,
                                    &m.right, &m.high, &m.metre_x, &m.metre_y, &m.inside, title.data()) != 9) {
    ADD_FAILURE() << "the drawing cannot be read";
  }
  m.title = title.data();
  return m;
}

bool has_python() { return std::system("python3 -c 'import xml.etree' 2>/dev/null") == 0; }

TEST(WorldSvg, IsXmlThatShowsTheWorldToScale) {
  if (!has_python()) GTEST_SKIP() << "python3 is not installed";
  World from_map = map_contours(world_map(cluttered_room(), 0.1));
  from_map.start = cluttered_room().start;
  for (const World& world : {simple_room(), cluttered_room(), hallway(), from_map}) {
    for (const double scale : {50.0, 20.0, 333.0}) {
      const Measured drawn = measure(world_svg(world, "a <b> & c", scale));
      EXPECT_EQ(drawn.corners, world.segments().size());
      EXPECT_NEAR(drawn.left, world.bounds().min.x(), 1e-8);
      EXPECT_NEAR(drawn.low, world.bounds().min.y(), 1e-8);
      EXPECT_NEAR(drawn.right, world.bounds().max.x(), 1e-8);
      EXPECT_NEAR(drawn.high, world.bounds().max.y(), 1e-8);
      EXPECT_NEAR(drawn.metre_x, 1.0, 1e-8);
      EXPECT_NEAR(drawn.metre_y, 1.0, 1e-8);
      EXPECT_EQ(drawn.inside, 1);
      EXPECT_EQ(drawn.title, "a <b> & c, 1:" + std::to_string(static_cast<int>(scale)));
    }
  }
}

TEST(WorldSvg, FillsWhatIsSolid) {
  World room = simple_room();
  EXPECT_THAT(world_svg(room, "room"), HasSubstr(R"(id="walls" fill="none")"));
  EXPECT_THAT(world_svg(room, "room"), Not(HasSubstr("obstacles")));
  World map = map_contours(world_map(room, 0.1));
  map.start = room.start;
  EXPECT_THAT(world_svg(map, "map"), HasSubstr(R"(id="walls" fill="#c8c8c8" fill-rule="evenodd")"));
  room.slip_patches = {{{0.5, -0.25}, 0.3, 0.1}};
  room.start = {0.1, 0.2, radians(90.0)};
  EXPECT_THAT(world_svg(room, "room"), HasSubstr(R"(class="slip" cx="0.5" cy="-0.25" r="0.3")"));
  EXPECT_THAT(world_svg(room, "room"), HasSubstr(R"x(transform="translate(0.1 0.2) rotate(90)")x"));
}

}  // namespace
}  // namespace cogslam
