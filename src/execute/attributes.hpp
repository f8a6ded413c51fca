#pragma once
// What every glVertex, glNormal, glColor ... comes down to once its arguments are floats.
#include "context/context.hpp"
#include "dlist/dispatch.hpp"

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

inline void vertex3(float x, float y, float z) { dispatch<execute::vertex3>(x, y, z); }
inline void vertex2(float x, float y) { vertex3(x, y, 0); }
inline void vertex4(float x, float y, float z, float w) { dispatch<execute::vertex4>(x, y, z, w); }
inline void normal3(float x, float y, float z) { dispatch<execute::normal3>(x, y, z); }
inline void color4(float r, float g, float b, float a) { dispatch<execute::color4>(r, g, b, a); }
inline void color3(float r, float g, float b) { color4(r, g, b, 1); }
inline void secondary_color3(float r, float g, float b) {
  dispatch<execute::secondary_color3>(r, g, b);
}
inline void texcoord4(unsigned unit, float s, float t, float r, float q) {
  dispatch<execute::texcoord4>(unit, s, t, r, q);
}
inline void texcoord3(unsigned unit, float s, float t, float r) { texcoord4(unit, s, t, r, 1); }
inline void texcoord2(unsigned unit, float s, float t) { texcoord4(unit, s, t, 0, 1); }
inline void texcoord1(unsigned unit, float s) { texcoord4(unit, s, 0, 0, 1); }
inline void multi_texcoord4(GLenum target, float s, float t, float r, float q) {
  if (const GLenum unit = target - GL_TEXTURE0; unit < kMaxTextureUnits)
    return texcoord4(unit, s, t, r, q);
  dispatch<execute::multi_texcoord4>(target, s, t, r, q);
}
inline void multi_texcoord3(GLenum target, float s, float t, float r) {
  multi_texcoord4(target, s, t, r, 1);
}
inline void multi_texcoord2(GLenum target, float s, float t) {
  multi_texcoord4(target, s, t, 0, 1);
}
inline void multi_texcoord1(GLenum target, float s) { multi_texcoord4(target, s, 0, 0, 1); }
inline void fog_coord(float coordinate) { dispatch<execute::fog_coord>(coordinate); }
inline void edge_flag(bool flag) { dispatch<execute::edge_flag>(flag); }
inline void index(float value) { dispatch<execute::index>(value); }
inline void rect(float x1, float y1, float x2, float y2) {
  dispatch<execute::rect>(x1, y1, x2, y2);
}

}  // namespace legacy_gl
