#pragma once
// A draw on the path that it takes, for LEGACY_GL_DEBUG=paths and the debug groups of the driver.
#include <vector>

#include "context/context.hpp"
#include "debug/log.hpp"
#include "geometry/primitive_run.hpp"
#include "submit/choose_path.hpp"

namespace legacy_gl {

/// What is drawn, in words: "GL_TRIANGLES, 300 vertices".
struct DrawnPrimitives {
  GLenum mode;
  bool others = false;  ///< and primitives of other modes
  std::uint32_t vertices;

  DrawnPrimitives(GLenum of_mode, std::uint32_t count) : mode(of_mode), vertices(count) {}
  DrawnPrimitives(const std::vector<PrimitiveRun>& runs, std::uint32_t count);
};

/// Tells of the draw, and holds a debug group open (driver/debug_labels.hpp) while it lives.
/// Nothing but the test of a byte where nobody asks.
class DrawScope {
 public:
  template <typename... Primitives>
  DrawScope(const Context& context, const PathChoice& choice, const Primitives&... primitives)
      : context_(context) {
    if (debug::names_calls()) [[unlikely]]
      open(choice, DrawnPrimitives(primitives...));
  }
  ~DrawScope() {
    if (open_) [[unlikely]]
      close();
  }
  DrawScope(const DrawScope&) = delete;
  DrawScope& operator=(const DrawScope&) = delete;

 private:
  [[gnu::cold, gnu::noinline]] void open(const PathChoice& choice,
                                         const DrawnPrimitives& primitives);
  [[gnu::cold, gnu::noinline]] void close();

  const Context& context_;
  bool open_ = false;
};

}  // namespace legacy_gl
