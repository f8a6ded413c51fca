// A driver that fails now and then: whichever of its calls it is, nothing crashes, what is wrong is
// said once, and the frame after is right.
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <string>

#include "every_area.hpp"
#include "support/contexts.hpp"
#include "support/driver_shim.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {
namespace {

/// Lets the nth call of one function fail, as drivers do: a status of 0, a null pointer, or nothing
/// done and an error to be asked for.
class FaultyDriver : public DriverObserver {
 public:
  void fail(const char* function, int nth) {
    function_ = function;
    until_failure_ = nth;
    failed_ = false;
  }
  bool failed() const { return failed_; }

  bool before(const DriverCall& call) override {
    if (call.is("glGetError") && error_waits_) return false;
    if (answers_by_status(call) || !is_due(call)) return true;
    error_waits_ = true;
    return false;
  }
  std::uint32_t answer(const DriverCall& call) override {
    if (!call.is("glGetError")) return 0;
    error_waits_ = false;
    return GL_OUT_OF_MEMORY;
  }
  void after(const DriverCall& call) override {
    constexpr std::uint64_t kCompileStatus = 0x8B81, kLinkStatus = 0x8B82;
    if (!answers_by_status(call)) return;
    if (call.argument(1) != kCompileStatus && call.argument(1) != kLinkStatus) return;
    if (is_due(call)) std::memset(reinterpret_cast<void*>(call.argument(2)), 0, sizeof(GLint));
  }

 private:
  static bool answers_by_status(const DriverCall& call) {
    return call.is("glGetShaderiv") || call.is("glGetProgramiv");
  }
  bool is_due(const DriverCall& call) {
    if (!until_failure_ || !call.is(function_) || --until_failure_) return false;
    failed_ = true;
    return true;
  }

  const char* function_ = "";
  int until_failure_ = 0;
  bool failed_ = false, error_waits_ = false;
};

class DriverFaults : public testing::TestWithParam<const char*> {};

TEST_P(DriverFaults, NextFrameIsRight) {
  FaultyDriver faulty;
  std::map<std::string, int> messages;
  legacy_gl_options options{};
  options.programs =
      LEGACY_GL_PROGRAMS_SPECIALISED;  // no picture depends on how often it was drawn
  options.diagnostic = [](const char* message, void* user) {
    ++(*static_cast<std::map<std::string, int>*>(user))[message];
  };
  options.diagnostic_user = &messages;
  const auto make = [&] {
    return CoreContext(kEveryAreaSize, kEveryAreaSize, PixelFormat::rgba8, options,
                       {.loader = shimmed_proc});
  };
  Image expected = [&] {
    CoreContext context = make();
    for (int frame = 0; frame < 2; ++frame) draw_every_area(context.gl);
    return context.read_rgba8();
  }();
  int step = 1;
  for (int nth = 1; !testing::Test::HasFailure(); nth += step) {
    messages.clear();
    CoreContext context = make();
    faulty.fail(GetParam(), nth);
    draw_every_area(context.gl);
    const bool failed = faulty.failed();
    faulty.fail("", 0);
    if (!failed) break;
    context.gl.GetError();
    draw_every_area(context.gl);
    EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR}) << "call " << nth;
    EXPECT_TRUE(images_match(context.read_rgba8(), expected, {}, "driver_faults"))
        << "call " << nth;
    for (const auto& [message, count] : messages) EXPECT_EQ(count, 1) << message;
    step = nth < 20 ? 1 : 17;  // a prime: later ones are of the same kinds
  }
}

INSTANTIATE_TEST_SUITE_P(OfEach, DriverFaults,
                         testing::Values("glGetShaderiv", "glGetProgramiv", "glMapBufferRange",
                                         "glBufferData", "glBufferSubData", "glTexImage2D"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace legacy_gl::test
