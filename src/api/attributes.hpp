#pragma once
// The entry points of vertices and their attributes come down to these: executed or recorded.
#include "dlist/dispatch.hpp"
#include "execute/attributes.hpp"

namespace legacy_gl {

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
