// The per-fragment and rasterisation state that the core profile still has (GL 2.1 spec 2.12, 3.3
// to 3.5, 4.1, 4.2).
#include <algorithm>

#include "api/scalar_parameters.hpp"
#include "dlist/dispatch.hpp"
#include "driver/driver_objects.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool refused(Context& c, bool valid, GLenum error) {
  if (c.recorder.inside_begin_end()) {
    raise_error(c, GL_INVALID_OPERATION);
    return true;
  }
  if (!valid) raise_error(c, error);
  return !valid;
}

bool is_comparison(GLenum f) { return f >= GL_NEVER && f <= GL_ALWAYS; }
bool is_face(GLenum f) { return f == GL_FRONT || f == GL_BACK || f == GL_FRONT_AND_BACK; }

template <typename T, typename U>
void set(Context& c, T& stored, const U& value) {
  assign(c, stored, value, kDirtyRaster);
}

void alpha_func(Context& c, GLenum function, float reference) {
  if (refused(c, is_comparison(function), GL_INVALID_ENUM)) return;
  ColorBufferState& colors = c.raster.color_buffer;
  assign(c, colors.alpha_function, function, kDirtyKey);
  assign(c, colors.alpha_reference, std::clamp(reference, 0.0f, 1.0f), kDirtyFragments);
}
void depth_func(Context& c, GLenum function) {
  if (refused(c, is_comparison(function), GL_INVALID_ENUM)) return;
  set(c, c.raster.depth.function, function);
}
void depth_mask(Context& c, GLboolean flag) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.depth.write_mask, flag != GL_FALSE);
}
void depth_range(Context& c, double near_depth, double far_depth) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.viewport.depth_near, std::clamp(near_depth, 0.0, 1.0));
  set(c, c.raster.viewport.depth_far, std::clamp(far_depth, 0.0, 1.0));
}
void clear_depth(Context& c, double depth) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.depth.clear_value, std::clamp(depth, 0.0, 1.0));
}

bool is_source_factor(GLenum f) {
  return f == GL_ZERO || f == GL_ONE || (f >= GL_SRC_COLOR && f <= GL_SRC_ALPHA_SATURATE) ||
         (f >= GL_CONSTANT_COLOR && f <= GL_ONE_MINUS_CONSTANT_ALPHA);
}
bool is_destination_factor(GLenum f) { return is_source_factor(f) && f != GL_SRC_ALPHA_SATURATE; }
void blend_func_separate(Context& c, GLenum source_rgb, GLenum destination_rgb, GLenum source_alpha,
                         GLenum destination_alpha) {
  if (refused(c,
              is_source_factor(source_rgb) && is_source_factor(source_alpha) &&
                  is_destination_factor(destination_rgb) &&
                  is_destination_factor(destination_alpha),
              GL_INVALID_ENUM))
    return;
  ColorBufferState& color = c.raster.color_buffer;
  set(c, color.blend_source_rgb, source_rgb);
  set(c, color.blend_destination_rgb, destination_rgb);
  set(c, color.blend_source_alpha, source_alpha);
  set(c, color.blend_destination_alpha, destination_alpha);
}
void blend_equation(Context& c, GLenum mode) {
  const bool valid = mode == GL_FUNC_ADD || mode == GL_FUNC_SUBTRACT ||
                     mode == GL_FUNC_REVERSE_SUBTRACT || mode == GL_MIN || mode == GL_MAX;
  if (refused(c, valid, GL_INVALID_ENUM)) return;
  set(c, c.raster.color_buffer.blend_equation, mode);
}
void blend_color(Context& c, float r, float g, float b, float a) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.color_buffer.blend_color, glm::clamp(glm::vec4(r, g, b, a), 0.0f, 1.0f));
}
void logic_op(Context& c, GLenum operation) {
  if (refused(c, operation >= GL_CLEAR && operation <= GL_SET, GL_INVALID_ENUM)) return;
  if (c.raster.color_buffer.logic_op != operation && !c.driver->functions.LogicOp)
    diagnose(c, "glLogicOp: this driver (OpenGL ES) has no logical operations");
  set(c, c.raster.color_buffer.logic_op, operation);
}
void color_mask(Context& c, GLboolean r, GLboolean g, GLboolean b, GLboolean a) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.color_buffer.write_mask, std::array<bool, 4>{r != 0, g != 0, b != 0, a != 0});
}
void clear_color(Context& c, float r, float g, float b, float a) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.color_buffer.clear_color, glm::clamp(glm::vec4(r, g, b, a), 0.0f, 1.0f));
}
void clear_index(Context& c, float index) {
  if (refused(c, true, 0)) return;
  c.raster.color_buffer.clear_index = index;
}
void index_mask(Context& c, GLuint mask) {
  if (refused(c, true, 0)) return;
  c.raster.color_buffer.index_mask = mask;
}

