// The whole program, and its transforms.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

void set_projection(Builder& b) {
  b.call("MatrixMode", "GL_PROJECTION");
  b.call("LoadIdentity");
  if (b.traits.perspective) {
    // Vertices about the origin are 3 away from the eye.
    b.call("Frustum", -0.5, 0.5, -0.5, 0.5, b.traits.outside ? 2.6 : 1.0, 8.0);
    b.call("Translatef", 0, 0, -3.0);
  } else if (b.random.chance(50)) {
    b.call("Ortho", -1.25, 1.0, -1.0, 1.5, -2.0, 2.0);
  }
  b.call("MatrixMode", "GL_MODELVIEW");
}

}  // namespace

void set_initial_state(Builder& b) {
  for (const char* capability :
       {"GL_LIGHTING",      "GL_COLOR_MATERIAL",      "GL_NORMALIZE",       "GL_FOG",
        "GL_COLOR_SUM",     "GL_TEXTURE_1D",          "GL_TEXTURE_2D",      "GL_TEXTURE_GEN_S",
        "GL_TEXTURE_GEN_T", "GL_LINE_STIPPLE",        "GL_POLYGON_STIPPLE", "GL_LINE_SMOOTH",
        "GL_CULL_FACE",     "GL_POLYGON_OFFSET_FILL", "GL_BLEND",           "GL_ALPHA_TEST",
        "GL_DEPTH_TEST",    "GL_STENCIL_TEST",        "GL_SCISSOR_TEST",    "GL_COLOR_LOGIC_OP",
        "GL_CLIP_PLANE0",   "GL_CLIP_PLANE1"})
    b.call("Disable", capability);
  b.call("ColorMask", 1, 1, 1, 1);
  b.call("DepthMask", 1);
  b.call("StencilMask", 255);
  b.call("ClearColor", 0.1, 0.2, 0.3, 0.5);
  b.call("Clear", "GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT");
  b.call("PolygonMode", "GL_FRONT_AND_BACK", "GL_FILL");
  b.call("ShadeModel", b.traits.flat ? "GL_FLAT" : "GL_SMOOTH");
  b.call("LineWidth", 1);
  b.call("PointSize", 1);
  // M1, M4: shininess 0, its initial value, is left out.
  b.call("Materialf", "GL_FRONT_AND_BACK", "GL_SHININESS", 8);
  set_projection(b);
  b.call("LoadIdentity");
  b.call("Color4f", 1, 1, 1, 1);
  b.call("Normal3f", 0, 0, 1);
}

void change_transform(Builder& b) {
  // What leaves the view volume is left to the traits.
  const bool free = b.traits.outside;
  switch (b.random.below(free ? 6 : 3)) {
    case 0: return b.call("LoadIdentity");
    case 1: return b.call("Rotatef", b.random.real(0, 360), 0, 0, 1);
    case 2: return b.call("Scalef", b.random.real(0.5, 1), b.random.real(0.5, 1), 1);
    case 3: return b.call("Translatef", b.random.real(-0.3, 0.3), b.random.real(-0.3, 0.3), 0);
    case 4: {
      const auto axis = b.random.reals(3, -1, 1);
      return b.call("Rotated", b.random.real(-180, 180), axis[0], axis[1], axis[2] + 2);
    }
    default: {
      const double scale = b.random.real(0.4, 1.4);
      return b.call("MultMatrixf",
                    floats({scale, 0.1, 0, 0, -0.1, scale, 0, 0, 0, 0, scale, 0, 0.1, 0, 0, 1}));
    }
  }
}

void change_state(Builder& b) {
  switch (b.random.below(8)) {
    case 0:
    case 1: return change_transform(b);
    case 2:
    case 3:
      return b.traits.lit ? b.random.chance(50) ? change_lighting(b) : change_material(b)
                          : change_rasterization(b);
    case 4: return change_rasterization(b);
    case 5: return b.traits.textured ? change_textures(b) : change_fragments(b);
    case 6: return b.traits.fog ? change_fog(b) : change_fragments(b);
    default: return change_fragments(b);
  }
}

void draw(Builder& b) {
  const int choice = b.random.below(10);
  if (choice < 3 && b.traits.arrays) return draw_arrays(b);
  if (choice == 3) return draw_rectangle(b);
  if (choice == 4 && b.traits.evaluators) return draw_evaluators(b);
  if (choice < 7 && b.traits.pixels) return draw_pixels(b);
  draw_primitive(b);
}

Program generate(std::uint64_t seed) {
  Builder b(seed);
  set_initial_state(b);
  if (b.traits.lit) {
    b.call("Enable", "GL_LIGHTING");
    for (int i = 0; i < 3; ++i) change_lighting(b);
  }
  if (b.traits.textured) define_textures(b);
  for (int i = 0; i < 3; ++i) change_state(b);
  const int steps = b.random.between(4, b.random.chance(20) ? 40 : 14);
  for (int i = 0; i < steps; ++i) {
    const int choice = b.random.below(20);
    if (choice < 5) change_state(b);
    else if (choice < 8 && b.traits.lists) use_list(b);
    else if (choice < 10 && b.traits.stacks) use_stack(b);
    else if (choice < 12 && b.traits.hits) use_hits(b);
    else if (choice < 14 && b.traits.queries) query(b);
    else if (choice < 15 && b.traits.errors) raise_error(b);
    else draw(b);
  }
  return std::move(b.program);
}

}  // namespace legacy_gl::fuzz
