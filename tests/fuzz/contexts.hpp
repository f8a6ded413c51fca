// The contexts that a program is played on.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::fuzz {

constexpr int picture_width = 64;
constexpr int picture_height = 64;

enum class Dialect { core, es };

struct Mode {
  Dialect dialect = Dialect::core;
  legacy_gl_programs programs = LEGACY_GL_PROGRAMS_SPECIALISED;
  bool generic = false;  // the driver does not say that it is llvmpipe

  // For example core-general-generic.
  std::string name() const;
};

const std::vector<Mode>& all_modes();
// By name(). Throws std::runtime_error.
Mode mode_named(std::string_view name);

// What legacy_gl said that it does not do, since the last call.
std::vector<std::string> take_diagnostics();

std::unique_ptr<test::RenderContext> make_ours(const Mode& mode);
std::unique_ptr<test::RenderContext> make_mesa(Dialect dialect);

}  // namespace legacy_gl::fuzz
