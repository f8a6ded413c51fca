// Frame times of this library and of Mesa's fixed function, the same scenes in one process.
// scripts/bench speed runs it and makes the document.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "benchmark/heap.hpp"
#include "benchmark/speed_measure.hpp"

using namespace legacy_gl::test;

namespace {

struct Arguments {
  SpeedOptions options;
  std::vector<std::string> scenes;
  std::vector<int> sizes{256, 16};
  bool growth = false;
  bool many_lights = false;
  bool list = false;
  std::string output;
  std::string profile;
  int frames = 20;
};

bool wanted(const Arguments& arguments, const SpeedScene& scene) {
  if (arguments.scenes.empty()) return true;
  return std::find(arguments.scenes.begin(), arguments.scenes.end(), scene.name) !=
         arguments.scenes.end();
}

// Writes "name<TAB>goal of a steady frame<TAB>goal of the first<TAB>what it draws".
void list_scenes(const std::vector<SpeedScene>& scenes) {
  for (const SpeedScene& scene : scenes)
    std::cout << scene.name << '\t' << scene.goal_steady << '\t' << scene.goal_first << '\t'
              << scene.what << '\n';
}

int run(Arguments& arguments) {
  const std::vector<SpeedScene> scenes = arguments.growth ? growth_scenes() : speed_scenes();
  if (arguments.list) {
    list_scenes(scenes);
    return 0;
  }
  std::ofstream file;
  if (!arguments.output.empty()) file.open(arguments.output);
  std::ostream& table = arguments.output.empty() ? std::cout : file;
  if (arguments.many_lights) {
    table << many_lights_table_head();
    arguments.options.size = arguments.sizes.front();
    return measure_many_lights(arguments.options, table) ? 0 : 1;
  }
  if (arguments.profile.empty()) table << speed_table_head();
  bool alike = true;
  for (const int size : arguments.sizes)
    for (const SpeedScene& scene : scenes) {
      if (!wanted(arguments, scene)) continue;
      // Its first frame takes Mesa many seconds, and the viewport has no part in it.
      if (scene.first_frame_only && (size != arguments.sizes.front() || arguments.options.quick))
        continue;
      arguments.options.size = size;
      if (!arguments.profile.empty()) {
        profile_scene(scene, arguments.options, arguments.profile == "mesa", arguments.frames);
        continue;
      }
      std::fprintf(stderr, "%s at %dx%d\n", scene.name.c_str(), size, size);
      if (measure_scene(scene, arguments.options, table)) continue;
      alike = false;
      std::fprintf(stderr, "%s at %dx%d: the images differ\n", scene.name.c_str(), size, size);
    }
  return alike ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  pin_heap();
  // First frames compile: an earlier run's programs would hide that.
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  Arguments arguments;
  CLI::App app{"CPU and wall time of frames, ours against Mesa's fixed function"};
  app.add_option("--scene", arguments.scenes, "only these (repeat it); all unless given");
  app.add_option("--size", arguments.sizes, "viewports (repeat it): 256 and 16 unless given");
  app.add_flag("--growth", arguments.growth, "scenes of growing size instead");
  app.add_flag("--many-lights", arguments.many_lights,
               "instead: 64 lights over 200 objects against eight lights");
  app.add_flag("--quick", arguments.options.quick, "fewer frames");
  app.add_flag("--cull", arguments.options.cull_everything, "glCullFace(GL_FRONT_AND_BACK)");
  app.add_flag("--list", arguments.list, "list the scenes and their goals");
  app.add_option("--output", arguments.output, "write the table to this file");
  app.add_option("--profile", arguments.profile,
                 "draw with one implementation alone, for a profiler")
      ->check(CLI::IsMember({"mesa", "ours"}));
  app.add_option("--frames", arguments.frames, "frames of --profile");
  CLI11_PARSE(app, argc, argv);
  try {
    return run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed: %s\n", error.what());
    return 1;
  }
}
