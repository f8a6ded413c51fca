// Curves and surfaces.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

std::vector<double> control_points(Builder& b, int rows, int columns) {
  std::vector<double> points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      points.push_back(-0.8 + 1.6 * column / (columns - 1) + b.random.real(-0.1, 0.1));
      points.push_back(rows == 1 ? b.coordinate()
                                 : -0.8 + 1.6 * row / (rows - 1) + b.random.real(-0.1, 0.1));
      points.push_back(b.random.real(-0.5, 0.5));
    }
  return points;
}

void curve(Builder& b) {
  const int order = b.random.between(2, 5);
  b.call("Map1f", "GL_MAP1_VERTEX_3", 0, 1, 3, order, floats(control_points(b, 1, order)));
  b.call("Enable", "GL_MAP1_VERTEX_3");
  if (b.random.chance(50)) {
    b.call("MapGrid1f", 8, 0, 1);
    b.call("EvalMesh1", b.random.pick({"GL_LINE", "GL_POINT"}), 0, 8);
  } else {
    b.call("Begin", "GL_LINE_STRIP");
    for (int i = 0; i <= 6; ++i) b.call("EvalCoord1f", i / 6.0);
    b.call("End");
  }
  b.call("Disable", "GL_MAP1_VERTEX_3");
}

void surface(Builder& b) {
  const int order = b.random.between(2, 4);
  b.call("Map2f", "GL_MAP2_VERTEX_3", 0, 1, 3, order, 0, 1, 3 * order, order,
         floats(control_points(b, order, order)));
  b.call("Enable", "GL_MAP2_VERTEX_3");
  // Meshes are quads, whose diagonal depends on what else Mesa's draw clips.
  const bool colors = !b.traits.outside && !b.traits.clip_planes && b.random.chance(40);
  if (colors) {
    b.call("Map2f", "GL_MAP2_COLOR_4", 0, 1, 4, 2, 0, 1, 8, 2, floats(b.random.reals(16, 0.2, 1)));
    b.call("Enable", "GL_MAP2_COLOR_4");
  }
  if (b.traits.lit) b.enable("GL_AUTO_NORMAL", b.random.chance(60));
  b.call("MapGrid2f", 4, 0, 1, 5, 0, 1);
  // Points of a polygon mode that Mesa's lines would join: lines alone where polygons are not
  // filled.
  b.call("EvalMesh2",
         b.traits.unfilled ? "GL_LINE" : b.random.pick({"GL_FILL", "GL_LINE", "GL_POINT"}), 0, 4, 0,
         5);
  if (colors) b.call("Disable", "GL_MAP2_COLOR_4");
  b.call("Disable", "GL_MAP2_VERTEX_3");
}

}  // namespace

void draw_evaluators(Builder& b) {
  if (b.random.chance(50)) curve(b);
  else surface(b);
  // Mesa's evaluators change current values.
  const auto color = b.color();
  b.call(b.traits.color_components == 3 ? "Color3fv" : "Color4fv", floats(color));
  b.call("Normal3f", 0, 0, 1);
}

}  // namespace legacy_gl::fuzz
