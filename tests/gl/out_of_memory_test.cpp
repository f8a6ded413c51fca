// Lack of memory anywhere in the library is GL_OUT_OF_MEMORY and nothing worse (GL 2.1 spec 2.5):
// each allocation of a frame that passes through every area fails in its turn.
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "allocations.hpp"
#include "every_area.hpp"
#include "support/contexts.hpp"
#include "support/driver_shim.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {
namespace {

// The driver's own allocations do not fail: it may end the process, and is not what is tested.
class DriverIsExempt : public DriverObserver {
 public:
  bool before(const DriverCall&) override {
    was_exempt_ = exempt_allocations(true);
    return true;
  }
  void after(const DriverCall&) override { exempt_allocations(was_exempt_); }

 private:
  bool was_exempt_ = false;
};

// With specialised programs from the first frame on: that a key has one now and had none a frame
// ago may change a colour's last bit.
CoreContext make_context() {
  legacy_gl_options options = LEGACY_GL_OPTIONS_INIT;
  options.programs = LEGACY_GL_PROGRAMS_SPECIALISED;
  return CoreContext(kEveryAreaSize, kEveryAreaSize, PixelFormat::rgba8, options,
                     {.loader = shimmed_proc});
}

// What a state was before a call that failed in the middle of a frame is not known: between frames
// the program sets what it relies on.
void draw_after_failure(CoreContext& context) {
  const GlFunctions& gl = context.gl;
  gl.End();
  gl.RenderMode(GL_RENDER);
  gl.EndList();
  gl.EndQuery(GL_SAMPLES_PASSED);
  for (int i = 0; i < 16; ++i) {
    gl.PopAttrib();
    gl.PopClientAttrib();
  }
  gl.ActiveTexture(GL_TEXTURE0);
  gl.MatrixMode(GL_MODELVIEW);
  for (int i = 0; i < 4; ++i) gl.PopMatrix();
  gl.LoadIdentity();
  while (gl.GetError() != GL_NO_ERROR) {
  }
  draw_every_area(gl);
}

enum class Mode { kOne, kAllAfter };

// False when the frame has fewer allocations than `nth`.
bool fail_in_frame(CoreContext& context, std::uint64_t nth, Mode mode, const Image& expected) {
  context.gl.PushAttrib(GL_ALL_ATTRIB_BITS);  // popped after the failure, whatever failed
  fail_allocation(nth, mode == Mode::kAllAfter);
  draw_every_area(context.gl);
  const std::uint64_t failures = failed_allocations();
  fail_allocation(0);
  if (failures == 0) return false;
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_OUT_OF_MEMORY}) << "allocation " << nth;
  draw_after_failure(context);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR}) << "allocation " << nth;
  EXPECT_TRUE(images_match(context.read_rgba8(), expected, {}, "out_of_memory"))
      << "allocation " << nth;
  return true;
}

// The pictures themselves are compared with Mesa's elsewhere: here the frame after a failure is to
// be the one that a context without a failure draws.
Image undisturbed_frame(CoreContext& context) {
  for (int frame = 0; frame < 3; ++frame) draw_every_area(context.gl);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
  return context.read_rgba8();
}

TEST(OutOfMemory, AnyAllocationOfALaterFrame) {
  const DriverIsExempt exempt;
  for (const Mode mode : {Mode::kOne, Mode::kAllAfter}) {
    CoreContext context = make_context();
    const Image expected = undisturbed_frame(context);
    std::uint64_t nth = 1;
    while (fail_in_frame(context, nth, mode, expected) && !testing::Test::HasFailure()) ++nth;
    EXPECT_GT(nth, 100u) << "the frame allocates in every area";
    RecordProperty(mode == Mode::kOne ? "one" : "all_after", std::to_string(nth));
  }
}

// Of a first frame most allocations make programs, which takes long: a part of them in turn, all of
// them where LEGACY_GL_TEST_EVERY_ALLOCATION is set.
TEST(OutOfMemory, AllocationsOfTheFirstFrame) {
  const DriverIsExempt exempt;
  const bool every = std::getenv("LEGACY_GL_TEST_EVERY_ALLOCATION") != nullptr;
  std::optional<Image> expected;
  {
    CoreContext context = make_context();
    expected = undisturbed_frame(context);
  }
  std::uint64_t step = 1;
  for (std::uint64_t nth = 1; !testing::Test::HasFailure(); nth += step) {
    CoreContext context = make_context();
    if (!fail_in_frame(context, nth, Mode::kOne, *expected)) break;
    // A prime: it falls into another place of each pattern that repeats.
    step = every ? 1 : 199;
  }
}

TEST(OutOfMemory, CreationOfAContextSaysSo) {
  const DriverIsExempt exempt;
  CoreContext context = make_context();
  for (std::uint64_t nth = 1;; ++nth) {
    legacy_gl_status status = LEGACY_GL_OK;
    const legacy_gl_options options{};
    fail_allocation(nth);
    legacy_gl_context* const made = legacy_gl_create_context(shimmed_proc, &options, &status);
    const bool failed = failed_allocations() != 0;
    fail_allocation(0);
    if (!failed) {
      EXPECT_EQ(status, LEGACY_GL_OK);
      legacy_gl_destroy_context(made);
      EXPECT_GT(nth, 10u);
      break;
    }
    EXPECT_EQ(made, nullptr);
    EXPECT_EQ(status, LEGACY_GL_OUT_OF_MEMORY) << "allocation " << nth;
  }
}

TEST(OutOfMemory, QueriesOfTheCApiAnswerNothing) {
  const DriverIsExempt exempt;
  CoreContext context = make_context();
  draw_every_area(context.gl);
  for (const auto ask : {legacy_gl_get_program_source, legacy_gl_get_program_keys})
    for (std::uint64_t nth = 1;; ++nth) {
      fail_allocation(nth);
      const std::size_t length = ask(nullptr, 0);
      const bool failed = failed_allocations() != 0;
      fail_allocation(0);
      if (!failed) break;
      EXPECT_EQ(length, 0u);
      EXPECT_EQ(context.gl.GetError(), GLenum{GL_OUT_OF_MEMORY});
    }
}

// GL 2.1 spec 5.4: the list that the name had before stays.
TEST(OutOfMemory, ListThatDoesNotFitLeavesTheOneBefore) {
  const DriverIsExempt exempt;
  CoreContext context = make_context();
  const GlFunctions& gl = context.gl;
  const auto compile = [&gl](float green) {
    gl.NewList(1, GL_COMPILE);
    for (int i = 0; i < 20; ++i) {
      gl.Begin(GL_QUADS);
      gl.Color3f(0, green, 0);
      gl.Vertex2f(-1, -1);
      gl.Vertex2f(1, -1);
      gl.Vertex2f(1, 1);
      gl.Vertex2f(-1, 1);
      gl.End();
    }
    gl.EndList();
  };
  compile(1);
  for (std::uint64_t nth = 1;; ++nth) {
    fail_allocation(nth);
    compile(0);
    const bool failed = failed_allocations() != 0;
    fail_allocation(0);
    if (!failed) break;
    EXPECT_EQ(gl.GetError(), GLenum{GL_OUT_OF_MEMORY});
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.CallList(1);
    EXPECT_EQ(context.read_rgba8().bytes[1], 255) << "allocation " << nth;
  }
}

}  // namespace
}  // namespace legacy_gl::test
