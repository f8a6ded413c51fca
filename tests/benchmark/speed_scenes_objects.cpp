// S4 and S8: many small draws with state changes between them.
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <random>
#include <utility>

#include "benchmark/speed_meshes.hpp"
#include "benchmark/speed_scenes.hpp"

namespace legacy_gl::test {

namespace {

using Color = std::array<GLfloat, 4>;
using Corner = std::array<GLfloat, 3>;

// The corners of a cube of 12 triangles, seen from outside counterclockwise.
template <typename Put>
void for_each_corner(float half_edge, Put put) {
  constexpr std::array<Corner, 6> kNormals{Corner{1, 0, 0},  Corner{-1, 0, 0}, Corner{0, 1, 0},
                                           Corner{0, -1, 0}, Corner{0, 0, 1},  Corner{0, 0, -1}};
  for (const Corner& n : kNormals) {
    const Corner v{n[1], n[2], n[0]};
    const Corner u{v[1] * n[2] - v[2] * n[1], v[2] * n[0] - v[0] * n[2], v[0] * n[1] - v[1] * n[0]};
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
      Corner p{};
      for (std::size_t i = 0; i < 3; ++i)
        p[i] = half_edge * (n[i] + static_cast<float>(a) * u[i] + static_cast<float>(b) * v[i]);
      put(n, p);
    }
  }
}

// In the scale of the objects, a normal a face.
void draw_cube(const GlFunctions& gl, float half_edge) {
  gl.Begin(GL_TRIANGLES);
  int corner = 0;
  for_each_corner(half_edge, [&](const Corner& n, const Corner& p) {
    if (corner++ % 6 == 0) gl.Normal3fv(n.data());
    gl.Vertex3fv(p.data());
  });
  gl.End();
}

// 96 triangles in strips.
void draw_small_ball(const GlFunctions& gl, float radius) { draw_ball(gl, radius, 8, 6); }

struct Object {
  Corner place;
  float degrees;
  std::array<Color, 4> material;  // ambient, diffuse, specular, emission
  float shininess;
};

std::vector<Object> random_objects(std::size_t count) {
  std::minstd_rand random(7);
  const auto between = [&random](float low, float high) {
    return low + (high - low) * static_cast<float>(random() % 10007) / 10006.0F;
  };
  std::vector<Object> objects(count);
  for (Object& object : objects) {
    object.place = {between(-0.8F, 0.8F), between(-0.8F, 0.8F), between(-0.8F, 0.8F)};
    object.degrees = between(0, 360);
    for (Color& color : object.material)
      color = {between(0, 0.6F), between(0, 0.6F), between(0, 0.6F), 1};
    object.material[3] = {between(0, 0.1F), 0, 0, 1};
    object.shininess = std::floor(between(5, 60));
  }
  return objects;
}

void set_object(const GlFunctions& gl, const Object& object) {
  gl.PushMatrix();
  gl.Translatef(object.place[0], object.place[1], object.place[2]);
  gl.Rotatef(object.degrees, 0.3F, 0.5F, 0.8F);
  gl.Materialfv(GL_FRONT, GL_AMBIENT, object.material[0].data());
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, object.material[1].data());
  gl.Materialfv(GL_FRONT, GL_SPECULAR, object.material[2].data());
  gl.Materialfv(GL_FRONT, GL_EMISSION, object.material[3].data());
  gl.Materialfv(GL_FRONT, GL_SHININESS, &object.shininess);
}

using Figure = void (*)(const GlFunctions&, float);

SpeedScene objects_scene(std::size_t count, Figure figure, bool from_list) {
  SpeedScene scene;
  scene.prepare = [figure, from_list](const GlFunctions& gl) {
    set_up_view(gl);
    set_up_light(gl);
    if (!from_list) return;
    gl.NewList(1, GL_COMPILE);
    figure(gl, 0.03F);
    gl.EndList();
  };
  scene.frame = [figure, from_list, objects = random_objects(count)](const GlFunctions& gl) {
    clear_frame(gl);
    for (const Object& object : objects) {
      set_object(gl, object);
      if (from_list) gl.CallList(1);
      else figure(gl, 0.03F);
      gl.PopMatrix();
    }
  };
  scene.units = static_cast<double>(count);
  return scene;
}

