// The scenes whose speed is compared: what old programs do, in the calls they do it with.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

struct SpeedScene {
  std::string name;
  std::string what;
  double goal_steady = 0;  // ours / Mesa's, CPU time of a steady frame; 0: none
  double goal_first = 0;   // of the first frame; 0: none
  bool first_frame_only = false;
  std::function<void(const GlFunctions&)> prepare;
  std::function<void(const GlFunctions&)> frame;
  // For the growth of time with size: how many vertices or objects the frame draws.
  double units = 0;
};

// S1 to S9, the 256 light masks, many lights.
std::vector<SpeedScene> speed_scenes();
// Immediate mode from 1e3 to 1e6 vertices, objects from 10 to 10,000.
std::vector<SpeedScene> growth_scenes();

// What the files of scenes share.
void set_up_view(const GlFunctions& gl);
void set_up_light(const GlFunctions& gl);
void set_up_material(const GlFunctions& gl);
void clear_frame(const GlFunctions& gl);
// Eight lights: directional, point, attenuated and spot.
void set_up_mixed_lights(const GlFunctions& gl);
SpeedScene objects_scene(std::size_t count);
std::vector<SpeedScene> object_scenes();
std::vector<SpeedScene> call_scenes();

}  // namespace legacy_gl::test
