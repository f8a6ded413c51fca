// Every program key gives text that the driver takes, in both dialects.
#include <gtest/gtest.h>

#include "driver/program_cache.hpp"
#include "shadergen/general.hpp"
#include "support/contexts.hpp"
#include "support/random_keys.hpp"

namespace legacy_gl::test {
namespace {

template <typename RenderContextType>
void compile_random_keys() {
  RenderContextType context(16, 16);
  Driver driver;
  std::string detail;
  ASSERT_EQ(load_driver(driver, RenderContextType::driver_proc, detail), DriverStatus::kOk)
      << detail;
  ProgramCache programs(driver);
  legacy_gl_statistics statistics{};
  RandomKeys keys(700);
  for (int i = 0; i < 700; ++i) {
    const ProgramKey key = keys.next();
    ASSERT_NE(programs.find_or_build(key, statistics), 0u) << describe(key) << "\n"
                                                           << programs.error();
    const ProgramKey general = generalise(key);
    ASSERT_NE(programs.find_or_build(general, statistics), 0u) << describe(general) << "\n"
                                                               << programs.error();
    ASSERT_EQ(generalise(general), general);
  }
  EXPECT_EQ(statistics.programs_generated, statistics.programs_compiled);
}

TEST(RandomKeys, SevenHundredCompileInCore330) { compile_random_keys<CoreContext>(); }
TEST(RandomKeys, SevenHundredCompileInEs300) { compile_random_keys<GlesContext>(); }

}  // namespace
}  // namespace legacy_gl::test