// What S4 is without its calls, its materials and its light: the same triangles in one list, one
// colour a cube. Mesa's time for it is what drawing them costs anyone.
SpeedScene triangles_alone(std::size_t count, bool culled) {
  SpeedScene scene;
  scene.prepare = [objects = random_objects(count), culled](const GlFunctions& gl) {
    set_up_view(gl);
    if (culled) gl.Enable(GL_CULL_FACE);
    gl.NewList(1, GL_COMPILE);
    gl.Begin(GL_TRIANGLES);
    for (const Object& object : objects) {
      const glm::mat4 matrix =
          glm::rotate(glm::translate(glm::mat4(1), glm::make_vec3(object.place.data())),
                      glm::radians(object.degrees), glm::vec3(0.3F, 0.5F, 0.8F));
      gl.Color3fv(object.material[1].data());
      for_each_corner(0.03F, [&](const Corner&, const Corner& p) {
        const glm::vec3 placed(matrix * glm::vec4(glm::make_vec3(p.data()), 1));
        gl.Vertex3fv(&placed[0]);
      });
    }
    gl.End();
    gl.EndList();
  };
  scene.frame = [](const GlFunctions& gl) {
    clear_frame(gl);
    gl.CallList(1);
  };
  return scene;
}

struct Toggle {
  unsigned mask;
  bool local_viewer, two_side, normalize;
};

// `count` draws, each in one of `variants` states: lights on and off, modes.
SpeedScene toggles_scene(std::size_t count, const std::vector<Toggle>& variants) {
  SpeedScene scene;
  scene.prepare = [](const GlFunctions& gl) {
    set_up_view(gl);
    set_up_mixed_lights(gl);
    set_up_material(gl);
    gl.NewList(1, GL_COMPILE);
    draw_cube(gl, 0.05F);
    gl.EndList();
  };
  scene.frame = [variants, objects = random_objects(count)](const GlFunctions& gl) {
    clear_frame(gl);
    std::size_t at = 0;
    for (const Object& object : objects) {
      const Toggle& toggle = variants[at++ % variants.size()];
      for (unsigned i = 0; i < 8; ++i) {
        if (toggle.mask >> i & 1) gl.Enable(GL_LIGHT0 + i);
        else gl.Disable(GL_LIGHT0 + i);
      }
      gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, toggle.local_viewer);
      gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, toggle.two_side);
      if (toggle.normalize) gl.Enable(GL_NORMALIZE);
      else gl.Disable(GL_NORMALIZE);
      gl.PushMatrix();
      gl.Translatef(object.place[0], object.place[1], object.place[2]);
      gl.CallList(1);
      gl.PopMatrix();
    }
  };
  return scene;
}

std::vector<Toggle> random_toggles(std::size_t count) {
  std::minstd_rand random(11);
  std::vector<Toggle> toggles;
  for (std::size_t i = 0; i < count; ++i)
    toggles.push_back({static_cast<unsigned>(random() >> 8 & 255), (random() >> 8 & 1) != 0,
                       (random() >> 8 & 3) == 0, (random() >> 8 & 1) != 0});
  return toggles;
}

SpeedScene named(SpeedScene scene, std::string name, std::string what, double steady,
                 double first) {
  scene.name = std::move(name);
  scene.what = std::move(what);
  scene.goal_steady = steady;
  scene.goal_first = first;
  return scene;
}

}  // namespace

SpeedScene objects_scene(std::size_t count) { return objects_scene(count, draw_cube, true); }

std::vector<SpeedScene> object_scenes() {
  std::vector<SpeedScene> scenes;
  scenes.push_back(named(objects_scene(1000, draw_cube, true), "S4",
                         "1000 cubes from a list, each with its matrix and five glMaterialfv", 0.5,
                         0));
  scenes.push_back(named(objects_scene(1000, draw_small_ball, true), "S4b",
                         "S4 with balls of 96 triangles", 0.5, 0));
  scenes.push_back(named(objects_scene(1000, draw_cube, false), "S4i", "S4 by glBegin", 0.5, 0));
  SpeedScene turning = objects_scene(1000, draw_cube, true);
  turning.frame = [frame = std::move(turning.frame)](const GlFunctions& gl) {
    gl.Rotatef(0.7F, 0.3F, 1, 0);
    frame(gl);
  };
  scenes.push_back(named(turning, "S4t", "S4, turning: every matrix is new in every frame", 0, 0));
  scenes.push_back(named(triangles_alone(1000, false), "S4f",
                         "the triangles of S4 alone: a list, no light", 0, 0));
  scenes.push_back(
      named(triangles_alone(1000, true), "S4g", "S4f with back faces culled by glCullFace", 0, 0));
  scenes.push_back(named(toggles_scene(500, random_toggles(24)), "S8",
                         "500 cubes, lights and modes toggled at random, 24 variants", 0.8, 0.1));
  std::vector<Toggle> masks;
  for (unsigned mask = 0; mask < 256; ++mask) masks.push_back({mask, false, false, false});
  SpeedScene all = named(toggles_scene(256, masks), "masks",
                         "256 cubes, one for each mask of eight lights", 0, 0.1);
  all.first_frame_only = true;
  scenes.push_back(std::move(all));
  return scenes;
}

}  // namespace legacy_gl::test
