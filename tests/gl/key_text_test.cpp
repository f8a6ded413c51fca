// Keys as text: each comes back as it was, and what is no key is refused.
#include "shadergen/key_text.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "shadergen/general.hpp"
#include "shadergen/generate.hpp"
#include "support/random_keys.hpp"

namespace legacy_gl::test {
namespace {

TEST(KeyText, GivesTheKeyBack) {
  RandomKeys keys(11);
  std::set<std::string> texts;
  std::set<std::string> described;
  for (int i = 0; i < 5000; ++i) {
    const ProgramKey random = keys.next();
    for (const ProgramKey& key : {random, generalise(random)}) {
      const std::string text = to_text(key);
      const std::optional<ProgramKey> back = key_of(text);
      ASSERT_TRUE(back) << describe(key);
      ASSERT_EQ(*back, key) << describe(key);
      texts.insert(text);
      described.insert(describe(key));
    }
  }
  EXPECT_GE(texts.size(), described.size());
}

TEST(KeyText, OfAnotherLengthIsNoKey) {
  RandomKeys keys(12);
  for (int i = 0; i < 50; ++i) {
    const std::string text = to_text(keys.next());
    for (std::size_t size = 0; size < text.size(); ++size)
      EXPECT_FALSE(key_of(text.substr(0, size)));
    EXPECT_FALSE(key_of(text + "0"));
  }
  EXPECT_FALSE(key_of(""));
  EXPECT_FALSE(key_of("key"));
}

// What is accepted is safe to generate from, whoever wrote it.
TEST(KeyText, ThatWasForgedIsRefusedOrGeneratesText) {
  RandomKeys keys(13);
  std::minstd_rand random(4);
  unsigned accepted = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string text = to_text(keys.next());
    for (auto changes = 1 + random() % 6; changes > 0; --changes)
      text[random() % text.size()] = "0123456789abcdefg "[random() % 18];
    const std::optional<ProgramKey> key = key_of(text);
    if (!key) continue;
    ++accepted;
    EXPECT_EQ(to_text(*key), text);
    for (const Dialect dialect : {Dialect::kCore330, Dialect::kEs300})
      EXPECT_FALSE(generate(*key, dialect).vertex.empty());
    EXPECT_FALSE(describe(*key).empty());
  }
  EXPECT_GT(accepted, 100u);
}

}  // namespace
}  // namespace legacy_gl::test
