// GL 2.1 spec 2.11.2: matrices.
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "dlist/dispatch.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

struct MatrixValues {
  glm::mat4 m;
};

MatrixValues read(const GLfloat* m) { return {glm::make_mat4(m)}; }
MatrixValues read(const GLdouble* m) { return {glm::mat4(glm::make_mat4(m))}; }

MatrixStack& current_stack(Context& c) {
  switch (c.transform.matrix_mode) {
    case GL_PROJECTION: return c.transform.projection;
    case GL_TEXTURE: return c.transform.texture[c.active_texture];
    default: return c.transform.modelview;
  }
}

void before_change(Context& c) {
  if (c.transform.matrix_mode == GL_TEXTURE) flush_pending(c);
  else before_matrix_change(c);
}

std::uint32_t current_dirty_bit(const Context& c) {
  return c.transform.matrix_mode == GL_TEXTURE ? kDirtyTexture : kDirtyTransform;
}

/// Outside Begin/End: what is recorded is drawn with the matrix it was recorded under; then the top
/// may change.
template <typename Change>
void change_top(Context& c, Change change) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  before_change(c);
  change(current_stack(c).top());
  mark_dirty(c, current_dirty_bit(c));
}

void matrix_mode(Context& c, GLenum mode) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  if (mode != GL_MODELVIEW && mode != GL_PROJECTION && mode != GL_TEXTURE)
    return raise_error(c, GL_INVALID_ENUM);
  c.transform.matrix_mode = mode;
}

/// The same for what the stack may leave uncomputed until it is drawn with.
void apply(Context& c, const MatrixOperation& operation) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  before_change(c);
  current_stack(c).apply(operation);
  mark_dirty(c, current_dirty_bit(c));
}

void load_identity(Context& c) {
  change_top(c, [](Matrix& top) { set_identity(top); });
}
void load_matrix(Context& c, MatrixValues values) {
  change_top(c, [&](Matrix& top) { load(top, values.m); });
}
void multiply_matrix(Context& c, MatrixValues values) {
  change_top(c, [&](Matrix& top) { multiply(top, values.m); });
}
void rotate_by(Context& c, float degrees, float x, float y, float z) {
  if (degrees == 0 && !c.recorder.inside_begin_end()) return;
  apply(c, {MatrixOperation::Kind::kRotate, x, y, z, degrees});
}
void translate_by(Context& c, float x, float y, float z) {
  apply(c, {MatrixOperation::Kind::kTranslate, x, y, z});
}
void scale_by(Context& c, float x, float y, float z) {
  apply(c, {MatrixOperation::Kind::kScale, x, y, z});
}

struct Box {
  double left, right, bottom, top, near_distance, far_distance;
};

void multiply_ortho(Context& c, Box b) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  if (b.left == b.right || b.bottom == b.top || b.near_distance == b.far_distance)
    return raise_error(c, GL_INVALID_VALUE);
  change_top(c, [&](Matrix& top) {
    ortho(top, b.left, b.right, b.bottom, b.top, b.near_distance, b.far_distance);
  });
}
void multiply_frustum(Context& c, Box b) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  if (b.near_distance <= 0 || b.far_distance <= 0 || b.near_distance == b.far_distance ||
      b.left == b.right || b.bottom == b.top)
    return raise_error(c, GL_INVALID_VALUE);
  change_top(c, [&](Matrix& top) {
    frustum(top, b.left, b.right, b.bottom, b.top, b.near_distance, b.far_distance);
  });
}

void push_matrix(Context& c) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  MatrixStack& stack = current_stack(c);
  if (!stack.can_push()) return raise_error(c, GL_STACK_OVERFLOW);
  stack.push();
}
void pop_matrix(Context& c) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  MatrixStack& stack = current_stack(c);
  if (!stack.can_pop()) return raise_error(c, GL_STACK_UNDERFLOW);
  before_change(c);
  stack.pop();
  mark_dirty(c, current_dirty_bit(c));
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglMatrixMode(GLenum mode) { dispatch<matrix_mode>(mode); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLoadIdentity(void) { dispatch<load_identity>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLoadMatrixf(const GLfloat* m) {
  dispatch<load_matrix>(read(m));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLoadMatrixd(const GLdouble* m) {
  dispatch<load_matrix>(read(m));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMultMatrixf(const GLfloat* m) {
  dispatch<multiply_matrix>(read(m));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMultMatrixd(const GLdouble* m) {
  dispatch<multiply_matrix>(read(m));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLoadTransposeMatrixf(const GLfloat* m) {
  dispatch<load_matrix>(MatrixValues{glm::transpose(read(m).m)});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLoadTransposeMatrixd(const GLdouble* m) {
  dispatch<load_matrix>(MatrixValues{glm::transpose(read(m).m)});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMultTransposeMatrixf(const GLfloat* m) {
  dispatch<multiply_matrix>(MatrixValues{glm::transpose(read(m).m)});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMultTransposeMatrixd(const GLdouble* m) {
  dispatch<multiply_matrix>(MatrixValues{glm::transpose(read(m).m)});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPushMatrix(void) { dispatch<push_matrix>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPopMatrix(void) { dispatch<pop_matrix>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglRotatef(GLfloat angle, GLfloat x, GLfloat y, GLfloat z) {
  dispatch<rotate_by>(angle, x, y, z);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglRotated(GLdouble angle, GLdouble x, GLdouble y,
                                                 GLdouble z) {
  lglRotatef(static_cast<float>(angle), static_cast<float>(x), static_cast<float>(y),
             static_cast<float>(z));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTranslatef(GLfloat x, GLfloat y, GLfloat z) {
  dispatch<translate_by>(x, y, z);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTranslated(GLdouble x, GLdouble y, GLdouble z) {
  lglTranslatef(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglScalef(GLfloat x, GLfloat y, GLfloat z) {
  dispatch<scale_by>(x, y, z);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglScaled(GLdouble x, GLdouble y, GLdouble z) {
  lglScalef(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglOrtho(GLdouble left, GLdouble right, GLdouble bottom,
                                               GLdouble top, GLdouble zNear, GLdouble zFar) {
  dispatch<multiply_ortho>(Box{left, right, bottom, top, zNear, zFar});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglFrustum(GLdouble left, GLdouble right, GLdouble bottom,
                                                 GLdouble top, GLdouble zNear, GLdouble zFar) {
  dispatch<multiply_frustum>(Box{left, right, bottom, top, zNear, zFar});
}
