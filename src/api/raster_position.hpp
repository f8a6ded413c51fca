#pragma once
// The entry points of the raster position come down to these: executed or recorded.
#include "cpu_pipeline/raster_position.hpp"
#include "dlist/dispatch.hpp"

namespace legacy_gl {

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
