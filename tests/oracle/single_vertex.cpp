#include "oracle/single_vertex.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include "oracle/sampler.hpp"

namespace oracle {
namespace {

glm::dvec4 eye_position(const Matrix4& modelview, const std::array<float, 4>& p) {
  return glm::make_mat4(modelview.data()) *
         glm::dvec4(double(p[0]), double(p[1]), double(p[2]), double(p[3]));
}

Matrix4 to_array(const glm::dmat4& m) {
  Matrix4 out;
  std::copy_n(glm::value_ptr(m), 16, out.begin());
  return out;
}

// The projection that takes three eye positions to three clip positions: the clip positions times
// the least-squares inverse of the eye positions.
Matrix4 three_point_projection(const std::array<glm::dvec4, 3>& eye,
                               const std::array<glm::dvec4, 3>& clip) {
  glm::dmat3 gram(0.0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) gram[j][i] = glm::dot(eye[std::size_t(i)], eye[std::size_t(j)]);
  }
  const glm::dmat3 inverse = glm::inverse(gram);
  glm::dmat4 projection(0.0);
  for (int i = 0; i < 3; ++i) {
    glm::dvec4 dual(0.0);
    for (int j = 0; j < 3; ++j) dual += inverse[j][i] * eye[std::size_t(j)];
    projection += glm::outerProduct(clip[std::size_t(i)], dual);
  }
  return to_array(projection);
}

void send(const GlFunctions& gl, const Vertex& vertex) {
  gl.Normal3fv(vertex.normal_object.data());
  gl.Vertex4fv(vertex.position_object.data());
}

void load_matrices(const GlFunctions& gl, const Matrix4& modelview, const Matrix4& projection) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadMatrixd(projection.data());
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadMatrixd(modelview.data());
}

void draw_back_facing(const GlFunctions& gl, const Matrix4& modelview, const Vertex& vertex) {
  Vertex right = vertex, above = vertex;
  right.position_object[0] += 1;
  above.position_object[1] += 1;
  // A triangle that covers the viewport, clockwise in the order in which it is sent.
  const std::array<glm::dvec4, 3> clip{glm::dvec4(-3, 3, 0, 1), glm::dvec4(3, 3, 0, 1),
                                       glm::dvec4(0, -3, 0, 1)};
  load_matrices(gl, modelview,
                three_point_projection({eye_position(modelview, right.position_object),
                                        eye_position(modelview, above.position_object),
                                        eye_position(modelview, vertex.position_object)},
                                       clip));
  gl.ShadeModel(GL_FLAT);
  gl.Begin(GL_TRIANGLES);
  send(gl, right);
  send(gl, above);
  send(gl, vertex);
  gl.End();
}

}  // namespace

Matrix4 pinning_projection(const Matrix4& modelview, const std::array<float, 4>& position_object) {
  const glm::dvec4 eye = eye_position(modelview, position_object);
  // Scaled first: the square of a position of 1e200 is still a number.
  const double largest =
      std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z), std::abs(eye.w)});
  const glm::dvec4 scaled = eye / largest;
  const glm::dvec4 to_one = scaled / (glm::dot(scaled, scaled) * largest);
  return to_array(glm::outerProduct(glm::dvec4(0, 0, 0, 1), to_one));
}

Color draw_vertex(legacy_gl::test::RenderContext& context, const Matrix4& modelview,
                  const Vertex& vertex, Facing facing) {
  const GlFunctions& gl = context.gl;
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Disable(GL_DITHER);
  if (facing == Facing::back) {
    draw_back_facing(gl, modelview, vertex);
  } else {
    load_matrices(gl, modelview, pinning_projection(modelview, vertex.position_object));
    gl.PointSize(float(2 * std::max(context.width(), context.height())));
    gl.Begin(GL_POINTS);
    send(gl, vertex);
    gl.End();
  }
  const auto picture = context.read_float();
  Color color;
  const std::size_t middle = std::size_t(context.height() / 2) * std::size_t(context.width()) +
                             std::size_t(context.width() / 2);
  std::copy_n(picture.floats.begin() + std::ptrdiff_t(4 * middle), 4, color.begin());
  return color;
}

Color draw_lit_vertex(legacy_gl::test::RenderContext& context, const State& state,
                      const Vertex& vertex, Facing facing) {
  // Before the state: colour material takes it while it is enabled.
  context.gl.Disable(GL_COLOR_MATERIAL);
  context.gl.Color4fv(vertex.color.data());
  apply_state(context.gl, state, identity_matrix);
  context.gl.Color4fv(vertex.color.data());
  return draw_vertex(context, state.modelview, vertex, facing);
}

std::array<double, 4> expected_color(const State& state, const Vertex& vertex, Facing facing) {
  const Result result = evaluate(state, vertex);
  const FaceColors<double>& colors = facing == Facing::front ? result.front : result.back;
  std::array<double, 4> sum;
  for (std::size_t c = 0; c < 4; ++c) {
    sum[c] = std::min(colors.primary_clamped[c] + colors.secondary_clamped[c], 1.0);
  }
  return sum;
}

double difference_steps(const Color& color, const std::array<double, 4>& expected) {
  double largest = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    if (color[c] != color[c]) return 255;
    largest =
        std::max(largest, 255 * std::abs(std::clamp(double(color[c]), 0.0, 1.0) - expected[c]));
  }
  return largest;
}

}  // namespace oracle
