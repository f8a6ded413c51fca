// Plays a program on Mesa and on legacy_gl, and says what differs.
#pragma once

#include <map>
#include <optional>

#include "fuzz/comparison.hpp"
#include "fuzz/contexts.hpp"

namespace legacy_gl::fuzz {

class Judge {
 public:
  explicit Judge(const Program& program, int frames = frame_count)
      : program_(program), frames_(frames) {}
  std::optional<Difference> difference(const Mode& mode);

 private:
  const Program& program_;
  int frames_;
  std::map<Dialect, Recording> mesa_;  // one serves all modes of a dialect
};

// Before main returns: Mesa's own destructors of static objects run in an unknown order after it.
void close_contexts();

// In a process of its own, where a crash or a hang of either is a difference too.
std::optional<Difference> difference_in_child(const Program& program, const Mode& mode);

}  // namespace legacy_gl::fuzz
