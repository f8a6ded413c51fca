// More lights than OpenGL asks for: a hall of lamps, each of which lights what is below it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <vector>

#include "benchmark/clock.hpp"
#include "benchmark/speed_measure.hpp"
#include "benchmark/speed_meshes.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr unsigned kFew = 8, kMany = 64;
constexpr int kColumns = 20, kRows = 10;

using Color = std::array<GLfloat, 4>;

// 408 vertices.
void set_up(const GlFunctions& gl, unsigned enabled) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-0.5, 0.5, -0.5, 0.5, 1, 40);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Translatef(0, 1, -22);
  gl.Rotatef(-30, 1, 0, 0);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  set_up_material(gl);
  constexpr Color kDown{0, 0, -1, 0};
  for (unsigned i = 0; i < enabled; ++i) {
    const unsigned place = i * (kMany / enabled);  // a grid of 8 by 8 lamps
    const GLenum light = GL_LIGHT0 + i;
    const Color position{-8.75F + 2.5F * static_cast<float>(place % 8),
                         -4.2F + 1.2F * static_cast<float>(place / 8), 3, 1};
    const Color color{0.4F + 0.1F * static_cast<float>(i % 4), 0.8F,
                      0.9F - 0.1F * static_cast<float>(i % 3), 1};
    gl.Lightfv(light, GL_POSITION, position.data());
    gl.Lightfv(light, GL_DIFFUSE, color.data());
    gl.Lightfv(light, GL_SPECULAR, color.data());
    gl.Lightfv(light, GL_SPOT_DIRECTION, kDown.data());
    gl.Lightf(light, GL_SPOT_CUTOFF, 28);
    gl.Lightf(light, GL_SPOT_EXPONENT, 6);
    gl.Lightf(light, GL_LINEAR_ATTENUATION, 0.1F);
    gl.Lightf(light, GL_QUADRATIC_ATTENUATION, 0.05F);
    gl.Enable(light);
  }
  gl.NewList(1, GL_COMPILE);
  draw_ball(gl, 0.4F, 16, 12);
  gl.EndList();
}

void draw_frame(const GlFunctions& gl) {
  clear_frame(gl);
  for (int i = 0; i < kColumns * kRows; ++i) {
    gl.PushMatrix();
    gl.Translatef(-9.5F + static_cast<float>(i % kColumns),
                  -4.5F + static_cast<float>(i / kColumns), 0.3F * static_cast<float>(i % 3));
    gl.CallList(1);
    gl.PopMatrix();
  }
}

legacy_gl_options options_of(legacy_gl_quality quality) {
  legacy_gl_options options{};
  options.max_lights = kMany;
  options.quality = quality;
  options.programs = LEGACY_GL_PROGRAMS_GENERAL_FIRST;
  return options;
}

double time_frame(RenderContext& context) {
  context.make_current();
  const double before = cpu_seconds();
  draw_frame(context.gl);
  context.gl.Finish();
  return cpu_seconds() - before;
}

}  // namespace

const char* many_lights_table_head() {
  return "objects,few,many,few_cpu_ms,many_cpu_ms,cpu_ratio,culled_per_object,compiled,"
         "image_difference\n";
}

bool measure_many_lights(const SpeedOptions& options, std::ostream& table) {
  const auto context = [&](legacy_gl_quality quality, unsigned lights) {
    auto made = std::make_unique<CoreContext>(options.size, options.size, PixelFormat::rgba8,
                                              options_of(quality));
    set_up(made->gl, lights);
    return made;
  };
  const auto few = context(LEGACY_GL_QUALITY_DEFAULT, kFew);
  const auto many = context(LEGACY_GL_QUALITY_DEFAULT, kMany);
  for (int i = 0; i < 30; ++i) {
    time_frame(*few);
    time_frame(*many);
  }
  legacy_gl_reset_statistics();
  std::vector<double> few_times, many_times, ratios;
  const int frames = options.quick ? 9 : 31;
  for (int i = 0; i < frames; ++i) {
    few_times.push_back(time_frame(*few));
    many_times.push_back(time_frame(*many));
    ratios.push_back(many_times.back() / few_times.back());
  }
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  const Image image = many->read_rgba8();

  const auto reference = context(LEGACY_GL_QUALITY_PRECISE, kMany);
  draw_frame(reference->gl);
  const float difference = compare(image, reference->read_rgba8()).max_difference();
  char text[256];
  std::snprintf(text, sizeof text, "%d,%u,%u,%.4f,%.4f,%.4f,%.1f,%llu,%.0f\n", kColumns * kRows,
                kFew, kMany, 1e3 * median(few_times), 1e3 * median(many_times), median(ratios),
                static_cast<double>(statistics.lights_culled) / (frames * kColumns * kRows),
                static_cast<unsigned long long>(statistics.programs_compiled),
                static_cast<double>(difference));
  table << text << std::flush;
  return difference <= 1;
}

}  // namespace legacy_gl::test
