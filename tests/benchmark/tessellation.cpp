// The oldest trade-off of lighting: a finer mesh or a better interpolation. Sphere and torus by
// tessellation, flat, Gouraud and Phong: CPU time against the image's error. scripts/bench accuracy
// runs it and draws the chart.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include "benchmark/clock.hpp"
#include "benchmark/heap.hpp"
#include "support/contexts.hpp"

using namespace legacy_gl::test;

namespace {

constexpr int kSize = 256;
constexpr int kReferenceSlices = 1024;

struct Shading {
  const char* name;
  GLenum model;
};
constexpr std::array<Shading, 3> kShadings{
    {{"flat", GL_FLAT}, {"Gouraud", GL_SMOOTH}, {"Phong", GL_PHONG_WIN}}};

using SurfacePoint = void (*)(const GlFunctions& gl, float u, float v);  // u, v: 0 to 1

void sphere_point(const GlFunctions& gl, float u, float v) {
  const float around = 2 * std::numbers::pi_v<float> * u, down = std::numbers::pi_v<float> * v;
  const float x = std::cos(around) * std::sin(down), y = std::sin(around) * std::sin(down);
  gl.Normal3f(x, y, std::cos(down));
  gl.Vertex3f(x, y, std::cos(down));
}

void torus_point(const GlFunctions& gl, float u, float v) {
  constexpr float kRing = 0.68F, kTube = 0.32F;
  const float around = 2 * std::numbers::pi_v<float> * u, tube = -2 * std::numbers::pi_v<float> * v;
  const float c = std::cos(around), s = std::sin(around);
  gl.Normal3f(c * std::cos(tube), s * std::cos(tube), std::sin(tube));
  gl.Vertex3f(c * (kRing + kTube * std::cos(tube)), s * (kRing + kTube * std::cos(tube)),
              kTube * std::sin(tube));
}

struct Shape {
  const char* name;
  SurfacePoint point;
};
constexpr std::array<Shape, 2> kShapes{{{"sphere", sphere_point}, {"torus", torus_point}}};

void compile_mesh(const GlFunctions& gl, GLuint list, const Shape& shape, int slices) {
  const int stacks = std::max(slices / 2, 2);
  gl.NewList(list, GL_COMPILE);
  for (int stack = 0; stack < stacks; ++stack) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int slice = 0; slice <= slices; ++slice)
      for (const int edge : {0, 1})
        shape.point(gl, float(slice % slices) / float(slices), float(stack + edge) / float(stacks));
    gl.End();
  }
  gl.EndList();
}

// A polished material under one lamp: its highlight is a few degrees wide.
void set_scene(const GlFunctions& gl) {
  constexpr std::array<float, 4> kLamp{2, 3, 4, 1}, kAmbient{0.12F, 0.03F, 0.03F, 1},
      kDiffuse{0.55F, 0.12F, 0.1F, 1}, kSpecular{0.9F, 0.9F, 0.9F, 1};
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-0.3, 0.3, -0.3, 0.3, 1, 10);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Translatef(0, 0, -4);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, kLamp.data());
  gl.Rotatef(-50, 1, 0, 0);
  gl.Rotatef(20, 0, 0, 1);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_CULL_FACE);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, kAmbient.data());
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, kDiffuse.data());
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, kSpecular.data());
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 100);
}

void frame(const GlFunctions& gl, GLuint list, GLenum model) {
  gl.ClearColor(1, 1, 1, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.ShadeModel(model);
  gl.CallList(list);
  gl.Finish();
}

struct ImageError {
  double all = 0;      // root mean square over the colour channels of all pixels, in steps of 1/255
  double shading = 0;  // the same over the pixels that both images cover
};

ImageError image_error(const Image& image, const Image& reference) {
  double all = 0, shading = 0;
  std::size_t shaded = 0;
  const std::size_t pixels = image.floats.size() / 4;
  for (std::size_t at = 0; at < image.floats.size(); at += 4) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double difference = 255 * double(image.floats[at + c] - reference.floats[at + c]);
      sum += difference * difference;
    }
    all += sum;
    // The background's alpha is 0.
    if (image.floats[at + 3] == 0 || reference.floats[at + 3] == 0) continue;
    shading += sum;
    ++shaded;
  }
  return {std::sqrt(all / (3 * double(pixels))), std::sqrt(shading / (3 * double(shaded)))};
}

struct Arguments {
  std::string table, pictures;
  int rounds = 21;
};

constexpr std::array kSlices{4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256};

void measure_shape(const Arguments& arguments, std::ofstream& table, CoreContext& context,
                   const Shape& shape) {
  const GlFunctions& gl = context.gl;
  const GLuint lists = gl.GenLists(GLsizei(kSlices.size()) + 1);
  compile_mesh(gl, lists, shape, kReferenceSlices);
  frame(gl, lists, GL_PHONG_WIN);
  const Image reference = context.read_float();
  struct Cell {
    std::vector<double> seconds;
    ImageError error;
  };
  std::array<std::array<Cell, kShadings.size()>, kSlices.size()> cells;
  std::fprintf(stderr, "%s\n", shape.name);
  for (std::size_t mesh = 0; mesh < kSlices.size(); ++mesh)
    compile_mesh(gl, lists + 1 + GLuint(mesh), shape, kSlices[mesh]);
  // All in turn, so that a busy moment of the machine is one round of each and no median.
  for (int round = -2; round < arguments.rounds; ++round)
    for (std::size_t mesh = 0; mesh < kSlices.size(); ++mesh)
      for (std::size_t i = 0; i < kShadings.size(); ++i) {
        Cell& cell = cells[mesh][i];
        const double start = cpu_seconds();
        frame(gl, lists + 1 + GLuint(mesh), kShadings[i].model);
        if (round >= 0) cell.seconds.push_back(cpu_seconds() - start);
        if (round != -1) continue;
        const Image image = context.read_float();
        cell.error = image_error(image, reference);
        if (!arguments.pictures.empty())
          write_png(image, arguments.pictures + "/" + shape.name + "_" +
                               std::to_string(kSlices[mesh]) + "_" + kShadings[i].name + ".png");
      }
  for (std::size_t mesh = 0; mesh < kSlices.size(); ++mesh)
    for (std::size_t i = 0; i < kShadings.size(); ++i) {
      const Cell& cell = cells[mesh][i];
      char row[128];
      std::snprintf(row, sizeof row, "%s,%d,%s,%.4f,%.4f,%.4f\n", shape.name, kSlices[mesh],
                    kShadings[i].name, 1e3 * median(cell.seconds), cell.error.all,
                    cell.error.shading);
      table << row << std::flush;
    }
}

}  // namespace

int main(int argc, char** argv) {
  pin_heap();
  Arguments arguments;
  CLI::App app{"CPU time and image error by tessellation and shading"};
  app.add_option("--table", arguments.table, "write the table to this file")->required();
  app.add_option("--pictures", arguments.pictures, "write the pictures to this directory");
  app.add_option("--rounds", arguments.rounds, "frames of each");
  CLI11_PARSE(app, argc, argv);
  try {
    legacy_gl_options options = {};
    options.programs = LEGACY_GL_PROGRAMS_SPECIALISED;
    CoreContext context(kSize, kSize, PixelFormat::rgba32f, options);
    set_scene(context.gl);
    std::ofstream table(arguments.table);
    table << "shape,slices,shading,cpu_ms,error_of_all_pixels,error_of_shading\n";
    for (const Shape& shape : kShapes) measure_shape(arguments, table, context, shape);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tessellation: %s\n", error.what());
    return 1;
  }
  return 0;
}
