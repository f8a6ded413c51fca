// Where Mesa departs from the specification (docs/deviations.md has the rows M1 … M9). `draw` is
// the case itself; `reference` asks for the same picture in a form that Mesa gets right. The test
// shows both: legacy_gl's `draw` equals Mesa's `reference`, and Mesa's `draw` does not.
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

Scene departure(std::string name, std::string row, Draw draw, Draw reference) {
  return {
      std::move(name),
      std::move(draw),
      {.mesa_departure = std::move(row), .reference = std::move(reference), .few_colors = true}};
}

constexpr Parameters black = vec(0, 0, 0);

// M1. With shininess 0 the specular factor is 1 wherever the light shines, so the specular term
// equals an ambient term of the light. On the patch every vertex faces the light, and no other
// ambient counts.
void begin_m1(const GlFunctions& gl) {
  begin_lit_scene(gl);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0.3F, 0.2F, 0.8F));
}
void attenuate(const GlFunctions& gl) { gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.7F); }
void confine(const GlFunctions& gl) {
  gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 52);
  gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 2);
}
Scene m1_scene(std::string name, void (*set)(const GlFunctions&)) {
  return departure(
      std::move(name), "M1",
      [set](const GlFunctions& gl) {
        begin_m1(gl);
        set(gl);
        use_material(gl, GL_FRONT, black, vec(0.2F, 0.3F, 0.4F), vec(0.4F, 0.3F, 0.2F), 0);
        draw_patch(gl);
      },
      [set](const GlFunctions& gl) {
        begin_m1(gl);
        set(gl);
        gl.Lightfv(GL_LIGHT0, GL_AMBIENT, vec(1, 1, 1));
        use_material(gl, GL_FRONT, vec(0.4F, 0.3F, 0.2F), vec(0.2F, 0.3F, 0.4F), black, 10);
        draw_patch(gl);
      });
}

// M2. The light stands straight above the patch's middle vertex. A cone of a degree holds just that
// vertex, and so do the smallest cones: the vertex on the axis is at the angle 0.
Scene m2_scene(std::string name, float cutoff_degrees) {
  const auto draw = [](const GlFunctions& gl, float cutoff) {
    begin_lit_scene(gl);
    gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0, 0, 1));
    gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, cutoff);
    draw_patch(gl, 4);
  };
  return departure(
      std::move(name), "M2", [=](const GlFunctions& gl) { draw(gl, cutoff_degrees); },
      [=](const GlFunctions& gl) { draw(gl, 1); });
}

// M3. (2x, 2y, 2z, 2) is the vertex (x, y, z).
void draw_homogeneous_patch(const GlFunctions& gl, float w) {
  begin_lit_scene(gl);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0.5F, 0.4F, 1.0F));
  gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.3F);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
  gl.Begin(GL_TRIANGLES);
  const Mesh mesh = sphere_mesh();
  for (const GLushort index : mesh.triangle_indices) {
    const MeshVertex& vertex = mesh.vertices[index];
    gl.Normal3fv(vertex.normal.data());
    gl.Vertex4f(w * vertex.position[0], w * vertex.position[1], w * vertex.position[2], w);
  }
  gl.End();
}

// A modelview with a perspective row. Points, since the interpolation across a triangle differs.
void draw_points_under_perspective(const GlFunctions& gl, bool in_the_modelview) {
  begin_lit_scene(gl);
  gl.LoadIdentity();
  gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0.5F, 0.4F, -2.0F));
  gl.PointSize(7);
  constexpr float perspective = -0.25F;
  if (in_the_modelview) {
    std::array<GLfloat, 16> matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, perspective, 0, 0, 0, 1};
    gl.LoadMatrixf(matrix.data());
  }
  gl.Begin(GL_POINTS);
  for (int i = 0; i < 25; ++i) {
    // Off the middle: a point exactly between two pixels would go by the last bit of x / w.
    const float x = 0.6F * static_cast<float>(i % 5 - 2) + 0.013F;
    const float y = 0.6F * static_cast<float>(i / 5 - 2) + 0.017F;
    const float z = -4.0F - 0.5F * static_cast<float>(i % 3);
    const float w = in_the_modelview ? 1.0F : perspective * z + 1.0F;
    gl.Normal3f(0.1F, 0.2F, 0.95F);
    gl.Vertex3f(x / w, y / w, z / w);
  }
  gl.End();
}

// M4. Normals that turn from the half vector but not from the light, which shines from behind. On
// the front two-sided lighting has no say.
void draw_m4(const GlFunctions& gl, bool two_sided) {
  begin_lit_scene(gl);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_sided ? GL_TRUE : GL_FALSE);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1, 0, -0.9F, 0));
  gl.Materialf(GL_FRONT, GL_SHININESS, 0);
  gl.Materialf(GL_BACK, GL_SHININESS, 10);
  gl.FrontFace(GL_CW);
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 8; ++i) {
    const float f = static_cast<float>(i);
    gl.Normal3f(-0.3F - 0.02F * f, 0.1F, -0.9F);
    gl.Vertex2f(-0.9F + 0.25F * f, i % 2 == 0 ? -0.8F : 0.8F);
  }
  gl.End();
}

