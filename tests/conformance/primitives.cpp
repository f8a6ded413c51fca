// Each of the ten primitives, flat and smooth, lit and unlit; then what is left over when the
// number of vertices does not fit. The flat ones show the provoking vertex (GL 2.1 spec
// table 2.12).
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

struct Primitive {
  const char* name;
  GLenum mode;
};

constexpr Primitive primitives[] = {
    {"points", GL_POINTS},
    {"lines", GL_LINES},
    {"line_strip", GL_LINE_STRIP},
    {"line_loop", GL_LINE_LOOP},
    {"triangles", GL_TRIANGLES},
    {"triangle_strip", GL_TRIANGLE_STRIP},
    {"triangle_fan", GL_TRIANGLE_FAN},
    {"quads", GL_QUADS},
    {"quad_strip", GL_QUAD_STRIP},
    {"polygon", GL_POLYGON},
};

bool is_round(GLenum mode) {
  return mode == GL_TRIANGLE_FAN || mode == GL_POLYGON || mode == GL_LINE_LOOP;
}

// Fans and polygons go round a convex ring; the others zigzag from left to right, in the order that
// the primitive wants.
void position(GLenum mode, int index, int count, float* x, float* y) {
  if (is_round(mode)) {
    const float angle = 6.2831853F * static_cast<float>(index) / static_cast<float>(count) + 0.2F;
    *x = 0.9F * std::cos(angle);
    *y = 0.85F * std::sin(angle);
    return;
  }
  if (mode == GL_QUADS) {
    const int corner = index % 4;
    *x = -0.9F + 0.6F * static_cast<float>(index / 4) + (corner == 1 || corner == 2 ? 0.47F : 0);
    *y = (corner >= 2 ? 0.7F : -0.8F) + 0.05F * static_cast<float>(corner);
    return;
  }
  *x = -0.95F + 1.9F * static_cast<float>(index) / static_cast<float>(count);
  *y = (index % 2 == 0 ? -0.75F : 0.65F) + 0.02F * static_cast<float>(index % 12);
}

void emit_vertices(const GlFunctions& gl, GLenum mode, int count) {
  for (int i = 0; i < count; ++i) {
    float x = 0;
    float y = 0;
    position(mode, i, count, &x, &y);
    const float f = static_cast<float>(i);
    gl.Color4f(0.5F + 0.5F * std::sin(2.1F * f), 0.5F + 0.5F * std::cos(1.3F * f),
               0.5F + 0.5F * std::sin(0.7F * f + 1), 1);
    gl.Normal3f(0.7F * std::sin(1.1F * f), 0.6F * std::cos(1.7F * f), 0.6F);
    gl.Vertex3f(x, y, 0.1F * std::sin(f));
  }
}

void draw_primitive(const GlFunctions& gl, GLenum mode, int count) {
  gl.Begin(mode);
  emit_vertices(gl, mode, count);
  gl.End();
}

Scene primitive_scene(const Primitive& primitive, bool flat, bool lit, int count,
                      const std::string& name) {
  return {name,
          [=](const GlFunctions& gl) {
            if (lit) {
              begin_lit_scene(gl);
              gl.Enable(GL_NORMALIZE);
            } else {
              begin_flat_scene(gl);
            }
            gl.ShadeModel(flat ? GL_FLAT : GL_SMOOTH);
            gl.PointSize(4);
            draw_primitive(gl, primitive.mode, count);
          },
          {.few_colors = flat}};
}

}  // namespace

std::vector<Scene> primitives_scenes() {
  std::vector<Scene> scenes;
  for (const Primitive& primitive : primitives) {
    for (const bool lit : {false, true})
      for (const bool flat : {false, true})
        scenes.push_back(primitive_scene(
            primitive, flat, lit, 12,
            std::string(primitive.name) + (flat ? "_flat" : "_smooth") + (lit ? "_lit" : "")));
  }
  // 11 is one short of a line, a triangle, a quad and a quad strip's pair.
  for (const Primitive& primitive : primitives)
    scenes.push_back(primitive_scene(primitive, true, false, 11,
                                     std::string(primitive.name) + "_with_11_vertices"));
  for (const Primitive& primitive : primitives) {
    scenes.push_back({std::string(primitive.name) + "_of_0_to_4_vertices",
                      [mode = primitive.mode](const GlFunctions& gl) {
                        begin_flat_scene(gl);
                        gl.PointSize(3);
                        for (int count = 0; count <= 4; ++count) {
                          gl.LoadIdentity();
                          gl.Translatef(-0.8F + 0.4F * static_cast<float>(count), 0.3F, 0);
                          gl.Scalef(0.18F, 0.5F, 1);
                          draw_primitive(gl, mode, count);
                        }
                      },
                      {.few_colors = true}});
  }
  scenes.push_back({"mixed_in_a_row", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      int index = 0;
                      for (const Primitive& primitive : primitives) {
                        gl.LoadIdentity();
                        gl.Translatef(-0.8F + 0.4F * static_cast<float>(index % 5),
                                      index < 5 ? -0.5F : 0.5F, 0);
                        gl.Scalef(0.18F, 0.4F, 1);
                        draw_primitive(gl, primitive.mode, 8);
                        ++index;
                      }
                    }});
  scenes.push_back({"same_primitive_many_times", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      for (int row = 0; row < 8; ++row) {
                        for (int column = 0; column < 8; ++column) {
                          const float x = -0.9F + 0.23F * static_cast<float>(column);
                          const float y = -0.9F + 0.23F * static_cast<float>(row);
                          gl.Begin(GL_QUADS);
                          color_by_position(gl, x, y, 0.3F);
                          gl.Vertex2f(x, y);
                          gl.Vertex2f(x + 0.18F, y + 0.03F);
                          gl.Vertex2f(x + 0.2F, y + 0.2F);
                          gl.Vertex2f(x - 0.02F, y + 0.18F);
                          gl.End();
                        }
                      }
                    }});
  // A fan of 500 and a strip of 2000: more than one small buffer holds.
  scenes.push_back({"polygon_of_500", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      draw_primitive(gl, GL_POLYGON, 500);
                    }});
  scenes.push_back({"long_quad_strip", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      draw_primitive(gl, GL_QUAD_STRIP, 2000);
                    }});
  scenes.push_back({"quads_not_planar", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.Rotatef(50, 1, 0.4F, 0);
                      gl.Begin(GL_QUADS);
                      for (int i = 0; i < 16; ++i) {
                        const int corner = i % 4;
                        const float x = -0.9F + 0.45F * static_cast<float>(i / 4);
                        gl.Normal3f(0.3F * static_cast<float>(corner - 1), 0.4F, 0.8F);
                        gl.Vertex3f(x + (corner == 1 || corner == 2 ? 0.4F : 0),
                                    corner >= 2 ? 0.8F : -0.8F, corner % 2 == 0 ? 0.3F : -0.3F);
                      }
                      gl.End();
                    }});
  scenes.push_back({"clipped_by_every_side", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.Scalef(1.5F, 1.6F, 3);
                      int index = 0;
                      for (const Primitive& primitive : primitives) {
                        gl.Rotatef(13.0F * static_cast<float>(index++), 0, 0.2F, 1);
                        draw_primitive(gl, primitive.mode, 12);
                      }
                    }});
  return scenes;
}

}  // namespace legacy_gl::test
