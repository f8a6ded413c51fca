// State changes that alter what a lit scene looks like, and the scene.
#pragma once

#include <string>
#include <vector>

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

struct SceneChange {
  std::string name;
  void (*apply)(const GlFunctions& gl);
};

/// A light, a material, a projection: where the changes start from.
void set_up_scene(const GlFunctions& gl);
/// Clears, then draws a bent strip of coloured quads, lines and points.
void draw_scene(const GlFunctions& gl);
const std::vector<SceneChange>& scene_changes();

}  // namespace legacy_gl::test
