// What is known of a driver: found, measured, and overridden.
#include "driver/driver_traits.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "driver/arithmetic_test.hpp"
#include "driver/driver.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {
namespace {

DriverTraits traits_of(Loader loader, const char* overrides, std::string& unknown) {
  Driver driver;
  std::string detail;
  EXPECT_EQ(load_driver(driver, loader, detail), DriverStatus::kOk) << detail;
  return find_driver_traits(driver, overrides, unknown);
}

class DriverTraitsOf : public testing::Test {
 protected:
  DriverTraits found(const char* overrides) {
    return traits_of(CoreContext::driver_proc, overrides, unknown);
  }
  CoreContext context{16, 16};
  std::string unknown;
};

TEST_F(DriverTraitsOf, LlvmpipeAreFoundAndMeasured) {
  const DriverTraits traits = found("");
  EXPECT_TRUE(traits.rasterises_on_cpu);
  EXPECT_TRUE(traits.matches_cpu_arithmetic);
  EXPECT_TRUE(traits.shares_fragment_stages);
  EXPECT_EQ(unknown, "");
}

TEST_F(DriverTraitsOf, AGenericDriverAreAllPutAside) {
  const DriverTraits traits = found("generic");
  for (const DriverTraitInfo& info : driver_trait_table())
    EXPECT_EQ(traits.*info.value, info.generic) << info.name;
}

TEST_F(DriverTraitsOf, AMinusTurnsOneOffAndTheLastWordCounts) {
  EXPECT_FALSE(found("-rasterises_on_cpu").rasterises_on_cpu);
  EXPECT_TRUE(found("generic,rasterises_on_cpu").rasterises_on_cpu);
  EXPECT_FALSE(found("rasterises_on_cpu,generic").rasterises_on_cpu);
  EXPECT_FALSE(found("-matches_cpu_arithmetic").matches_cpu_arithmetic);
}

TEST_F(DriverTraitsOf, NamesThatThereAreNotAreTold) {
  found("generic,fast,-slow");
  EXPECT_EQ(unknown, "fast, slow");
}

TEST(ArithmeticTest, LeavesTheDriversStateAsItWas) {
  CoreContext context(16, 16);
  Driver driver;
  std::string detail;
  ASSERT_EQ(load_driver(driver, CoreContext::driver_proc, detail), DriverStatus::kOk);
  GLuint array = 0, buffer = 0;
  driver.GenVertexArrays(1, &array);
  driver.BindVertexArray(array);
  driver.GenBuffers(1, &buffer);
  driver.BindBuffer(GL_ARRAY_BUFFER, buffer);
  EXPECT_TRUE(measure_cpu_arithmetic(driver));
  const auto integer = [&driver](GLenum name) {
    GLint value = -1;
    driver.GetIntegerv(name, &value);
    return static_cast<GLuint>(value);
  };
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BINDING), array);
  EXPECT_EQ(integer(GL_ARRAY_BUFFER_BINDING), buffer);
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), 0u);
  EXPECT_EQ(integer(GL_RASTERIZER_DISCARD), 0u);
  EXPECT_EQ(driver.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(ArithmeticTest, AnswersOnOpenGlEsToo) {
  GlesContext context(16, 16);
  Driver driver;
  std::string detail;
  ASSERT_EQ(load_driver(driver, GlesContext::driver_proc, detail), DriverStatus::kOk);
  EXPECT_TRUE(measure_cpu_arithmetic(driver));
}

TEST(DriverTraitsDocument, NamesEveryTrait) {
  std::ifstream file(std::string(LEGACY_GL_SOURCE_DIR) + "/docs/driver_traits.md");
  std::stringstream text;
  text << file.rdbuf();
  for (const DriverTraitInfo& info : driver_trait_table())
    EXPECT_NE(text.str().find(std::string("`") + info.name + "`"), std::string::npos) << info.name;
}

}  // namespace
}  // namespace legacy_gl::test
