#include "execute/attributes.hpp"
#include "record/pending.hpp"

namespace legacy_gl::execute {

void multi_texcoord4(Context& c, GLenum target, float s, float t, float r, float q) {
  const GLenum unit = target - GL_TEXTURE0;
  if (unit >= kMaxTextureUnits) return raise_error(c, GL_INVALID_ENUM);
  texcoord4(c, unit, s, t, r, q);
}

void rect(Context& c, float x1, float y1, float x2, float y2) {  // GL 2.1 spec 2.10
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  c.recorder.begin(c, GL_POLYGON);
  c.recorder.vertex(c, x1, y1, 0);
  c.recorder.vertex(c, x2, y1, 0);
  c.recorder.vertex(c, x2, y2, 0);
  c.recorder.vertex(c, x1, y2, 0);
  c.recorder.end(c);
}

}  // namespace legacy_gl::execute
