// GL 2.1 spec 5.1: evaluators.
#include <cmath>
#include <memory>

#include "dlist/dispatch.hpp"
#include "execute/eval_coord.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool inside(Context& c) {
  if (!c.recorder.inside_begin_end()) return false;
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

/// The arguments of glMap1 and glMap2; the second of each pair is 1 for a curve.
struct MapCall {
  unsigned dimensions;
  GLenum target;
  std::array<float, 4> domain;
  std::array<GLint, 2> stride, order;

  unsigned map() const { return target - (dimensions == 1 ? GL_MAP1_COLOR_4 : GL_MAP2_COLOR_4); }
};

GLenum map_error(const MapCall& call) {
  if (call.map() >= kMapCount) return GL_INVALID_ENUM;
  for (unsigned i = 0; i < call.dimensions; ++i) {
    if (call.domain[2 * i] == call.domain[2 * i + 1]) return GL_INVALID_VALUE;
    if (call.stride[i] < static_cast<GLint>(map_components(call.map()))) return GL_INVALID_VALUE;
    if (call.order[i] < 1 || call.order[i] > kMaxEvalOrder) return GL_INVALID_VALUE;
  }
  return GL_NO_ERROR;
}

void define_map(Context& c, const MapCall& call, const std::vector<float>* points) {
  if (inside(c)) return;
  if (const GLenum error = map_error(call)) return raise_error(c, error);
  if (c.active_texture != 0) return raise_error(c, GL_INVALID_OPERATION);
  if (!points) return;
  c.evaluators.maps[call.dimensions - 1][call.map()] = {call.order, call.domain, *points};
}

/// The control points as the list keeps them: tightly packed floats.
template <typename T>
void map_in(Context& c, const MapCall& call, const T* points) {
  std::shared_ptr<std::vector<float>> kept;
  if (points && map_error(call) == GL_NO_ERROR) {
    kept = std::make_shared<std::vector<float>>();
    for (GLint i = 0; i < call.order[0]; ++i)
      for (GLint j = 0; j < call.order[1]; ++j) {
        const std::ptrdiff_t at = std::ptrdiff_t{i} * call.stride[0] +
                                  (call.dimensions == 2 ? std::ptrdiff_t{j} * call.stride[1] : 0);
        for (unsigned component = 0; component < map_components(call.map()); ++component)
          kept->push_back(static_cast<float>(points[at + component]));
      }
    c.lists.keep(kept);
  }
  const std::vector<float>* const taken = kept.get();
  dispatch<define_map>(call, taken);
}

template <typename T>
void map(const MapCall& call, const T* points) {
  with_context([&](Context& c) { map_in(c, call, points); });
}

template <typename T>
void map1(GLenum target, T u1, T u2, GLint stride, GLint order, const T* points) {
  map({1, target, {static_cast<float>(u1), static_cast<float>(u2), 0, 1}, {stride, 0}, {order, 1}},
      points);
}

template <typename T>
void map2(GLenum target, T u1, T u2, GLint ustride, GLint uorder, T v1, T v2, GLint vstride,
          GLint vorder, const T* points) {
  map({2,
       target,
       {static_cast<float>(u1), static_cast<float>(u2), static_cast<float>(v1),
        static_cast<float>(v2)},
       {ustride, vstride},
       {uorder, vorder}},
      points);
}

void map_grid(Context& c, unsigned dimensions, std::array<GLint, 2> segments,
              std::array<float, 4> domain) {
  if (inside(c)) return;
  for (unsigned i = 0; i < dimensions; ++i)
    if (segments[i] < 1) return raise_error(c, GL_INVALID_VALUE);
  EvaluatorModes& modes = c.evaluators.modes;
  const unsigned first = dimensions - 1;  // grids 1 and 2 are the surface's
  for (unsigned i = 0; i < dimensions; ++i) {
    modes.segments[first + i] = segments[i];
    modes.grid[2 * (first + i)] = domain[2 * i];
    modes.grid[2 * (first + i) + 1] = domain[2 * i + 1];
  }
}

void mesh1(Context& c, GLenum mode, GLint p1, GLint p2) {
  if (inside(c)) return;
  if (mode != GL_POINT && mode != GL_LINE) return raise_error(c, GL_INVALID_ENUM);
  eval_mesh1(c, mode, p1, p2);
}

void mesh2(Context& c, GLenum mode, GLint p1, GLint p2, GLint q1, GLint q2) {
  if (inside(c)) return;
  if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL)
    return raise_error(c, GL_INVALID_ENUM);
  eval_mesh2(c, mode, p1, p2, q1, q2);
}

