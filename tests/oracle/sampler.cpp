#include "oracle/sampler.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

namespace oracle {
namespace {

// Nearer than this to a jump of the equation, float arithmetic may fall on either side: a few
// roundings of a cosine.
constexpr double jump_tolerance = 2e-6;

bool faces_back(const Batch& batch, std::uint32_t number, int i) {
  return batch.alternate_faces && (std::uint32_t(i) + number) % 2 != 0;
}

// The vertex and two more of its own: a triangle around the middle of its pixel, counter-clockwise
// for a front face. The provoking vertex, the last one, is the sample.
void append_triangle(std::vector<Vertex>& out, const Batch& batch, int i, bool back) {
  Vertex sample = batch.vertices[std::size_t(i)];
  const float pixel = batch.object_radius * (2.f / batch_side);
  // The sample lies left of and below the pixel's middle; the other two lie beyond it.
  const float middle_x = pixel * (float(i % batch_side) + 0.5f) - batch.object_radius;
  const float middle_y = pixel * (float(i / batch_side) + 0.5f) - batch.object_radius;
  Vertex a = sample, b = sample;
  a.position_object[0] = middle_x + 0.7f * pixel;
  a.position_object[1] = middle_y - 0.3f * pixel;
  b.position_object[0] = middle_x - 0.3f * pixel;
  b.position_object[1] = middle_y + 0.7f * pixel;
  if (back) std::swap(a, b);
  out.insert(out.end(), {a, b, sample});
}

}  // namespace

Matrix4 placing_projection(const Matrix4& modelview, float object_radius) {
  const double s = 1 / double(object_radius);
  // z is left out of clip space (0 lies between the near and the far plane).
  const glm::dmat4 place(s, 0, 0, 0, 0, s, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1);
  const glm::dmat4 projection = place * glm::inverse(glm::make_mat4(modelview.data()));
  Matrix4 out;
  std::copy_n(glm::value_ptr(projection), 16, out.begin());
  return out;
}

std::vector<Vertex> drawn_vertices(const Batch& batch, std::uint32_t number) {
  if (!batch.alternate_faces) return batch.vertices;
  std::vector<Vertex> triangles;
  triangles.reserve(3 * batch.vertices.size());
  for (int i = 0; i < batch_size; ++i)
    append_triangle(triangles, batch, i, faces_back(batch, number, i));
  return triangles;
}

GLenum drawn_mode(const Batch& batch) { return batch.alternate_faces ? GL_TRIANGLES : GL_POINTS; }

void draw_batch(const GlFunctions& gl, const Batch& batch, std::uint32_t number, int tiles_across) {
  const auto across = std::uint32_t(tiles_across);
  gl.Viewport(GLint(number % across) * batch_side, GLint(number / across % across) * batch_side,
              batch_side, batch_side);
  apply_state(gl, batch.state, placing_projection(batch.state.modelview, batch.object_radius));
  gl.Disable(GL_DITHER);
  gl.ShadeModel(GL_FLAT);

  const std::vector<Vertex> vertices = drawn_vertices(batch, number);
  constexpr auto stride = GLsizei(sizeof(Vertex));
  gl.VertexPointer(4, GL_FLOAT, stride, vertices.front().position_object.data());
  gl.NormalPointer(GL_FLOAT, stride, vertices.front().normal_object.data());
  gl.ColorPointer(4, GL_FLOAT, stride, vertices.front().color.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.DrawArrays(drawn_mode(batch), 0, GLsizei(vertices.size()));
}

double ErrorStatistics::root_mean_square() const {
  return samples == 0 ? 0 : std::sqrt(sum_of_squares / (3 * double(samples)));
}

void ErrorStatistics::add(const ErrorStatistics& other) {
  if (other.largest > largest) {
    largest = other.largest;
    worst_batch = other.worst_batch;
    worst_vertex = other.worst_vertex;
  }
  sum_of_squares += other.sum_of_squares;
  largest_alpha = std::max(largest_alpha, other.largest_alpha);
  samples += other.samples;
  skipped += other.skipped;
}

ErrorStatistics judge_batch(const Batch& batch, std::uint32_t number, const float* tile,
                            std::size_t stride) {
  ErrorStatistics statistics;
  statistics.worst_batch = number;
  for (int i = 0; i < batch_size; ++i) {
    const Result result = evaluate(batch.state, batch.vertices[std::size_t(i)]);
    if (!result.defined || result.distance_to_jump < jump_tolerance) {
      ++statistics.skipped;
      continue;
    }
    ++statistics.samples;
    const auto& expected = faces_back(batch, number, i) ? result.back : result.front;
    const float* pixel =
        tile + std::size_t(i / batch_side) * stride + 4 * std::size_t(i % batch_side);
    for (std::size_t c = 0; c < 4; ++c) {
      const double sum = std::min(expected.primary_clamped[c] + expected.secondary_clamped[c], 1.0);
      const double got = std::clamp(double(pixel[c]), 0.0, 1.0);
      // A NaN in the picture compares unequal to everything: the largest error there is.
      const double error = pixel[c] == pixel[c] ? 255 * std::abs(got - sum) : 255;
      if (c == 3) {
        statistics.largest_alpha = std::max(statistics.largest_alpha, error);
        continue;
      }
      statistics.sum_of_squares += error * error;
      if (error > statistics.largest) {
        statistics.largest = error;
        statistics.worst_vertex = i;
      }
    }
  }
  return statistics;
}

ErrorStatistics run_class(const LightingClass& lighting_class, std::uint32_t seed,
                          int picture_count, int tiles_across, const SampleTarget& target) {
  ErrorStatistics total;
  const auto tiles = std::uint32_t(tiles_across * tiles_across);
  const std::size_t stride = 4 * std::size_t(tiles_across * batch_side);
  std::vector<Batch> batches(tiles);
  for (std::uint32_t picture = 0; picture < std::uint32_t(picture_count); ++picture) {
    target.begin();
    for (std::uint32_t t = 0; t < tiles; ++t) {
      batches[t] = lighting_class.make(seed, picture * tiles + t);
      target.draw(batches[t], picture * tiles + t);
    }
    const float* pixels = target.read();
    for (std::uint32_t t = 0; t < tiles; ++t) {
      const auto across = std::uint32_t(tiles_across);
      const std::size_t row = std::size_t(t / across) * batch_side;
      const std::size_t column = std::size_t(t % across) * batch_side;
      total.add(
          judge_batch(batches[t], picture * tiles + t, pixels + row * stride + 4 * column, stride));
    }
  }
  return total;
}

}  // namespace oracle
