#include "benchmark/speed_measure.hpp"

#include <algorithm>
#include <cstdio>
#include <ostream>

#include "benchmark/clock.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

struct Times {
  double cpu = 0;  // of the process: the driver's threads count
  double wall = 0;
};

// Draws one frame, to the end.
Times time_frame(RenderContext& context, const SpeedScene& scene) {
  context.make_current();
  const double cpu = cpu_seconds(), wall = seconds(CLOCK_MONOTONIC);
  scene.frame(context.gl);
  context.gl.Finish();
  return {cpu_seconds() - cpu, seconds(CLOCK_MONOTONIC) - wall};
}

// The driver's own start does not count: each context draws an unlit triangle first.
void warm_up(RenderContext& context) {
  context.make_current();
  context.gl.Begin(GL_TRIANGLES);
  for (const float x : {-1.0F, 1.0F, 0.0F}) context.gl.Vertex3f(x, x * x, 0);
  context.gl.End();
  context.gl.Finish();
}

void prepare(RenderContext& context, const SpeedScene& scene, const SpeedOptions& options) {
  warm_up(context);
  scene.prepare(context.gl);
  if (options.cull_everything) {
    context.gl.Enable(GL_CULL_FACE);
    context.gl.CullFace(GL_FRONT_AND_BACK);
  }
  context.gl.Finish();
}

std::uint64_t programs_compiled(CoreContext& context) {
  context.make_current();
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  return statistics.programs_compiled;
}

// What a program gets that asks for nothing.
legacy_gl_options default_options() {
  legacy_gl_options options{};
  options.programs = LEGACY_GL_PROGRAMS_GENERAL_FIRST;
  return options;
}

struct Measured {
  std::vector<double> cpu_ratio, wall_ratio, ours_cpu, mesa_cpu, ours_wall, mesa_wall;

  void add(const Times& ours, const Times& mesa) {
    cpu_ratio.push_back(ours.cpu / mesa.cpu);
    wall_ratio.push_back(ours.wall / mesa.wall);
    ours_cpu.push_back(ours.cpu);
    mesa_cpu.push_back(mesa.cpu);
    ours_wall.push_back(ours.wall);
    mesa_wall.push_back(mesa.wall);
  }
};

class Pair {
 public:
  Pair(const SpeedScene& scene, const SpeedOptions& options)
      : scene_(scene),
        mesa_(options.size, options.size),
        ours_(options.size, options.size, PixelFormat::rgba8, default_options()) {
    prepare(mesa_, scene, options);
    prepare(ours_, scene, options);
  }

  void time_round(Measured& measured) {
    // The order changes, so that neither always finds the other's data in the caches.
    ours_first_ = !ours_first_;
    Times ours{}, mesa{};
    if (ours_first_) ours = time_frame(ours_, scene_);
    mesa = time_frame(mesa_, scene_);
    if (!ours_first_) ours = time_frame(ours_, scene_);
    measured.add(ours, mesa);
  }

  // Largest difference of the images now, in steps of 1/255; a pixel that only one of them covers
  // counts as 255.
  float image_difference() {
    mesa_.make_current();
    const Image theirs = mesa_.read_rgba8();
    ours_.make_current();
    const Comparison comparison = compare(ours_.read_rgba8(), theirs);
    return comparison.same_coverage() ? comparison.max_difference() : 255;
  }

  CoreContext& ours() { return ours_; }

 private:
  const SpeedScene& scene_;
  MesaContext mesa_;
  CoreContext ours_;
  bool ours_first_ = false;
};

void write_row(std::ostream& table, const SpeedScene& scene, const SpeedOptions& options,
               const char* frame, const Measured& m, std::uint64_t compiled, float difference) {
  char text[512];
  std::snprintf(text, sizeof text, "%s,%.0f,%d,%s,%.4f,%.4f,%.4f,%.4f,%.4f,%.4f,%zu,%llu,%.0f\n",
                scene.name.c_str(), scene.units, options.size, frame, median(m.cpu_ratio),
                median(m.wall_ratio), 1e3 * median(m.ours_cpu), 1e3 * median(m.mesa_cpu),
                1e3 * median(m.ours_wall), 1e3 * median(m.mesa_wall), m.cpu_ratio.size(),
                static_cast<unsigned long long>(compiled), static_cast<double>(difference));
  table << text << std::flush;
}

}  // namespace

const char* speed_table_head() {
  return "scene,units,viewport,frame,cpu_ratio,wall_ratio,ours_cpu_ms,mesa_cpu_ms,ours_wall_ms,"
         "mesa_wall_ms,rounds,"
         "programs_compiled,image_difference\n";
}

bool measure_scene(const SpeedScene& scene, const SpeedOptions& options, std::ostream& table) {
  // One step of 1/255: both round the same colour, which differs in its last digits.
  constexpr float kTolerance = 1;
  Pair pair(scene, options);
  std::uint64_t compiled = programs_compiled(pair.ours());
  Measured first;
  pair.time_round(first);
  const std::uint64_t after_first = programs_compiled(pair.ours());
  float difference = options.cull_everything ? 0 : pair.image_difference();
  write_row(table, scene, options, "first", first, after_first - compiled, difference);
  if (scene.first_frame_only) return difference <= kTolerance;

  // Mesa compiles again in its fifth frame, we once a program has proved its worth: neither is a
  // steady frame.
  constexpr int kWarmUp = 8, kMaxWarmUp = 120;
  Measured unsteady;
  compiled = programs_compiled(pair.ours());
  for (int calm = 0, frames = 0; calm < kWarmUp && frames < kMaxWarmUp; ++frames, ++calm) {
    pair.time_round(unsteady);
    const std::uint64_t now = programs_compiled(pair.ours());
    if (now != compiled) calm = 0;
    compiled = now;
  }
  const double budget = options.quick ? 0.4 : 2.0;
  const int most = options.quick ? 15 : 60;
  const double start = seconds(CLOCK_MONOTONIC);
  Measured steady;
  for (int round = 0; round < most; ++round) {
    if (round >= 7 && seconds(CLOCK_MONOTONIC) - start > budget) break;
    pair.time_round(steady);
  }
  const float later = options.cull_everything ? 0 : pair.image_difference();
  write_row(table, scene, options, "steady", steady, programs_compiled(pair.ours()) - compiled,
            later);
  return std::max(difference, later) <= kTolerance;
}

void profile_scene(const SpeedScene& scene, const SpeedOptions& options, bool mesa, int frames) {
  std::unique_ptr<RenderContext> context;
  if (mesa) context = std::make_unique<MesaContext>(options.size, options.size);
  else
    context = std::make_unique<CoreContext>(options.size, options.size, PixelFormat::rgba8,
                                            default_options());
  prepare(*context, scene, options);
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) times.push_back(time_frame(*context, scene).cpu);
  std::printf("%s: median %.3f ms of CPU a frame\n", scene.name.c_str(), 1e3 * median(times));
  if (mesa) return;
  legacy_gl_statistics s;
  legacy_gl_get_statistics(&s);
  std::printf("draws %llu, general %llu, batches %llu, compiled %llu, switches %llu\n",
              static_cast<unsigned long long>(s.draws),
              static_cast<unsigned long long>(s.general_draws),
              static_cast<unsigned long long>(s.batches),
              static_cast<unsigned long long>(s.programs_compiled),
              static_cast<unsigned long long>(s.program_switches));
}

}  // namespace legacy_gl::test
