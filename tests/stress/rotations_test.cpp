// A thousand glRotatef on one matrix: the product keeps its shape, and lighting with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <vector>

#include "oracle/random.hpp"
#include "oracle/sampler.hpp"
#include "oracle/single_vertex.hpp"

namespace oracle {
namespace {

using legacy_gl::test::CoreContext;
using legacy_gl::test::MesaContext;
using legacy_gl::test::PixelFormat;
using legacy_gl::test::RenderContext;

struct Rotations {
  std::vector<std::array<float, 4>> turns;  // degrees, axis
  Matrix4 product = identity_matrix;        // in double, from the float values
};

Rotations thousand_rotations() {
  Random random(11, 0);
  Rotations rotations;
  glm::dmat4 product(1.0);
  for (int i = 0; i < 1000; ++i) {
    const auto axis = random.unit_vector();
    const float degrees = random.uniform(-180, 180);
    rotations.turns.push_back({degrees, axis[0], axis[1], axis[2]});
    // GL 2.1 spec 2.11.2: the axis is made unit length first.
    product =
        glm::rotate(product, glm::radians(double(degrees)),
                    glm::normalize(glm::dvec3(double(axis[0]), double(axis[1]), double(axis[2]))));
  }
  for (std::size_t i = 0; i < 16; ++i) rotations.product[i] = glm::value_ptr(product)[i];
  return rotations;
}

double largest_error(RenderContext& context) {
  const Rotations rotations = thousand_rotations();
  State state;
  Light light;
  light.position_specified = {1, 2, 3, 1};
  state.lights = {light};
  state.front.diffuse = {0.5f, 0.5f, 0.5f, 1};
  state.front.specular = {0.3f, 0.3f, 0.3f, 1};
  state.front.shininess = 50;
  state.back = state.front;
  double largest = 0;
  Random random(12, 0);
  for (int i = 0; i < 50; ++i) {
    Vertex vertex;
    vertex.normal_object = random.unit_vector();
    apply_state(context.gl, state, identity_matrix);
    state.modelview = rotations.product;
    const GlFunctions& gl = context.gl;
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.PointSize(8);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadIdentity();
    for (const auto& turn : rotations.turns) gl.Rotatef(turn[0], turn[1], turn[2], turn[3]);
    gl.Begin(GL_POINTS);
    gl.Normal3fv(vertex.normal_object.data());
    gl.Vertex4fv(vertex.position_object.data());
    gl.End();
    const auto picture = context.read_float();
    const Color color{picture.floats[0], picture.floats[1], picture.floats[2], picture.floats[3]};
    largest = std::max(largest, difference_steps(color, expected_color(state, vertex)));
    state.modelview = identity_matrix;
  }
  return largest;
}

TEST(ThousandRotations, KeepTheLight) {
  MesaContext mesa(2, 2, PixelFormat::rgba32f);
  CoreContext core(2, 2, PixelFormat::rgba32f);
  mesa.make_current();
  const double of_mesa = largest_error(mesa);
  core.make_current();
  const double of_ours = largest_error(core);
  std::printf("Mesa %.2e ours %.2e\n", of_mesa, of_ours);
  // A double product is off by 1e-13; what is left is the float arithmetic of one vertex.
  EXPECT_LT(of_ours, 1e-3);
}

}  // namespace
}  // namespace oracle
