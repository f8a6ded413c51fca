// Names that are in use are not given again, and what a name costs does not grow with their number.
#include "state/free_names.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace legacy_gl {
namespace {

GLuint take(FreeNames& names, GLuint count) {
  const GLuint first = names.find(count);
  if (first) names.take(first, count);
  return first;
}

TEST(FreeNames, SmallNamesComeFirst) {
  FreeNames names;
  EXPECT_EQ(take(names, 1), 1u);
  EXPECT_EQ(take(names, 3), 2u);
  names.release(2, 1);
  EXPECT_EQ(take(names, 1), 2u);
  EXPECT_EQ(take(names, 1), 5u);
}

TEST(FreeNames, GapsThatAreTooSmallArePassedOver) {
  FreeNames names;
  EXPECT_EQ(take(names, 10), 1u);
  names.release(3, 2);
  EXPECT_EQ(take(names, 3), 11u);
  EXPECT_EQ(take(names, 2), 3u);
}

TEST(FreeNames, AllNamesAtOnce) {
  FreeNames names;
  EXPECT_EQ(take(names, 0xffffffffu), 1u);
  EXPECT_EQ(take(names, 1), 0u);
  names.release(0xffffffffu, 1);
  EXPECT_EQ(take(names, 2), 0u);
  EXPECT_EQ(take(names, 1), 0xffffffffu);
}

TEST(FreeNames, TheLastNameAndTheGapBeforeIt) {
  FreeNames names;
  names.use(0xffffffffu);
  names.use(0xffffffffu);
  names.use(0);
  EXPECT_EQ(take(names, 0xffffffffu), 0u);
  EXPECT_EQ(take(names, 0xfffffffeu), 1u);
}

// Against a set of the names in use.
TEST(FreeNames, RandomCalls) {
  std::mt19937 random(7);
  FreeNames names;
  std::set<GLuint> used;
  for (int call = 0; call < 20000; ++call) {
    const auto name = static_cast<GLuint>(random() % 200 + 1);
    const auto count = static_cast<GLuint>(random() % 5 + 1);
    switch (random() % 3) {
      case 0: {
        const GLuint first = take(names, count);
        ASSERT_NE(first, 0u);
        for (GLuint i = 0; i < count; ++i) ASSERT_TRUE(used.insert(first + i).second);
        break;
      }
      case 1:
        names.use(name);
        used.insert(name);
        break;
      default:
        if (used.erase(name)) names.release(name, 1);
    }
  }
}

}  // namespace
}  // namespace legacy_gl