void cull_face(Context& c, GLenum mode) {
  if (refused(c, is_face(mode), GL_INVALID_ENUM)) return;
  assign(c, c.raster.polygon.cull_face, mode, kDirtyRaster | kDirtyKey);
}
void front_face(Context& c, GLenum mode) {
  if (refused(c, mode == GL_CW || mode == GL_CCW, GL_INVALID_ENUM)) return;
  set(c, c.raster.polygon.front_face, mode);
}
void polygon_mode(Context& c, GLenum face, GLenum mode) {
  const bool valid = is_face(face) && (mode == GL_POINT || mode == GL_LINE || mode == GL_FILL);
  if (refused(c, valid, GL_INVALID_ENUM)) return;
  if (face != GL_BACK) set(c, c.raster.polygon.front_mode, mode);
  if (face != GL_FRONT) set(c, c.raster.polygon.back_mode, mode);
}
void polygon_offset(Context& c, float factor, float units) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.polygon.offset_factor, factor);
  set(c, c.raster.polygon.offset_units, units);
}
void point_size(Context& c, float size) {
  if (refused(c, size > 0, GL_INVALID_VALUE)) return;
  assign(c, c.raster.point.size, size, kDirtyRaster | kDirtyTransform);
}
unsigned point_parameter_count(GLenum pname) {
  switch (pname) {
    case GL_POINT_SIZE_MIN:
    case GL_POINT_SIZE_MAX:
    case GL_POINT_FADE_THRESHOLD_SIZE: return 1;
    case GL_POINT_DISTANCE_ATTENUATION: return 3;
    default: return 0;
  }
}
using Floats3 = std::array<float, 3>;
void point_parameter(Context& c, GLenum pname, Floats3 values) {
  const bool negative = pname != GL_POINT_DISTANCE_ATTENUATION && values[0] < 0;
  if (refused(c, point_parameter_count(pname) != 0, GL_INVALID_ENUM)) return;
  if (negative) return raise_error(c, GL_INVALID_VALUE);
  PointState& point = c.raster.point;
  constexpr std::uint32_t kDirty = kDirtyRaster | kDirtyTransform;
  switch (pname) {
    case GL_POINT_SIZE_MIN: assign(c, point.size_min, values[0], kDirty); break;
    case GL_POINT_SIZE_MAX: assign(c, point.size_max, values[0], kDirty); break;
    case GL_POINT_FADE_THRESHOLD_SIZE: assign(c, point.fade_threshold, values[0], kDirty); break;
    default: assign(c, point.attenuation, glm::vec3(values[0], values[1], values[2]), kDirty);
  }
}
void point_parameter_scalar(GLenum pname, float value) {
  dispatch<point_parameter>(scalar_only(pname, point_parameter_count(pname)), Floats3{value});
}
template <typename T>
void point_parameter_vector(GLenum pname, const T* params) {
  Floats3 values{};
  for (unsigned i = 0; i < point_parameter_count(pname); ++i)
    values[i] = static_cast<float>(params[i]);
  dispatch<point_parameter>(pname, values);
}
void line_width(Context& c, float width) {
  if (refused(c, width > 0, GL_INVALID_VALUE)) return;
  set(c, c.raster.line.width, width);
}
void line_stipple(Context& c, GLint factor, GLushort pattern) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.line.stipple_factor, std::clamp(factor, 1, 256));
  set(c, c.raster.line.stipple_pattern, pattern);
}

void scissor(Context& c, GLint x, GLint y, GLsizei width, GLsizei height) {
  if (refused(c, width >= 0 && height >= 0, GL_INVALID_VALUE)) return;
  set(c, c.raster.scissor.box, std::array<GLint, 4>{x, y, width, height});
}
void viewport(Context& c, GLint x, GLint y, GLsizei width, GLsizei height) {
  if (refused(c, width >= 0 && height >= 0, GL_INVALID_VALUE)) return;
  assign(c, c.raster.viewport.box, std::array<GLint, 4>{x, y, width, height},
         kDirtyRaster | kDirtyTransform);
}

