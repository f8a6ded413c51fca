// The generator is a pure function of key and dialect.
#include <gtest/gtest.h>

#include "shadergen/generate.hpp"
#include "support/random_keys.hpp"

namespace legacy_gl::test {
namespace {

TEST(ProgramKey, EqualKeysGiveEqualText) {
  RandomKeys keys(1);
  for (int i = 0; i < 200; ++i) {
    const ProgramKey key = keys.next();
    const ProgramKey copy = key;
    for (const Dialect dialect : {Dialect::kCore330, Dialect::kEs300}) {
      EXPECT_EQ(generate(key, dialect).vertex, generate(copy, dialect).vertex);
      EXPECT_EQ(generate(key, dialect).fragment, generate(copy, dialect).fragment);
    }
    EXPECT_EQ(ProgramKeyHash{}(key), ProgramKeyHash{}(copy));
  }
}

TEST(ProgramKey, TheFirstLinesSayTheDialectAndTheKeyInWords) {
  ProgramKey key;
  key.lit = true;
  key.lights[0] = {kLightDiffuse, 1};
  const ProgramSource core = generate(key, Dialect::kCore330);
  const ProgramSource es = generate(key, Dialect::kEs300);
  EXPECT_EQ(core.vertex.substr(0, core.vertex.find('\n')), "#version 330 core");
  EXPECT_EQ(es.vertex.substr(0, es.vertex.find('\n')), "#version 300 es");
  EXPECT_NE(core.vertex.find("// vertex: 1 directional (d), in object space\n"), std::string::npos);
}

TEST(ProgramKey, GeneratedTextHasNoPreprocessorBranches) {
  RandomKeys keys(2);
  for (int i = 0; i < 200; ++i) {
    const ProgramSource source = generate(keys.next(), Dialect::kEs300);
    EXPECT_EQ(source.vertex.find("#if"), std::string::npos);
    EXPECT_EQ(source.fragment.find("#if"), std::string::npos);
  }
}

TEST(ProgramKey, AnUnlitProgramDoesNotMentionLights) {
  ProgramKey key;
  const ProgramSource source = generate(key, Dialect::kCore330);
  EXPECT_EQ(source.vertex.find("Light"), std::string::npos);
  EXPECT_EQ(source.vertex.find("normal;"), std::string::npos);
}

}  // namespace
}  // namespace legacy_gl::test
