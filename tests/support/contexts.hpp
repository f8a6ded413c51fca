// Rendering contexts for tests. Each owns a driver context with a colour buffer, 24 bits of depth
// and 8 of stencil, and offers the OpenGL 1.x functions that draw into it as one table: Mesa's own
// fixed function (MesaContext) or legacy_gl over a core or GLES context (CoreContext, GlesContext).
// A test is written once against the table.
//
// Any number of them live in one process; make_current() switches. A context is current after its
// construction. All throw std::runtime_error when the driver refuses.
#pragma once

#include <legacy_gl/context.h>

#include <memory>

#include "support/gl_functions.hpp"
#include "support/image.hpp"

namespace legacy_gl::test {

class RenderContext {
 public:
  virtual ~RenderContext() = default;
  RenderContext(const RenderContext&) = delete;
  RenderContext& operator=(const RenderContext&) = delete;

  void make_current();
  // Replaces the context by a new one of the same kind: OpenGL's initial state. Current afterwards.
  void recreate();

  int width() const { return width_; }
  int height() const { return height_; }
  PixelFormat color_format() const { return color_format_; }

  // What was drawn so far, by the driver's own means (not by the table's ReadPixels). read_rgba8
  // needs an rgba8 colour buffer, read_float converts if need be. The context must be current.
  Image read_rgba8();
  Image read_float();
  // In the format of the colour buffer.
  virtual Image read() = 0;

  GlFunctions gl;

 protected:
  RenderContext(int width, int height, PixelFormat color_format)
      : width_(width), height_(height), color_format_(color_format) {}

  virtual void create() = 0;
  virtual void destroy() = 0;
  virtual void bind() = 0;
  // Leaves nothing current in this thread.
  virtual void release() = 0;
  // For destructors of the leaves: the virtual functions still work there.
  void shut_down();

 private:
  int width_;
  int height_;
  PixelFormat color_format_;
};

// A window's surface (here OSMesa's buffer) or a framebuffer object. To Mesa a window is upside
// down: a vertex exactly between two pixel rows falls to the other one, and interpolation rounds
// otherwise.
enum class Target { window, framebuffer_object };

// Mesa's fixed function: an OSMesa compatibility context.
class MesaContext final : public RenderContext {
 public:
  MesaContext(int width, int height, PixelFormat color_format = PixelFormat::rgba8,
              Target target = Target::window);
  ~MesaContext() override;
  Image read() override;

 private:
  void create() override;
  void destroy() override;
  void bind() override;
  void release() override;

  struct Data;
  std::unique_ptr<Data> data_;
};

// Tests look at specialised programs from the first draw on, unless they ask for others.
inline legacy_gl_options test_options(legacy_gl_options options) {
  if (options.programs == LEGACY_GL_PROGRAMS_DEFAULT)
    options.programs = LEGACY_GL_PROGRAMS_SPECIALISED;
  options.accumulation_buffer = 1;  // as Mesa's contexts here
  return options;
}

class CoreContext;
struct CoreDriver {
  legacy_gl_loader loader = nullptr;    // nullptr: OSMesa's own
  const CoreContext* shares = nullptr;  // with which the driver's context shares objects, and ours
};

// legacy_gl over an OSMesa core profile 3.3 context.
class CoreContext final : public RenderContext {
 public:
  CoreContext(int width, int height, PixelFormat color_format = PixelFormat::rgba8,
              const legacy_gl_options& options = {}, const CoreDriver& driver = {});
  ~CoreContext() override;
  Image read() override;
  legacy_gl_context* handle() const;
  // The core profile's own function, which a program calls beside legacy_gl.
  static legacy_gl_proc driver_proc(const char* name);

 private:
  void create() override;
  void destroy() override;
  void bind() override;
  void release() override;

  struct Data;
  std::unique_ptr<Data> data_;
};

// legacy_gl over a GLES 3.0 context (EGL, surfaceless platform, software), drawing into a
// framebuffer object that the test made and bound, as a program does that has no window surface.
class GlesContext final : public RenderContext {
 public:
  GlesContext(int width, int height, PixelFormat color_format = PixelFormat::rgba8,
              const legacy_gl_options& options = {});
  ~GlesContext() override;
  Image read() override;
  legacy_gl_context* handle() const;
  static legacy_gl_proc driver_proc(const char* name);

 private:
  void create() override;
  void destroy() override;
  void bind() override;
  void release() override;

  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace legacy_gl::test