// M5. Colour material takes the current colour when it is enabled.
void draw_m5(const GlFunctions& gl, bool color_first) {
  begin_lit_scene(gl);
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.1F, 0.1F, 0.9F));
  if (color_first) gl.Color4f(0.9F, 0.3F, 0.1F, 1);
  gl.ColorMaterial(GL_FRONT, GL_DIFFUSE);
  gl.Enable(GL_COLOR_MATERIAL);
  if (!color_first) gl.Color4f(0.9F, 0.3F, 0.1F, 1);
  draw_sphere(gl);
}

// M6. The tracked back material, and the same colour set as a material.
void draw_m6(const GlFunctions& gl, GLenum property, bool tracked) {
  begin_lit_scene(gl);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0.5F, 0.5F, 0.5F));
  const Parameters color = vec(0.8F, 0.4F, 0.2F);
  if (tracked) {
    gl.ColorMaterial(GL_BACK, property);
    gl.Enable(GL_COLOR_MATERIAL);
  } else {
    gl.Materialfv(GL_BACK, property, color);
  }
  gl.FrontFace(GL_CW);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 12; ++i) {
    const float angle = 2.0944F * static_cast<float>(i) + 0.3F * static_cast<float>(i / 3);
    if (tracked) gl.Color4fv(color);
    gl.Normal3f(0.3F * std::cos(angle), 0.3F * std::sin(angle), -0.9F);
    gl.Vertex3f(std::cos(angle), std::sin(angle), 0.1F * static_cast<float>(i / 3));
  }
  gl.End();
}
Scene m6_scene(std::string name, GLenum property) {
  return departure(
      std::move(name), "M6", [=](const GlFunctions& gl) { draw_m6(gl, property, true); },
      [=](const GlFunctions& gl) { draw_m6(gl, property, false); });
}

// M7. A power of two, so that the positions are the same to the last bit.
void draw_m7(const GlFunctions& gl, bool scaled) {
  begin_lit_scene(gl);
  constexpr float scale = 16777216.0F;
  if (scaled) {
    gl.Enable(GL_RESCALE_NORMAL);
    gl.Scalef(scale, scale, scale);
  }
  draw_sphere(gl, scaled ? 1 / scale : 1);
}

// M8. Undefined by the specification; here each lost term counts as 0 and the distance is 0.
void draw_m8(const GlFunctions& gl, bool at_the_vertex) {
  begin_lit_scene(gl);
  gl.PointSize(20);
  gl.Lightfv(GL_LIGHT0, GL_AMBIENT, vec(0.5F, 0.3F, 0.2F));
  if (at_the_vertex) {
    gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0, 0, 0));
    gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1);
  } else {
    gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, black);
    gl.Lightfv(GL_LIGHT0, GL_SPECULAR, black);
  }
  gl.Begin(GL_POINTS);
  gl.Vertex3f(0, 0, 0);
  gl.End();
}

// M9. What glPopAttrib brings back.
void draw_m9(const GlFunctions& gl, bool changed_between) {
  begin_lit_scene(gl);
  if (changed_between) {
    gl.PushAttrib(GL_LIGHTING_BIT);
    gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, vec(0.1F, 0.9F, 0.1F));
    use_brass(gl, GL_FRONT_AND_BACK);
    gl.PopAttrib();
  }
  draw_sphere(gl);
}

}  // namespace

std::vector<Scene> departures_scenes() {
  return {
      m1_scene("shininess_0_attenuated", attenuate),
      m1_scene("shininess_0_spot", confine),
      m2_scene("cutoff_0", 0),
      m2_scene("cutoff_thousandth_degree", 0.001F),
      departure(
          "vertex_w_2", "M3", [](const GlFunctions& gl) { draw_homogeneous_patch(gl, 2); },
          [](const GlFunctions& gl) { draw_homogeneous_patch(gl, 1); }),
      departure(
          "vertex_w_quarter", "M3",
          [](const GlFunctions& gl) { draw_homogeneous_patch(gl, 0.25F); },
          [](const GlFunctions& gl) { draw_homogeneous_patch(gl, 1); }),
      departure(
          "modelview_with_perspective", "M3",
          [](const GlFunctions& gl) { draw_points_under_perspective(gl, true); },
          [](const GlFunctions& gl) { draw_points_under_perspective(gl, false); }),
      departure(
          "shininess_0_on_one_face", "M4", [](const GlFunctions& gl) { draw_m4(gl, true); },
          [](const GlFunctions& gl) { draw_m4(gl, false); }),
      departure(
          "color_before_enable", "M5", [](const GlFunctions& gl) { draw_m5(gl, true); },
          [](const GlFunctions& gl) { draw_m5(gl, false); }),
      m6_scene("tracked_back_diffuse", GL_DIFFUSE),
      m6_scene("tracked_back_ambient", GL_AMBIENT),
      m6_scene("tracked_back_specular", GL_SPECULAR),
      m6_scene("tracked_back_ambient_and_diffuse", GL_AMBIENT_AND_DIFFUSE),
      departure(
          "rescale_under_large_scale", "M7", [](const GlFunctions& gl) { draw_m7(gl, true); },
          [](const GlFunctions& gl) { draw_m7(gl, false); }),
      departure(
          "light_at_the_vertex", "M8", [](const GlFunctions& gl) { draw_m8(gl, true); },
          [](const GlFunctions& gl) { draw_m8(gl, false); }),
      departure(
          "lights_and_materials_popped", "M9", [](const GlFunctions& gl) { draw_m9(gl, true); },
          [](const GlFunctions& gl) { draw_m9(gl, false); }),
  };
}

}  // namespace legacy_gl::test