void stencil_func(Context& c, GLenum function, GLint reference, GLuint mask) {
  if (refused(c, is_comparison(function), GL_INVALID_ENUM)) return;
  set(c, c.raster.stencil.function, function);
  set(c, c.raster.stencil.reference, reference);
  set(c, c.raster.stencil.value_mask, mask);
}
void stencil_mask(Context& c, GLuint mask) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.stencil.write_mask, mask);
}
void stencil_op(Context& c, GLenum fail, GLenum depth_fail, GLenum depth_pass) {
  const auto is_operation = [](GLenum op) {
    switch (op) {
      case GL_KEEP:
      case GL_ZERO:
      case GL_REPLACE:
      case GL_INCR:
      case GL_DECR:
      case GL_INVERT:
      case GL_INCR_WRAP:
      case GL_DECR_WRAP: return true;
      default: return false;
    }
  };
  if (refused(c, is_operation(fail) && is_operation(depth_fail) && is_operation(depth_pass),
              GL_INVALID_ENUM))
    return;
  set(c, c.raster.stencil.fail, fail);
  set(c, c.raster.stencil.depth_fail, depth_fail);
  set(c, c.raster.stencil.depth_pass, depth_pass);
}
void clear_stencil(Context& c, GLint value) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.stencil.clear_value, value);
}
void sample_coverage(Context& c, float value, GLboolean invert) {
  if (refused(c, true, 0)) return;
  set(c, c.raster.multisample.coverage_value, std::clamp(value, 0.0f, 1.0f));
  set(c, c.raster.multisample.coverage_invert, invert != GL_FALSE);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglAlphaFunc(GLenum func, GLfloat ref) {
  dispatch<alpha_func>(func, ref);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDepthFunc(GLenum func) { dispatch<depth_func>(func); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDepthMask(GLboolean flag) { dispatch<depth_mask>(flag); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDepthRange(GLdouble n, GLdouble f) {
  dispatch<depth_range>(n, f);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglClearDepth(GLdouble depth) {
  dispatch<clear_depth>(depth);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglBlendFunc(GLenum sfactor, GLenum dfactor) {
  dispatch<blend_func_separate>(sfactor, dfactor, sfactor, dfactor);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglBlendFuncSeparate(GLenum sfactorRGB, GLenum dfactorRGB,
                                                           GLenum sfactorAlpha,
                                                           GLenum dfactorAlpha) {
  dispatch<blend_func_separate>(sfactorRGB, dfactorRGB, sfactorAlpha, dfactorAlpha);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglBlendEquation(GLenum mode) {
  dispatch<blend_equation>(mode);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglBlendColor(GLfloat red, GLfloat green, GLfloat blue,
                                                    GLfloat alpha) {
  dispatch<blend_color>(red, green, blue, alpha);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLogicOp(GLenum opcode) { dispatch<logic_op>(opcode); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglColorMask(GLboolean red, GLboolean green, GLboolean blue,
                                                   GLboolean alpha) {
  dispatch<color_mask>(red, green, blue, alpha);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglClearColor(GLfloat red, GLfloat green, GLfloat blue,
                                                    GLfloat alpha) {
  dispatch<clear_color>(red, green, blue, alpha);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglClearIndex(GLfloat c) { dispatch<clear_index>(c); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglIndexMask(GLuint mask) { dispatch<index_mask>(mask); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCullFace(GLenum mode) { dispatch<cull_face>(mode); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglFrontFace(GLenum mode) { dispatch<front_face>(mode); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPolygonMode(GLenum face, GLenum mode) {
  dispatch<polygon_mode>(face, mode);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPolygonOffset(GLfloat factor, GLfloat units) {
  dispatch<polygon_offset>(factor, units);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPointSize(GLfloat size) { dispatch<point_size>(size); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPointParameterf(GLenum pname, GLfloat param) {
  point_parameter_scalar(pname, param);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPointParameteri(GLenum pname, GLint param) {
  point_parameter_scalar(pname, static_cast<float>(param));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPointParameterfv(GLenum pname, const GLfloat* params) {
  point_parameter_vector(pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPointParameteriv(GLenum pname, const GLint* params) {
  point_parameter_vector(pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLineWidth(GLfloat width) { dispatch<line_width>(width); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLineStipple(GLint factor, GLushort pattern) {
  dispatch<line_stipple>(factor, pattern);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglScissor(GLint x, GLint y, GLsizei width, GLsizei height) {
  dispatch<scissor>(x, y, width, height);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglViewport(GLint x, GLint y, GLsizei width, GLsizei height) {
  dispatch<viewport>(x, y, width, height);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglStencilFunc(GLenum func, GLint ref, GLuint mask) {
  dispatch<stencil_func>(func, ref, mask);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglStencilMask(GLuint mask) { dispatch<stencil_mask>(mask); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglStencilOp(GLenum fail, GLenum zfail, GLenum zpass) {
  dispatch<stencil_op>(fail, zfail, zpass);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglClearStencil(GLint s) { dispatch<clear_stencil>(s); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglSampleCoverage(GLfloat value, GLboolean invert) {
  dispatch<sample_coverage>(value, invert);
}
