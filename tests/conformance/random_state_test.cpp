// 2,000 random lighting states. Those of a block share their two contexts, so that the library's
// caches and its change tracking are part of what is compared.
#include <gtest/gtest.h>

#include "conformance/random_state.hpp"
#include "conformance/render_pair.hpp"
#include "conformance/results.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {

namespace {

constexpr int block_size = 250;
constexpr int block_count = random_state_count / block_size;

struct Block {
  Dialect dialect;
  int first;
};

std::vector<Block> blocks(Dialect dialect) {
  std::vector<Block> result;
  for (int i = 0; i < block_count; ++i) result.push_back({dialect, i * block_size});
  return result;
}

std::string block_name(const testing::TestParamInfo<Block>& info) {
  return "random_state__" + std::to_string(info.param.first);
}

void PrintTo(const Block& block, std::ostream* out) {
  *out << dialect_name(block.dialect) << " states from " << block.first;
}

class RandomStates : public testing::TestWithParam<Block> {
 protected:
  void compare_states(PixelFormat format, int step, float tolerance_steps) {
    const auto [dialect, first] = GetParam();
    RenderPair& pair = render_pair(dialect, random_state_size, format);
    int images_written = 0;
    int covered = 0;
    for (int index = first; index < first + block_size; index += step) {
      const Image mesa = render(*pair.mesa, index);
      const Image ours = render(*pair.ours, index);
      covered += covered_pixels(mesa) > 0 ? 1 : 0;
      const Comparison comparison = compare(ours, mesa);
      const bool passed =
          comparison.max_difference() <= tolerance_steps && comparison.same_coverage();
      const std::string name = "state_" + std::to_string(index);
      record_result({dialect_name(dialect), "random_state_" + std::to_string(first), name, format,
                     "Mesa", comparison.max_difference(), comparison.differing_pixels, passed});
      if (passed) continue;
      // Five pictures show what is wrong; the summary names the rest.
      if (++images_written > 5) {
        ADD_FAILURE() << name << " " << format_name(format) << ": " << comparison.max_difference()
                      << "/255";
        continue;
      }
      EXPECT_TRUE(images_match(
          ours, mesa, {.max_difference_steps = tolerance_steps},
          std::string(dialect_name(dialect)) + "-" + name + "-" + format_name(format)));
    }
    EXPECT_EQ(covered, block_size / step) << "every state draws something";
  }

 private:
  static Image render(RenderContext& context, int index) {
    context.make_current();
    draw_random_state(context.gl, index);
    EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR}) << "state " << index;
    return context.read();
  }
};

// The tolerances are those of conformance_test.cpp, for the same reasons.
TEST_P(RandomStates, Rgba8WithinOneStep) { compare_states(PixelFormat::rgba8, 1, 1.0F); }

// One state of each structure's four values, and a few.
TEST_P(RandomStates, FloatColorsWithinFiftiethOfAStep) {
  compare_states(PixelFormat::rgba32f, 5, 0.02F);
}

INSTANTIATE_TEST_SUITE_P(core_330, RandomStates, testing::ValuesIn(blocks(Dialect::core_330)),
                         block_name);
INSTANTIATE_TEST_SUITE_P(es_300, RandomStates, testing::ValuesIn(blocks(Dialect::es_300)),
                         block_name);

}  // namespace

}  // namespace legacy_gl::test
