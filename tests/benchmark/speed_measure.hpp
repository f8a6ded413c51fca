#pragma once

#include <iosfwd>

#include "benchmark/speed_scenes.hpp"

namespace legacy_gl::test {

struct SpeedOptions {
  int size = 256;  // of the viewport, both ways
  bool quick = false;
  bool cull_everything = false;  // glCullFace(GL_FRONT_AND_BACK): without the rasteriser's part
};

// Draws the scene by Mesa's fixed function and by this library in turns, compares the images, and
// writes rows of the table whose head speed_table_head() is. False when the images differ.
bool measure_scene(const SpeedScene& scene, const SpeedOptions& options, std::ostream& table);

const char* speed_table_head();

// 64 lamps over 200 objects, each of which few lamps reach, beside the same objects under eight of
// the lamps: writes one row of the table whose head many_lights_table_head() is. False when the
// image is not that of the quality that leaves out no light.
bool measure_many_lights(const SpeedOptions& options, std::ostream& table);

const char* many_lights_table_head();

// Draws frames by one implementation alone, for a profiler.
void profile_scene(const SpeedScene& scene, const SpeedOptions& options, bool mesa, int frames);

}  // namespace legacy_gl::test
