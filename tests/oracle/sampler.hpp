// Float colours of single lit vertices, out of anything that speaks OpenGL 1.x.
//
// Each vertex is drawn so that it alone colours one pixel of a float colour buffer: as a point, or
// (to see back faces) as the provoking vertex of a small flat triangle. The projection undoes the
// modelview and puts the object-space x and y of the batch's grid on the batch's tile of the
// viewport, so that the eye-space position stays whatever the class wants.
#pragma once

#include <functional>
#include <vector>

#include "oracle/lighting_classes.hpp"
#include "support/gl_functions.hpp"

namespace oracle {

// Every lighting, material, matrix and enable state of `state`, by GL calls alone. `projection` is
// loaded as it is. Lights beyond those of the state are disabled.
void apply_state(const GlFunctions& gl, const State& state, const Matrix4& projection);

// Places object-space [-radius, radius]^3 on the viewport whatever the modelview is.
Matrix4 placing_projection(const Matrix4& modelview, float object_radius);

// What draw_batch draws, for targets that do not speak OpenGL 1.x: separate points, or triangles
// of which the last vertex is the sample.
std::vector<Vertex> drawn_vertices(const Batch& batch, std::uint32_t number);
GLenum drawn_mode(const Batch& batch);

// Draws batch `number` on its tile; the batches of one picture fill a square of tiles_across^2.
void draw_batch(const GlFunctions& gl, const Batch& batch, std::uint32_t number, int tiles_across);

// Largest and root mean square difference to the oracle over colour channels, in units of 1/255,
// after clamping to [0,1].
struct ErrorStatistics {
  double largest = 0;
  double sum_of_squares = 0;
  double largest_alpha = 0;
  std::uint64_t samples = 0;  // vertices that were judged
  std::uint64_t skipped = 0;  // not defined, or too near a jump of the equation
  std::uint32_t worst_batch = 0;
  int worst_vertex = 0;

  double root_mean_square() const;
  void add(const ErrorStatistics& other);
};

// What one batch should be against what a float RGBA picture holds; `stride` floats a row.
ErrorStatistics judge_batch(const Batch& batch, std::uint32_t number, const float* tile,
                            std::size_t stride);

// Runs `picture_count` pictures of tiles_across^2 batches of a class. `begin` makes the target
// current and clears it, `draw` draws batch `number` on its tile, `read` returns its width * width
// RGBA floats after all draws.
struct SampleTarget {
  std::function<void()> begin;
  std::function<void(const Batch& batch, std::uint32_t number)> draw;
  std::function<const float*()> read;
};

ErrorStatistics run_class(const LightingClass& lighting_class, std::uint32_t seed,
                          int picture_count, int tiles_across, const SampleTarget& target);

}  // namespace oracle
