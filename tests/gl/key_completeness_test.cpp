// Any state change that changes the picture reaches the key, a uniform block or the driver's state:
// a context that drew after every change ends with the picture of one that drew only once.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scene_changes.hpp"
#include "support/contexts.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {
namespace {

using Order = std::vector<std::size_t>;

Image draw_at_the_end(const Order& order) {
  CoreContext context(64, 64);
  set_up_scene(context.gl);
  for (const std::size_t i : order) scene_changes()[i].apply(context.gl);
  draw_scene(context.gl);
  return context.read_rgba8();
}

std::string words(const Order& order) {
  std::string text;
  for (const std::size_t i : order) text += scene_changes()[i].name + "; ";
  return text;
}

TEST(KeyCompleteness, DrawingBetweenChangesAltersNothing) {
  std::mt19937 random(11);
  for (int round = 0; round < 12; ++round) {
    Order order(scene_changes().size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    if (round) std::shuffle(order.begin(), order.end(), random);
    CoreContext context(64, 64);
    set_up_scene(context.gl);
    draw_scene(context.gl);
    Order so_far;
    for (const std::size_t i : order) {
      scene_changes()[i].apply(context.gl);
      so_far.push_back(i);
      draw_scene(context.gl);
      if (so_far.size() % 10 == 0 || so_far.size() == order.size()) {
        const Image drawn_often = context.read_rgba8();
        const Image drawn_once = draw_at_the_end(so_far);
        context.make_current();
        ASSERT_EQ(drawn_often.bytes, drawn_once.bytes) << words(so_far);
      }
    }
    ASSERT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
  }
}

}  // namespace
}  // namespace legacy_gl::test
