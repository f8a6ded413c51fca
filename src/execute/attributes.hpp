#pragma once
// What every glVertex, glNormal, glColor ... comes down to once its arguments are floats.
#include "record/pending.hpp"

namespace legacy_gl {

namespace execute {

inline void vertex3(Context& c, float x, float y, float z) { c.recorder.vertex(c, x, y, z); }
inline void vertex4(Context& c, float x, float y, float z, float w) {
  c.recorder.vertex(c, x, y, z, w);
}
inline void normal3(Context& c, float x, float y, float z) { c.current.normal = {x, y, z}; }
inline void color4(Context& c, float r, float g, float b, float a) {
  c.current.color = {r, g, b, a};
}
inline void secondary_color3(Context& c, float r, float g, float b) {
  c.current.secondary_color = {r, g, b, 1};
}
inline void texcoord4(Context& c, unsigned unit, float s, float t, float r, float q) {
  if (r != 0 || q != 1) [[unlikely]]
    c.recorder.carry_wide_texcoords(c, unit);
  c.current.texture_coordinates[unit] = {s, t, r, q};
}
inline void fog_coord(Context& c, float coordinate) { c.current.fog_coordinate = coordinate; }
inline void edge_flag(Context& c, bool flag) { c.current.edge_flag = flag; }
inline void index(Context& c, float value) { c.current.index = value; }
void multi_texcoord4(Context& c, GLenum target, float s, float t, float r, float q);
void rect(Context& c, float x1, float y1, float x2, float y2);

}  // namespace execute

}  // namespace legacy_gl
