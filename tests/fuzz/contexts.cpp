#include "fuzz/contexts.hpp"

#include <cstdlib>
#include <cstring>
#include <legacy_gl/context.hpp>
#include <stdexcept>
#include <utility>

#include "support/egl_context.hpp"
#include "support/osmesa_context.hpp"

namespace legacy_gl::fuzz {

namespace {

std::vector<std::string> diagnostics;

void keep_diagnostic(const char* message, void*) { diagnostics.emplace_back(message); }

using GetString = const GLubyte* (*)(GLenum);

template <legacy_gl_loader loader>
const GLubyte* string_of_another_driver(GLenum name) {
  if (name == GL_RENDERER) return reinterpret_cast<const GLubyte*>("generic");
  return reinterpret_cast<GetString>(loader("glGetString"))(name);
}

template <legacy_gl_loader loader>
legacy_gl_proc disguised(const char* name) {
  if (std::strcmp(name, "glGetString") == 0)
    return reinterpret_cast<legacy_gl_proc>(string_of_another_driver<loader>);
  return loader(name);
}

legacy_gl_proc osmesa_loader(const char* name) { return OSMesaGetProcAddress(name); }
legacy_gl_proc egl_loader(const char* name) { return eglGetProcAddress(name); }

std::unique_ptr<OwnedContext> make_library_context(const Mode& mode) {
  legacy_gl_options options{};
  options.programs = mode.programs;
  options.accumulation_buffer = 1;
  options.diagnostic = keep_diagnostic;
  // Read when a context is created.
  if (mode.generic) setenv("LEGACY_GL_DRIVER_TRAITS", "generic", 1);
  else unsetenv("LEGACY_GL_DRIVER_TRAITS");
  const bool es = mode.dialect == Dialect::es;
  const legacy_gl_loader loader = es ? egl_loader : osmesa_loader;
  const legacy_gl_loader disguise = es ? disguised<egl_loader> : disguised<osmesa_loader>;
  return std::make_unique<OwnedContext>(mode.generic ? disguise : loader, options);
}

// As tests/support/contexts.hpp has them, with a loader that can disguise the driver.
class OurContext final : public test::RenderContext {
 public:
  explicit OurContext(const Mode& mode)
      : RenderContext(picture_width, picture_height, test::PixelFormat::rgba8), mode_(mode) {
    gl = load_gl_functions(legacy_gl_get_proc_address);
    make_current();
  }
  ~OurContext() override { shut_down(); }

  test::Image read() override {
    legacy_gl_flush();
    return egl_ ? egl_->read() : osmesa_->finish_and_read();
  }

 private:
  void create() override {}
  void destroy() override {
    context_.reset();
    egl_.reset();
    test::OsmesaContext::release();
    osmesa_.reset();
  }
  void bind() override {
    if (mode_.dialect == Dialect::es) bind_egl();
    else bind_osmesa();
    if (!context_) context_ = make_library_context(mode_);
    context_->make_current();
  }
  void bind_egl() {
    if (egl_) egl_->bind();
    else egl_ = std::make_unique<test::EglContext>(width(), height(), color_format());
  }
  void bind_osmesa() {
    if (!osmesa_)
      osmesa_ = std::make_unique<test::OsmesaContext>(width(), height(), color_format(),
                                                      test::Profile::core);
    osmesa_->bind();
  }
  void release() override {
    legacy_gl_make_current(nullptr);
    if (mode_.dialect == Dialect::es) test::EglContext::release();
    else test::OsmesaContext::release();
  }

  Mode mode_;
  std::unique_ptr<test::OsmesaContext> osmesa_;
  std::unique_ptr<test::EglContext> egl_;
  std::unique_ptr<OwnedContext> context_;
};

}  // namespace

std::string Mode::name() const {
  std::string result = dialect == Dialect::es ? "es" : "core";
  if (programs == LEGACY_GL_PROGRAMS_SPECIALISED) result += "-specialised";
  if (programs == LEGACY_GL_PROGRAMS_GENERAL_FIRST) result += "-general_first";
  if (programs == LEGACY_GL_PROGRAMS_GENERAL) result += "-general";
  return result + (generic ? "-generic" : "");
}

const std::vector<Mode>& all_modes() {
  static const std::vector<Mode> modes = [] {
    std::vector<Mode> result;
    for (const bool generic : {false, true})
      for (const auto programs : {LEGACY_GL_PROGRAMS_GENERAL_FIRST, LEGACY_GL_PROGRAMS_SPECIALISED,
                                  LEGACY_GL_PROGRAMS_GENERAL})
        for (const Dialect dialect : {Dialect::core, Dialect::es})
          result.push_back({dialect, programs, generic});
    return result;
  }();
  return modes;
}

Mode mode_named(std::string_view name) {
  for (const Mode& mode : all_modes())
    if (mode.name() == name) return mode;
  throw std::runtime_error("no such mode: " + std::string(name));
}

std::vector<std::string> take_diagnostics() { return std::exchange(diagnostics, {}); }

std::unique_ptr<test::RenderContext> make_ours(const Mode& mode) {
  return std::make_unique<OurContext>(mode);
}

std::unique_ptr<test::RenderContext> make_mesa(Dialect dialect) {
  return std::make_unique<test::MesaContext>(
      picture_width, picture_height, test::PixelFormat::rgba8,
      dialect == Dialect::es ? test::Target::framebuffer_object : test::Target::window);
}

}  // namespace legacy_gl::fuzz
