// A scene is drawn once by Mesa's fixed function and once by legacy_gl, from OpenGL's initial
// state, into a scene_size × scene_size viewport; the two images are compared.
//
// To add one: put it into the file of its feature, a function std::vector<Scene> <feature>_scenes()
// that registry.cpp lists. Begin with begin_scene() (scene_kit.hpp), so that the background is
// known.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

constexpr int scene_size = 128;

using Draw = std::function<void(const GlFunctions&)>;

struct SceneTraits {
  // Mesa departs from the specification here ("M1" … of docs/deviations.md). `reference` draws what
  // the specification asks for in a form that Mesa gets right; it is the judge.
  std::string mesa_departure = {};
  Draw reference = {};

  // Fewer than four colours by intention (unlit flat figures, saturated light).
  bool few_colors = false;
  // Samples textures of 8 bits: in float as well, filters may differ by a step.
  bool filtered = false;
  // Draws nothing by intention: the background itself is what is tested.
  bool draws_nothing = false;
};

struct Scene {
  std::string name;
  Draw draw;
  SceneTraits traits = {};
};

struct Feature {
  std::string name;
  std::vector<Scene> scenes;
};

// Every feature, in the order of the files.
const std::vector<Feature>& features();

}  // namespace legacy_gl::test
