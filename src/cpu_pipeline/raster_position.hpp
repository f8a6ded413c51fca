#pragma once
// What every glRasterPos and glWindowPos comes down to (GL 2.1 spec 2.13).
#include "context/context.hpp"
#include "dlist/dispatch.hpp"

namespace legacy_gl {

namespace execute {

void raster_position(Context& c, float x, float y, float z, float w);
void window_position(Context& c, float x, float y, float z);

}  // namespace execute

inline void raster_position4(float x, float y, float z, float w) {
  dispatch<execute::raster_position>(x, y, z, w);
}
inline void raster_position3(float x, float y, float z) { raster_position4(x, y, z, 1); }
inline void raster_position2(float x, float y) { raster_position4(x, y, 0, 1); }
inline void window_position3(float x, float y, float z) {
  dispatch<execute::window_position>(x, y, z);
}
inline void window_position2(float x, float y) { window_position3(x, y, 0); }

}  // namespace legacy_gl
