// legacy_gl_options and legacy_gl_statistics of programs that were compiled with other headers.
#include "api/sized_structs.hpp"

#include <gtest/gtest.h>

#include <cstddef>

namespace legacy_gl {
namespace {

struct NewerOptions {
  legacy_gl_options known{};
  std::size_t added = 0;
};

struct NewerStatistics {
  legacy_gl_statistics known{};
  std::uint64_t added = 7;
};

TEST(Options, NullMeansDefaults) {
  legacy_gl_options options{};
  options.max_lights = 16;
  EXPECT_EQ(read_options(nullptr, options), "");
  EXPECT_EQ(options.max_lights, 0u);
  EXPECT_EQ(options.size, sizeof options);
}

TEST(Options, InitialisersSetTheSize) {
  const legacy_gl_options empty_braces{}, macro = LEGACY_GL_OPTIONS_INIT;
  for (const legacy_gl_options& given : {empty_braces, macro}) {
    legacy_gl_options options;
    EXPECT_EQ(read_options(&given, options), "");
    EXPECT_EQ(options.programs, LEGACY_GL_PROGRAMS_DEFAULT);
  }
}

TEST(Options, OfAnOlderProgramEndBeforeTheNewFields) {
  legacy_gl_options given{};
  given.max_lights = 16;
  given.programs = LEGACY_GL_PROGRAMS_GENERAL;  // lies behind the program's struct
  given.size = offsetof(legacy_gl_options, programs);
  legacy_gl_options options;
  EXPECT_EQ(read_options(&given, options), "");
  EXPECT_EQ(options.max_lights, 16u);
  EXPECT_EQ(options.programs, LEGACY_GL_PROGRAMS_DEFAULT);
  EXPECT_EQ(options.size, sizeof options);
}

TEST(Options, OfANewerProgramAreTakenUnlessTheyAskForWhatIsUnknown) {
  NewerOptions given;
  given.known.size = sizeof given;
  given.known.max_lights = 16;
  legacy_gl_options options;
  EXPECT_EQ(read_options(&given.known, options), "");
  EXPECT_EQ(options.max_lights, 16u);
  EXPECT_EQ(options.size, sizeof options);
  given.added = 1;
  EXPECT_NE(read_options(&given.known, options).find("does not know"), std::string::npos);
}

TEST(Options, WithoutASizeAreRefusedByName) {
  legacy_gl_options given{}, options;
  given.size = 0;
  EXPECT_NE(read_options(&given, options).find("LEGACY_GL_OPTIONS_INIT"), std::string::npos);
}

TEST(Statistics, OfAnOlderProgramAreNotWrittenPastTheirEnd) {
  legacy_gl_statistics counted{}, given{};
  counted.programs_generated = 1;
  counted.programs_compiled = 2;
  given.size = offsetof(legacy_gl_statistics, programs_compiled);
  given.programs_compiled = 99;
  EXPECT_EQ(write_statistics(counted, &given), "");
  EXPECT_EQ(given.size, offsetof(legacy_gl_statistics, programs_compiled));
  EXPECT_EQ(given.programs_generated, 1u);
  EXPECT_EQ(given.programs_compiled, 99u);
}

TEST(Statistics, OfANewerProgramAreFilledAsFarAsTheyAreKnown) {
  legacy_gl_statistics counted{};
  counted.programs_generated = 1;
  NewerStatistics given;
  given.known.size = sizeof given;
  EXPECT_EQ(write_statistics(counted, &given.known), "");
  EXPECT_EQ(given.known.size, sizeof given);
  EXPECT_EQ(given.known.programs_generated, 1u);
  EXPECT_EQ(given.added, 7u);
}

TEST(Statistics, WithoutASizeAreRefusedByName) {
  legacy_gl_statistics given{};
  given.size = 0;
  given.draws = 99;
  EXPECT_NE(write_statistics({}, &given).find("LEGACY_GL_STATISTICS_INIT"), std::string::npos);
  EXPECT_EQ(given.draws, 99u);
  EXPECT_NE(write_statistics({}, nullptr), "");
}

}  // namespace
}  // namespace legacy_gl
