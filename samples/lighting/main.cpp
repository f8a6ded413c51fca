// The scene of scene.c by Mesa's fixed function and by legacy_gl, and the difference of the
// pictures.
#include <legacy_gl/context.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>

#include "command_line.hpp"
#include "support/egl_surface.hpp"
#include "support/osmesa_surface.hpp"
#include "support/picture.hpp"

namespace {

using samples::EglSurface;
using samples::OsmesaSurface;
using samples::Picture;

Picture drawn_by_mesa(const settings& scene) {
  const OsmesaSurface surface(OsmesaSurface::Profile::compatibility, scene.width, scene.height);
  draw_scene_by_mesa(&scene);
  return surface.picture();
}

// Over the driver's context that is current.
void draw_by_legacy_gl(const settings& scene, legacy_gl_loader loader) {
  legacy_gl::OwnedContext context(loader);
  context.make_current();
  draw_scene_by_legacy_gl(&scene);
  legacy_gl_make_current(nullptr);
}

Picture drawn_by_legacy_gl(const settings& scene, Dialect dialect) {
  if (dialect == Dialect::es) {
    EglSurface surface(scene.width, scene.height);
    draw_by_legacy_gl(scene, eglGetProcAddress);
    return surface.picture();
  }
  const OsmesaSurface surface(OsmesaSurface::Profile::core, scene.width, scene.height);
  draw_by_legacy_gl(scene, OSMesaGetProcAddress);
  return surface.picture();
}

int run(const CommandLine& line) {
  const Picture mesa = drawn_by_mesa(line.scene);
  const Picture ours = drawn_by_legacy_gl(line.scene, line.dialect);
  const samples::Difference difference = samples::difference(ours, mesa, line.amplification);

  const std::filesystem::path directory = line.output;
  std::filesystem::create_directories(directory);
  const auto save = [&](const Picture& picture, const char* name) {
    const std::filesystem::path path = std::filesystem::absolute(directory / name);
    samples::write_png(picture, path);
    std::printf("%s\n", path.lexically_normal().c_str());
  };
  save(mesa, "mesa.png");
  save(ours, "ours.png");
  save(difference.amplified, "difference.png");
  std::printf("largest difference: %d/255, in %zu of %zu pixels (difference.png: times %d)\n",
              difference.largest, difference.differing_pixels, ours.rgba.size() / 4,
              line.amplification);

  // One step is the rounding of equal colours on either side of a half.
  if (difference.largest <= 1) {
    return 0;
  }
  if (line.scene.shininess == 0.0F) {
    std::puts(
        "With shininess 0 and a spot or attenuated light, Mesa departs from the specification: its "
        "specular factor is a power of n.l instead of 1.");
  }
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(parse_command_line(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lighting: %s\n", error.what());
    return 2;
  }
}
