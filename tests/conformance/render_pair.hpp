// Mesa's context and one of legacy_gl, kept between the tests of a program.
#pragma once

#include <memory>
#include <string>

#include "support/contexts.hpp"

namespace legacy_gl::test {

enum class Dialect { core_330, es_300 };

const char* dialect_name(Dialect dialect);

struct RenderPair {
  std::unique_ptr<RenderContext> mesa;
  std::unique_ptr<RenderContext> ours;
};

std::unique_ptr<RenderContext> make_context(Dialect dialect, int size, PixelFormat format);

// Created at the first call for these arguments, destroyed at the program's end.
RenderPair& render_pair(Dialect dialect, int size, PixelFormat format);
RenderContext& mesa_context(int size, PixelFormat format);

}  // namespace legacy_gl::test
