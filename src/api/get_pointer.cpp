// GL 2.1 spec 6.1.11: glGetPointerv.
#include "dlist/dispatch.hpp"

using namespace legacy_gl;

namespace {

bool find_pointer(const Context& c, GLenum name, const void*& pointer) {
  const auto& arrays = c.arrays.arrays;
  switch (name) {
    case GL_VERTEX_ARRAY_POINTER: pointer = arrays[kVertexArray].pointer; return true;
    case GL_NORMAL_ARRAY_POINTER: pointer = arrays[kNormalArray].pointer; return true;
    case GL_COLOR_ARRAY_POINTER: pointer = arrays[kColorArray].pointer; return true;
    case GL_SECONDARY_COLOR_ARRAY_POINTER:
      pointer = arrays[kSecondaryColorArray].pointer;
      return true;
    case GL_FOG_COORDINATE_ARRAY_POINTER: pointer = arrays[kFogCoordArray].pointer; return true;
    case GL_INDEX_ARRAY_POINTER: pointer = arrays[kIndexArray].pointer; return true;
    case GL_EDGE_FLAG_ARRAY_POINTER: pointer = arrays[kEdgeFlagArray].pointer; return true;
    case GL_TEXTURE_COORD_ARRAY_POINTER:
      pointer = arrays[kTexCoordArray + c.client_active_texture].pointer;
      return true;
    // Their initial value: glFeedbackBuffer and glSelectBuffer are not built.
    case GL_FEEDBACK_BUFFER_POINTER:
    case GL_SELECTION_BUFFER_POINTER: pointer = nullptr; return true;
    default: return false;
  }
}

void get_pointer(Context& c, GLenum name, void** result) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  const void* pointer = nullptr;
  if (!find_pointer(c, name, pointer)) return raise_error(c, GL_INVALID_ENUM);
  // GL hands back the application's own pointer, whose target it may change.
  if (result) *result = const_cast<void*>(pointer);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetPointerv(GLenum pname, void** params) {
  execute_now<get_pointer>(pname, params);
}
