#include <gmock/gmock.h>

#include <functional>
#include <vector>

#include "slam/codec/byte_code.hpp"
#include "slam/codec/coarse_cells.hpp"
#include "slam/codec/context_code.hpp"
#include "slam/codec/nibble_code.hpp"
#include "slam/map/tile.hpp"
#include "tests/support/random_tile.hpp"

namespace cogslam {
namespace {

using Code = std::vector<std::uint8_t>;

/// One way to write a tile down.
struct Coder {
  const char* name;
  int lowest, highest;  ///< levels that it takes
  bool checks_itself;   ///< every code that is cut short is refused without a check sum
  std::function<Code(const TileCells&)> encode;
  std::function<bool(const Code&, TileCells&)> decode;
};

void PrintTo(const Coder& coder, std::ostream* out) { *out << coder.name; }

Code by_contexts(const TileCells& tile, bool nibbles) {
  ContextBuffer code;
  const auto size = encode_contexts(tile, nibbles, code);
  EXPECT_TRUE(size.has_value());
  return {code.data(), code.data() + size.value_or(0)};
}

const std::vector<Coder>& coders() {
  static const std::vector<Coder> all{
      {"nibbles", kNibbleLowest, kNibbleHighest, true,
       [](const TileCells& tile) {
         NibbleBuffer code;
         return Code(code.data(), code.data() + encode_nibbles(tile, code));
       },
       [](const Code& code, TileCells& tile) { return decode_nibbles(code, tile); }},
      {"bytes", -128, 127, true,
       [](const TileCells& tile) {
         ByteBuffer code;
         return Code(code.data(), code.data() + encode_bytes(tile, code));
       },
       [](const Code& code, TileCells& tile) { return decode_bytes(code, tile); }},
      {"contexts", kNibbleLowest, kNibbleHighest, false, [](const TileCells& tile) { return by_contexts(tile, true); },
       [](const Code& code, TileCells& tile) { return decode_contexts(code, true, tile); }},
  };
  return all;
}

class TileCode : public testing::TestWithParam<Coder> {
 protected:
  TileCells draw() { return random_tile(rng_, GetParam().lowest, GetParam().highest); }
  Rng rng_{{.seed = 11, .purpose = Purpose::kWorld}};
};

void expect_round_trip(const Coder& coder, const TileCells& tile) {
  const Code code = coder.encode(tile);
  TileCells back;
  back.levels.fill(99);
  ASSERT_TRUE(coder.decode(code, back));
  ASSERT_EQ(back, tile);
}

TEST_P(TileCode, GivesEveryTileBack) {
  for (int round = 0; round < 400; ++round) ASSERT_NO_FATAL_FAILURE(expect_round_trip(GetParam(), draw()));
}

TEST_P(TileCode, GivesRunsOfEveryLengthBack) {
  const auto high = static_cast<std::int8_t>(GetParam().highest), low = static_cast<std::int8_t>(GetParam().lowest);
  for (int length = 0; length <= kTileCells; ++length) {
    TileCells front, back;
    std::fill_n(front.levels.begin(), length, high);
    std::fill(back.levels.begin(), back.levels.end() - length, low);
    for (int i = 0; i < kTileCells - length; i += 5) back.levels[static_cast<std::size_t>(i)] = 0;
    ASSERT_NO_FATAL_FAILURE(expect_round_trip(GetParam(), front));
    ASSERT_NO_FATAL_FAILURE(expect_round_trip(GetParam(), back));
  }
}

TEST_P(TileCode, RefusesOrReadsCodesThatWereCutShort) {
  for (int round = 0; round < 12; ++round) {
    Code code = GetParam().encode(draw());
    while (!code.empty()) {
      const bool half_byte_of_padding = code.back() == 0;
      code.pop_back();
      TileCells back;
      const bool read = GetParam().decode(Code(code), back);
      EXPECT_FALSE(read && GetParam().checks_itself && !half_byte_of_padding);
    }
  }
}

TEST_P(TileCode, RefusesCodesThatGoOn) {
  Code code = GetParam().encode(draw());
  code.insert(code.end(), 5, 0);
  TileCells back;
  EXPECT_FALSE(GetParam().decode(code, back));
}

TEST_P(TileCode, SurvivesAnyBytes) {
  for (int round = 0; round < 2000; ++round) {
    Code code(rng_.below(300));
    for (std::uint8_t& byte : code) byte = static_cast<std::uint8_t>(rng_.below(256));
    TileCells back;
    GetParam().decode(code, back);
  }
}

INSTANTIATE_TEST_SUITE_P(All, TileCode, testing::ValuesIn(coders()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(NibbleCode, TakesNoMoreThanANibblePerCell) {
  Rng rng({.seed = 3, .purpose = Purpose::kWorld});
  for (int round = 0; round < 300; ++round) {
    NibbleBuffer code;
    EXPECT_LE(encode_nibbles(random_tile(rng, kNibbleLowest, kNibbleHighest), code), kNibbleCodeMax);
  }
}

TEST(NibbleCode, KnowsWhichTilesFit) {
  TileCells tile;
  EXPECT_TRUE(fits_nibbles(tile));
  for (const int at : {0, 15, 16, 500, 1023}) {
    for (int level = -128; level < 128; ++level) {
      tile.levels[static_cast<std::size_t>(at)] = static_cast<std::int8_t>(level);
      EXPECT_EQ(fits_nibbles(tile), level >= kNibbleLowest && level <= kNibbleHighest) << level;
    }
    tile.levels[static_cast<std::size_t>(at)] = 0;
  }
}

TEST(NibbleCode, WritesKnownTilesInFewBytes) {
  TileCells tile;  // all as the unknown row above the first
  NibbleBuffer code;
  EXPECT_EQ(encode_nibbles(tile, code), 3U);
  EXPECT_THAT((std::vector<int>{code[0], code[1], code[2]}), testing::ElementsAre(0xFE, 0x04, 0x00));
  tile.levels[33] = 8;
  EXPECT_EQ(encode_nibbles(tile, code), 6U);  // 33 as above, one cell, 31 as above, 959 as before
}

TEST(ContextCode, TakesWideLevelsInBytes) {
  Rng rng({.seed = 5, .purpose = Purpose::kWorld});
  for (int round = 0; round < 200; ++round) {
    const TileCells tile = random_tile(rng, -40, 64);
    ContextBuffer code;
    const auto size = encode_contexts(tile, false, code);
    if (!size) continue;  // noise
    TileCells back;
    ASSERT_TRUE(decode_contexts({code.data(), *size}, false, back));
    ASSERT_EQ(back, tile);
  }
}

TEST(ContextCode, SaysWhereATileTakesTooMuch) {
  Rng rng({.seed = 6, .purpose = Purpose::kWorld});
  TileCells noise;
  for (std::int8_t& level : noise.levels) level = static_cast<std::int8_t>(static_cast<int>(rng.below(256)) - 128);
  ContextBuffer code;
  EXPECT_EQ(encode_contexts(noise, false, code), std::nullopt);
}

TEST(ContextCode, IsDenserThanNibblesOnAWall) {
  Rng rng({.seed = 7, .purpose = Purpose::kWorld});
  const TileCells tile = noisy_wall(rng);
  NibbleBuffer code;
  EXPECT_LT(4 * by_contexts(tile, true).size(), 3 * encode_nibbles(tile, code));
}

TEST(ContextCensus, LearnsChancesThatFitWhatItHasSeen) {
  TileCells tile;
  tile.levels.fill(-5);
  ContextCensus census;
  for (int i = 0; i < 100; ++i) census.add(tile);
  const ContextModel model = census.model();
  constexpr std::size_t kFree = 1, kAllAlike = 63;
  EXPECT_EQ(model.as_above[kFree * 64 + kAllAlike], 65520);  // certain, as far as a chance goes
  EXPECT_EQ(model.as_above[kFree * 64], 32768);              // never seen
}

TEST(CoarseCells, TakeTheMeanOfTheirCells) {
  TileCells tile;
  for (const std::size_t i : {0U, 1U, 2U, 3U, 32U, 33U, 34U, 35U})
    tile.levels[i] = -1;  // half of the first coarse cell
  tile.levels[4] = -5;    // a sixteenth of the second
  tile.levels[1023] = 8;  // half a level for the last
  coarsen(tile);
  EXPECT_EQ(tile.levels[0], -1);
  EXPECT_EQ(tile.levels[99], -1);
  EXPECT_EQ(tile.levels[4], 0);
  EXPECT_EQ(tile.levels[1023 - 99], 1);
}

TEST(CoarseCells, GiveACoarsenedTileBack) {
  Rng rng({.seed = 12, .purpose = Purpose::kWorld});
  for (int round = 0; round < 200; ++round) {
    TileCells tile = random_tile(rng, kNibbleLowest, kNibbleHighest), back;
    coarsen(tile);
    const TileCells once = tile;
    coarsen(tile);
    ASSERT_EQ(tile, once);
    const auto code = encode_coarse(tile);
    ASSERT_TRUE(decode_coarse(code, back));
    ASSERT_EQ(back, tile);
    EXPECT_FALSE(decode_coarse(std::span(code).first(31), back));
  }
  const std::array<std::uint8_t, kCoarseCodeBytes> none{0, 0, 0xE0};
  TileCells back;
  EXPECT_FALSE(decode_coarse(none, back));
}

TEST(Tile, FindsEveryBitThatChanged) {
  Rng rng({.seed = 8, .purpose = Purpose::kWorld});
  int missed = 0;
  for (const Coder& coder : coders()) {
    for (int round = 0; round < 6; ++round) {
      Code code = coder.encode(random_tile(rng, coder.lowest, coder.highest));
      const std::uint16_t sum = check_sum(code);
      for (std::size_t bit = 0; bit < 8 * code.size(); ++bit) {
        code[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        TileCells back;
        coder.decode(code, back);
        missed += check_sum(code) == sum;
        code[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
      }
    }
  }
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace cogslam