template <typename T>
T from_float(float value) {
  if constexpr (std::is_floating_point_v<T>) return value;
  else return static_cast<T>(std::lround(value));
}

template <typename T>
void get_map(Context& c, GLenum target, GLenum query, T* values) {
  if (inside(c)) return;
  unsigned dimensions = 1;
  GLenum map = target - GL_MAP1_COLOR_4;
  if (map >= kMapCount) {
    dimensions = 2;
    map = target - GL_MAP2_COLOR_4;
  }
  if (map >= kMapCount) return raise_error(c, GL_INVALID_ENUM);
  const Polynomial& polynomial = c.evaluators.maps[dimensions - 1][map];
  if (query != GL_COEFF && query != GL_ORDER && query != GL_DOMAIN)
    return raise_error(c, GL_INVALID_ENUM);
  if (!values) return;
  if (query == GL_COEFF)
    for (const float value : polynomial.points) *values++ = from_float<T>(value);
  else if (query == GL_ORDER)
    for (unsigned i = 0; i < dimensions; ++i) values[i] = static_cast<T>(polynomial.order[i]);
  else
    for (unsigned i = 0; i < 2 * dimensions; ++i) values[i] = from_float<T>(polynomial.domain[i]);
}

void coord1(float u) { dispatch<eval_coord>(1u, u, 0.0f); }
void coord2(float u, float v) { dispatch<eval_coord>(2u, u, v); }

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglMap1f(GLenum target, GLfloat u1, GLfloat u2, GLint stride,
                                               GLint order, const GLfloat* points) {
  map1(target, u1, u2, stride, order, points);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMap1d(GLenum target, GLdouble u1, GLdouble u2,
                                               GLint stride, GLint order, const GLdouble* points) {
  map1(target, u1, u2, stride, order, points);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMap2f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride,
                                               GLint uorder, GLfloat v1, GLfloat v2, GLint vstride,
                                               GLint vorder, const GLfloat* points) {
  map2(target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMap2d(GLenum target, GLdouble u1, GLdouble u2,
                                               GLint ustride, GLint uorder, GLdouble v1,
                                               GLdouble v2, GLint vstride, GLint vorder,
                                               const GLdouble* points) {
  map2(target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalCoord1f(GLfloat u) { coord1(u); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalCoord1d(GLdouble u) { coord1(static_cast<float>(u)); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalCoord1fv(const GLfloat* u) { coord1(u[0]); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalCoord1dv(const GLdouble* u) {
  coord1(static_cast<float>(u[0]));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalCoord2f(GLfloat u, GLfloat v) { coord2(u, v); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalCoord2d(GLdouble u, GLdouble v) {
  coord2(static_cast<float>(u), static_cast<float>(v));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalCoord2fv(const GLfloat* u) { coord2(u[0], u[1]); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalCoord2dv(const GLdouble* u) {
  coord2(static_cast<float>(u[0]), static_cast<float>(u[1]));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMapGrid1f(GLint un, GLfloat u1, GLfloat u2) {
  dispatch<map_grid>(1u, std::array{un, 1}, std::array{u1, u2, 0.0f, 1.0f});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMapGrid1d(GLint un, GLdouble u1, GLdouble u2) {
  lglMapGrid1f(un, static_cast<float>(u1), static_cast<float>(u2));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMapGrid2f(GLint un, GLfloat u1, GLfloat u2, GLint vn,
                                                   GLfloat v1, GLfloat v2) {
  dispatch<map_grid>(2u, std::array{un, vn}, std::array{u1, u2, v1, v2});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMapGrid2d(GLint un, GLdouble u1, GLdouble u2, GLint vn,
                                                   GLdouble v1, GLdouble v2) {
  lglMapGrid2f(un, static_cast<float>(u1), static_cast<float>(u2), vn, static_cast<float>(v1),
               static_cast<float>(v2));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalPoint1(GLint i) { dispatch<eval_point>(1u, i, 0); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalPoint2(GLint i, GLint j) {
  dispatch<eval_point>(2u, i, j);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalMesh1(GLenum mode, GLint i1, GLint i2) {
  dispatch<mesh1>(mode, i1, i2);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEvalMesh2(GLenum mode, GLint i1, GLint i2, GLint j1,
                                                   GLint j2) {
  dispatch<mesh2>(mode, i1, i2, j1, j2);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetMapfv(GLenum target, GLenum query, GLfloat* v) {
  execute_now<get_map<GLfloat>>(target, query, v);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetMapdv(GLenum target, GLenum query, GLdouble* v) {
  execute_now<get_map<GLdouble>>(target, query, v);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetMapiv(GLenum target, GLenum query, GLint* v) {
  execute_now<get_map<GLint>>(target, query, v);
}
