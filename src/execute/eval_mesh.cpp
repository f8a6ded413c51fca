// Grids of evaluated points (GL 2.1 spec 5.1).
#include "execute/begin_end.hpp"
#include "execute/eval_coord.hpp"
#include "record/pending.hpp"

namespace legacy_gl {

namespace {

/// The ends of the grid are met exactly. Grid 0 is the curve's, 1 and 2 are the surface's.
float grid_coordinate(const EvaluatorModes& modes, unsigned grid, GLint i) {
  const float begin = modes.grid[2 * grid], end = modes.grid[2 * grid + 1];
  const GLint count = modes.segments[grid];
  if (i == count) return end;
  return begin + static_cast<float>(i) * ((end - begin) / static_cast<float>(count));
}

/// Quads, split as the reference splits them where that shows.
GLenum strip_mode(const Context& context) {
  const bool colored =
      context.lighting.enabled || context.evaluators.modes.enabled[1] & 1u << kMapColor4;
  const bool whole =
      is_unfilled(context.raster.polygon) || (colored && context.lighting.shade_model == GL_FLAT);
  return whole ? GL_QUAD_STRIP : GL_TRIANGLE_STRIP;
}

bool draws_vertices(const Context& context, unsigned dimensions) {
  constexpr unsigned kVertexMaps = 1u << kMapVertex3 | 1u << kMapVertex4;
  return context.evaluators.modes.enabled[dimensions - 1] & kVertexMaps;
}

}  // namespace

void eval_point(Context& context, unsigned dimensions, GLint i, GLint j) {
  const EvaluatorModes& modes = context.evaluators.modes;
  if (dimensions == 1) return eval_coord(context, 1, grid_coordinate(modes, 0, i), 0);
  eval_coord(context, 2, grid_coordinate(modes, 1, i), grid_coordinate(modes, 2, j));
}

void eval_mesh1(Context& context, GLenum mode, GLint p1, GLint p2) {
  if (!draws_vertices(context, 1)) return;
  context.recorder.begin(context, mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP);
  for (GLint i = p1; i <= p2; ++i) eval_point(context, 1, i, 0);
  context.recorder.end(context);
}

void eval_mesh2(Context& context, GLenum mode, GLint p1, GLint p2, GLint q1, GLint q2) {
  if (!draws_vertices(context, 2)) return;
  Recorder& recorder = context.recorder;
  if (mode == GL_FILL) {
    for (GLint j = q1; j < q2; ++j) {
      recorder.begin(context, strip_mode(context));
      for (GLint i = p1; i <= p2; ++i) {
        eval_point(context, 2, i, j);
        eval_point(context, 2, i, j + 1);
      }
      recorder.end(context);
    }
    return;
  }
  const GLenum primitive = mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP;
  for (GLint j = q1; j <= q2; ++j) {
    recorder.begin(context, primitive);
    for (GLint i = p1; i <= p2; ++i) eval_point(context, 2, i, j);
    recorder.end(context);
  }
  if (mode == GL_POINT) return;
  for (GLint i = p1; i <= p2; ++i) {
    recorder.begin(context, primitive);
    for (GLint j = q1; j <= q2; ++j) eval_point(context, 2, i, j);
    recorder.end(context);
  }
}

}  // namespace legacy_gl
