// S1 to S3 and S5 to S7: one figure of 100,000 vertices.
#include "benchmark/speed_scenes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "benchmark/speed_meshes.hpp"

namespace legacy_gl::test {

namespace {

constexpr std::size_t kVertices = 100000;

using Color = std::array<GLfloat, 4>;

void set_light(const GlFunctions& gl, GLenum light, Color position, Color color) {
  const Color ambient{color[0] * 0.1F, color[1] * 0.1F, color[2] * 0.1F, 1};
  gl.Lightfv(light, GL_POSITION, position.data());
  gl.Lightfv(light, GL_AMBIENT, ambient.data());
  gl.Lightfv(light, GL_DIFFUSE, color.data());
  gl.Lightfv(light, GL_SPECULAR, color.data());
  gl.Enable(light);
}

void compile_list(const GlFunctions& gl, const StripMesh& mesh) {
  gl.NewList(1, GL_COMPILE);
  draw_strips(gl, mesh);
  gl.EndList();
}

void draw_list(const GlFunctions& gl) {
  clear_frame(gl);
  gl.CallList(1);
}

SpeedScene immediate_scene(std::size_t vertices) {
  const StripMesh& mesh = strip_mesh(vertices);
  SpeedScene scene;
  scene.prepare = [](const GlFunctions& gl) {
    set_up_view(gl);
    set_up_light(gl);
    set_up_material(gl);
  };
  scene.frame = [&mesh](const GlFunctions& gl) {
    clear_frame(gl);
    draw_strips(gl, mesh);
  };

  scene.units = static_cast<double>(mesh.vertices.size());
  return scene;
}

void draw_colored_strips(const GlFunctions& gl, const StripMesh& mesh) {
  clear_frame(gl);
  for (std::size_t first = 0; first < mesh.vertices.size(); first += mesh.strip_length) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (std::size_t i = first; i < first + mesh.strip_length; ++i) {
      const SpeedVertex& v = mesh.vertices[i];
      gl.Color3f(0.5F + 0.5F * v.normal[0], 0.5F + 0.5F * v.normal[1], 0.5F);
      gl.Normal3f(v.normal[0], v.normal[1], v.normal[2]);
      gl.Vertex3f(v.position[0], v.position[1], v.position[2]);
    }
    gl.End();
  }
}

SpeedScene named(SpeedScene scene, std::string name, std::string what, double goal) {
  scene.name = std::move(name);
  scene.what = std::move(what);
  scene.goal_steady = goal;
  return scene;
}

}  // namespace

void set_up_view(const GlFunctions& gl) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-0.3, 0.3, -0.3, 0.3, 1, 20);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Translatef(0, 0, -4);
  gl.Rotatef(25, 1, 0.5F, 0.2F);
  gl.Enable(GL_DEPTH_TEST);
}

void set_up_light(const GlFunctions& gl) {
  gl.PushMatrix();
  gl.LoadIdentity();
  set_light(gl, GL_LIGHT0, {1, 2, 3, 0}, {1, 1, 1, 1});
  gl.PopMatrix();
  gl.Enable(GL_LIGHTING);
}

void set_up_material(const GlFunctions& gl) {
  constexpr Color kDiffuse{0.6F, 0.4F, 0.7F, 1}, kSpecular{0.5F, 0.5F, 0.5F, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, kDiffuse.data());
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, kSpecular.data());
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 30);
}

void clear_frame(const GlFunctions& gl) { gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }

void set_up_mixed_lights(const GlFunctions& gl) {
  gl.PushMatrix();
  gl.LoadIdentity();
  set_light(gl, GL_LIGHT0, {1, 2, 3, 0}, {0.3F, 0.3F, 0.3F, 1});
  set_light(gl, GL_LIGHT1, {-2, 1, 2, 0}, {0.3F, 0.1F, 0.1F, 1});
  set_light(gl, GL_LIGHT2, {3, 0, 0, 1}, {0.1F, 0.3F, 0.1F, 1});
  set_light(gl, GL_LIGHT3, {0, 3, -2, 1}, {0.1F, 0.1F, 0.3F, 1});
  set_light(gl, GL_LIGHT4, {-3, 0, -3, 1}, {0.4F, 0.4F, 0.1F, 1});
  set_light(gl, GL_LIGHT5, {0, -3, -3, 1}, {0.1F, 0.4F, 0.4F, 1});
  set_light(gl, GL_LIGHT6, {2, 2, -1, 1}, {0.6F, 0.2F, 0.6F, 1});
  set_light(gl, GL_LIGHT7, {-2, 2, -1, 1}, {0.6F, 0.6F, 0.2F, 1});
  for (GLenum light = GL_LIGHT4; light <= GL_LIGHT7; ++light) {
    gl.Lightf(light, GL_CONSTANT_ATTENUATION, 0.8F);
    gl.Lightf(light, GL_LINEAR_ATTENUATION, 0.05F);
    gl.Lightf(light, GL_QUADRATIC_ATTENUATION, 0.02F);
  }
  for (GLenum light = GL_LIGHT6; light <= GL_LIGHT7; ++light) {
    const float side = light == GL_LIGHT6 ? -1.0F : 1.0F;
    const Color direction{side * 2, -2, -3, 0};
    gl.Lightfv(light, GL_SPOT_DIRECTION, direction.data());
    gl.Lightf(light, GL_SPOT_CUTOFF, 30);
    gl.Lightf(light, GL_SPOT_EXPONENT, 4);
  }
  gl.PopMatrix();
  gl.Enable(GL_LIGHTING);
}

