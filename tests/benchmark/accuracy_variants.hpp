// What the accuracy benchmark compares: Mesa's fixed function, this library in each quality, and
// the textbook's GLSL. Each lights the same samples, and the same vertices against the clock.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "oracle/sampler.hpp"
#include "stress/stress_classes.hpp"

namespace legacy_gl::test {

class Variant {
 public:
  explicit Variant(std::string name) : name_(std::move(name)) {}
  virtual ~Variant() = default;
  const std::string& name() const { return name_; }

  // A picture of tiles_across^2 batches.
  virtual oracle::SampleTarget target() = 0;
  // One vertex under extreme or degenerate state.
  virtual oracle::Color stress(const oracle::StressSample& sample) = 0;
  // The vertices that frame() lights, as triangles that are discarded once their vertices are lit.
  virtual void prepare_frames(const oracle::State& state,
                              const std::vector<oracle::Vertex>& vertices) = 0;
  virtual void frame() = 0;

 private:
  std::string name_;
};

inline constexpr int kTilesAcross = 16;

std::vector<std::unique_ptr<Variant>> accuracy_variants();

}  // namespace legacy_gl::test
