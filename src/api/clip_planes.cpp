// GL 2.1 spec 2.12, 6.1.3: glClipPlane, glGetClipPlane.
#include <glm/matrix.hpp>

#include "dlist/dispatch.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

using Equation = std::array<GLdouble, 4>;

void clip_plane(Context& c, GLenum plane, Equation equation) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  const GLenum index = plane - GL_CLIP_PLANE0;
  if (index >= kMaxClipPlanes) return raise_error(c, GL_INVALID_ENUM);
  const glm::dvec4 object(equation[0], equation[1], equation[2], equation[3]);
  // p M⁻¹, with the modelview matrix of now
  const glm::dvec4 eye = object * glm::inverse(c.transform.modelview.top().exact);
  assign(c, c.transform.clip.planes_eye[index], eye, kDirtyFragments);
}

void get_clip_plane(Context& c, GLenum plane, GLdouble* equation) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  const GLenum index = plane - GL_CLIP_PLANE0;
  if (index >= kMaxClipPlanes) return raise_error(c, GL_INVALID_ENUM);
  const glm::dvec4& eye = c.transform.clip.planes_eye[index];
  for (int i = 0; i < 4; ++i) equation[i] = eye[i];
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglClipPlane(GLenum plane, const GLdouble* equation) {
  dispatch<clip_plane>(plane, Equation{equation[0], equation[1], equation[2], equation[3]});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetClipPlane(GLenum plane, GLdouble* equation) {
  execute_now<get_clip_plane>(plane, equation);
}