std::vector<SpeedScene> speed_scenes() {
  const StripMesh& mesh = strip_mesh(kVertices);
  std::vector<SpeedScene> scenes;
  scenes.push_back(
      named(immediate_scene(kVertices), "S1", "100,000 vertices by glBegin, one light", 0.9));

  SpeedScene arrays = scenes.front();
  arrays.frame = [&mesh](const GlFunctions& gl) {
    clear_frame(gl);
    const SpeedVertex* const vertices = mesh.shared_vertices.data();
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.NormalPointer(GL_FLOAT, sizeof(SpeedVertex), vertices->normal.data());
    gl.VertexPointer(3, GL_FLOAT, sizeof(SpeedVertex), vertices->position.data());
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangle_indices.size()),
                    GL_UNSIGNED_INT, mesh.triangle_indices.data());
  };
  scenes.push_back(
      named(arrays, "S2", "the same triangles by client arrays and glDrawElements", 0.95));

  SpeedScene list = scenes.front();
  list.prepare = [&mesh](const GlFunctions& gl) {
    set_up_view(gl);
    set_up_light(gl);
    set_up_material(gl);
    compile_list(gl, mesh);
  };
  list.frame = draw_list;
  scenes.push_back(named(list, "S3", "S1 as a display list", 0.8));

  SpeedScene turning = list;
  turning.frame = [](const GlFunctions& gl) {
    gl.Rotatef(0.7F, 0.3F, 1, 0);
    draw_list(gl);
  };
  scenes.push_back(named(turning, "S3t", "S3, turning: the view is new in every frame", 0));

  for (SpeedScene& scene : object_scenes()) scenes.push_back(std::move(scene));

  SpeedScene eight = list;
  eight.prepare = [&mesh](const GlFunctions& gl) {
    set_up_view(gl);
    set_up_mixed_lights(gl);
    set_up_material(gl);
    compile_list(gl, mesh);
  };
  scenes.push_back(
      named(eight, "S5", "eight lights, positional, attenuated, spot, in a list", 0.8));

  SpeedScene black = list;
  black.prepare = [prepare = eight.prepare](const GlFunctions& gl) {
    prepare(gl);
    constexpr Color kBlack{0, 0, 0, 1};
    for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light)
      for (const int term : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR})
        gl.Lightfv(light, static_cast<GLenum>(term), kBlack.data());
  };
  scenes.push_back(named(black, "S6", "eight lights with black colours", 0.4));

  SpeedScene two_sided = scenes.front();
  two_sided.prepare = [](const GlFunctions& gl) {
    set_up_view(gl);
    set_up_light(gl);
    set_up_material(gl);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    gl.Enable(GL_COLOR_MATERIAL);
  };
  two_sided.frame = [&mesh](const GlFunctions& gl) { draw_colored_strips(gl, mesh); };
  scenes.push_back(named(two_sided, "S7",
                         "two-sided, local viewer, colour material per vertex, by glBegin", 0.8));

  for (SpeedScene& scene : call_scenes()) scenes.push_back(std::move(scene));
  std::stable_sort(scenes.begin(), scenes.end(),
                   [](const SpeedScene& a, const SpeedScene& b) { return a.name < b.name; });
  return scenes;
}

std::vector<SpeedScene> growth_scenes() {
  std::vector<SpeedScene> scenes;
  for (const std::size_t vertices :
       {std::size_t{1000}, std::size_t{10000}, std::size_t{100000}, std::size_t{1000000}})
    scenes.push_back(named(immediate_scene(vertices), "vertices", "vertices by glBegin", 0));
  for (const std::size_t objects :
       {std::size_t{10}, std::size_t{100}, std::size_t{1000}, std::size_t{10000}})
    scenes.push_back(named(objects_scene(objects), "objects", "small objects from a list", 0));
  return scenes;
}

}  // namespace legacy_gl::test
