// One frame that passes through every area of the library, for tests of what may happen anywhere:
// lack of memory, a driver that refuses, bindings that are touched. It allocates nothing itself.
#pragma once

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

constexpr int kEveryAreaSize = 96;

/// Makes its objects, draws, and deletes them again; leaves OpenGL's initial state. In tiles of 16
/// pixels, so that a fault is seen in its place.
void draw_every_area(const GlFunctions& gl);

}  // namespace legacy_gl::test
