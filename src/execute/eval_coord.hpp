#pragma once
#include "evaluator/evaluator.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// A vertex at a point of the enabled maps of `dimensions` parameters; nothing where no vertex map
/// is enabled. The current values stay (GL 2.1 spec 5.1).
void eval_coord(legacy_gl_context& context, unsigned dimensions, float u, float v);

/// The grid's point (i, j).
void eval_point(legacy_gl_context& context, unsigned dimensions, GLint i, GLint j);

/// The part of the grid as points, lines or quads.
void eval_mesh1(legacy_gl_context& context, GLenum mode, GLint p1, GLint p2);
void eval_mesh2(legacy_gl_context& context, GLenum mode, GLint p1, GLint p2, GLint q1, GLint q2);

}  // namespace legacy_gl
