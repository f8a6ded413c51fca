#pragma once
// What every glRasterPos and glWindowPos comes down to (GL 2.1 spec 2.13).
#include "context/context.hpp"

namespace legacy_gl {

namespace execute {

void raster_position(Context& c, float x, float y, float z, float w);
void window_position(Context& c, float x, float y, float z);

}  // namespace execute

}  // namespace legacy_gl
