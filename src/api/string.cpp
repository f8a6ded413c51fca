// GL 2.1 spec 6.1.11: glGetString.
#include "api/extensions.hpp"
#include "dlist/dispatch.hpp"
#include "driver/driver_objects.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

const char* find_string(Context& c, GLenum name) {
  switch (name) {
    case GL_VENDOR: return "legacy_gl";
    case GL_RENDERER:
      if (c.renderer_name.empty()) {
        const auto* const driver =
            reinterpret_cast<const char*>(c.driver->functions.GetString(GL_RENDERER));
        c.renderer_name = std::string("legacy_gl on ") + (driver ? driver : "an unnamed renderer");
      }
      return c.renderer_name.c_str();
    case GL_VERSION: return "1.5 legacy_gl 0.1.0";
    case GL_EXTENSIONS:
      if (c.extensions.empty()) c.extensions = extension_names(c.driver->functions);
      return c.extensions.c_str();
    default: return nullptr;
  }
}

const GLubyte* get_string(Context& c, GLenum name) {
  if (c.recorder.inside_begin_end()) {
    raise_error(c, GL_INVALID_OPERATION);
    return nullptr;
  }
  const char* const text = find_string(c, name);
  if (!text) raise_error(c, GL_INVALID_ENUM);
  return reinterpret_cast<const GLubyte*>(text);
}

}  // namespace

LEGACY_GL_API const GLubyte* LEGACY_GL_APIENTRY lglGetString(GLenum name) {
  return execute_now<get_string>(name);
}
