// One lit vertex of any state, at any eye-space position, drawn so that it alone fills the
// viewport.
#pragma once

#include <array>

#include "oracle/oracle.hpp"
#include "support/contexts.hpp"

namespace oracle {

enum class Facing { front, back };

// A projection under which the vertex lands in the middle of the viewport, with w = 1.
Matrix4 pinning_projection(const Matrix4& modelview, const std::array<float, 4>& position_object);

// Clears, draws the vertex with the state that is set (a front-facing one as a point, a back-facing
// one as the provoking vertex of a flat triangle around it), and returns its colour. Loads the
// modelview and the projection; touches no lighting state.
Color draw_vertex(legacy_gl::test::RenderContext& context, const Matrix4& modelview,
                  const Vertex& vertex, Facing facing = Facing::front);

// The same after all of `state` was applied.
Color draw_lit_vertex(legacy_gl::test::RenderContext& context, const State& state,
                      const Vertex& vertex, Facing facing = Facing::front);

// What the picture should hold: the clamped sum of primary and secondary colour.
std::array<double, 4> expected_color(const State& state, const Vertex& vertex,
                                     Facing facing = Facing::front);

// Largest difference of a channel in units of 1/255, after clamping to [0,1]; 255 when one is NaN.
double difference_steps(const Color& color, const std::array<double, 4>& expected);

}  // namespace oracle
