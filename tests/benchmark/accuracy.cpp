// Run time against error of every way to light a vertex. scripts/bench accuracy runs it and makes
// the document.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "benchmark/accuracy_variants.hpp"
#include "benchmark/clock.hpp"
#include "benchmark/heap.hpp"
#include "oracle/single_vertex.hpp"

using namespace legacy_gl::test;

namespace {

using Variants = std::vector<std::unique_ptr<Variant>>;

struct Arguments {
  std::string errors, times, stress, driver;
  std::vector<std::string> classes;
  bool quick = false;
};

constexpr std::uint32_t kSeed = 1;

std::string driver_name() {
  MesaContext context(1, 1);
  const auto text = [&](GLenum name) {
    return std::string(reinterpret_cast<const char*>(context.gl.GetString(name)));
  };
  return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

bool wanted(const Arguments& arguments, const std::string& name) {
  const auto& classes = arguments.classes;
  return classes.empty() || std::find(classes.begin(), classes.end(), name) != classes.end();
}

void measure_errors(const Arguments& arguments, const Variants& variants) {
  std::ofstream table(arguments.errors);
  table << "class,variant,samples,largest,root_mean_square,largest_alpha,skipped\n";
  const int pictures = arguments.quick ? 1 : 5;  // of 262144 samples
  for (const auto& lighting_class : oracle::lighting_classes()) {
    if (!wanted(arguments, lighting_class.name)) continue;
    std::fprintf(stderr, "error: %s\n", lighting_class.name.c_str());
    for (const auto& variant : variants) {
      const oracle::ErrorStatistics error =
          oracle::run_class(lighting_class, kSeed, pictures, kTilesAcross, variant->target());
      char row[256];
      std::snprintf(row, sizeof row, "\"%s\",%s,%llu,%.4e,%.4e,%.1e,%llu\n",
                    lighting_class.name.c_str(), variant->name().c_str(),
                    static_cast<unsigned long long>(error.samples), error.largest,
                    error.root_mean_square(), error.largest_alpha,
                    static_cast<unsigned long long>(error.skipped));
      table << row << std::flush;
    }
  }
}

void measure_times(const Arguments& arguments, const Variants& variants) {
  std::ofstream table(arguments.times);
  table << "class,variant,vertices,cpu_ms,cpu_ratio_to_mesa,rounds\n";
  const int rounds = arguments.quick ? 9 : 41;
  for (const auto& lighting_class : oracle::lighting_classes()) {
    if (!wanted(arguments, lighting_class.name)) continue;
    std::fprintf(stderr, "time: %s\n", lighting_class.name.c_str());
    // The first batch, its vertices again and again: 49152 of them.
    const oracle::Batch batch = lighting_class.make(kSeed, 0);
    std::vector<oracle::Vertex> vertices;
    for (int i = 0; i < 48; ++i)
      vertices.insert(vertices.end(), batch.vertices.begin(), batch.vertices.end());
    for (const auto& variant : variants) variant->prepare_frames(batch.state, vertices);
    // Mesa compiles again in its fifth frame, this library once a program has proved its worth.
    constexpr int kWarmUp = 16;
    std::vector<std::vector<double>> seconds(variants.size()), ratios(variants.size());
    for (int round = -kWarmUp; round < rounds; ++round) {
      std::vector<double> frame(variants.size());
      for (std::size_t i = 0; i < variants.size(); ++i) {
        // The order changes, so that none always finds the caches of the same other one.
        const std::size_t at = (i + std::size_t(round + kWarmUp)) % variants.size();
        const double start = cpu_seconds();
        variants[at]->frame();
        frame[at] = cpu_seconds() - start;
      }
      if (round < 0) continue;
      for (std::size_t i = 0; i < variants.size(); ++i) {
        seconds[i].push_back(frame[i]);
        ratios[i].push_back(frame[i] / frame[0]);
      }
    }
    for (std::size_t i = 0; i < variants.size(); ++i) {
      char row[256];
      std::snprintf(row, sizeof row, "\"%s\",%s,%zu,%.4f,%.4f,%d\n", lighting_class.name.c_str(),
                    variants[i]->name().c_str(), vertices.size(), 1e3 * median(seconds[i]),
                    median(ratios[i]), rounds);
      table << row << std::flush;
    }
  }
}

bool is_presentable(const oracle::Color& color) {
  return std::all_of(color.begin(), color.end(),
                     [](float c) { return std::isfinite(c) && c >= 0 && c <= 1; });
}

void measure_stress(const Arguments& arguments, const Variants& variants) {
  std::ofstream table(arguments.stress);
  table << "class,variant,samples,judged,largest,not_presentable\n";
  constexpr double kJumpTolerance = 2e-6;  // as in tests/stress
  constexpr std::uint32_t kStressSeed = 7;
  const std::uint32_t samples = arguments.quick ? 150 : 1000;
  for (const auto& stress_class : oracle::stress_classes()) {
    std::fprintf(stderr, "stress: %s\n", stress_class.name.c_str());
    for (const auto& variant : variants) {
      double largest = 0;
      std::uint32_t judged = 0, not_presentable = 0;
      for (std::uint32_t i = 0; i < samples; ++i) {
        oracle::Random random(kStressSeed, i);
        const oracle::StressSample sample = stress_class.make(random);
        const oracle::Color color = variant->stress(sample);
        if (!is_presentable(color)) ++not_presentable;
        const oracle::Result result = evaluate(sample.state, sample.vertex);
        if (!result.defined ||
            (!stress_class.on_a_jump && result.distance_to_jump <= kJumpTolerance))
          continue;
        ++judged;
        const auto expected = oracle::expected_color(sample.state, sample.vertex);
        largest = std::max(largest, oracle::difference_steps(color, expected));
      }
      char row[256];
      std::snprintf(row, sizeof row, "\"%s\",%s,%u,%u,%.4e,%u\n", stress_class.name.c_str(),
                    variant->name().c_str(), samples, judged, largest, not_presentable);
      table << row << std::flush;
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  pin_heap();
  Arguments arguments;
  CLI::App app{"CPU time and error of lit vertices, by every variant"};
  app.add_option("--errors", arguments.errors, "write the errors of the classes to this file");
  app.add_option("--times", arguments.times, "write the CPU times of the classes to this file");
  app.add_option("--stress", arguments.stress,
                 "write the errors of the stress classes to this file");
  app.add_option("--driver", arguments.driver, "write the driver's name to this file");
  app.add_option("--class", arguments.classes, "only these (repeat it); all unless given");
  app.add_flag("--quick", arguments.quick, "fewer samples and rounds");
  CLI11_PARSE(app, argc, argv);
  try {
    const Variants variants = accuracy_variants();
    if (!arguments.driver.empty()) std::ofstream(arguments.driver) << driver_name() << '\n';
    if (!arguments.errors.empty()) measure_errors(arguments, variants);
    if (!arguments.times.empty()) measure_times(arguments, variants);
    if (!arguments.stress.empty()) measure_stress(arguments, variants);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "accuracy: %s\n", error.what());
    return 1;
  }
  return 0;
}
