// GL 2.1 spec 3.6.3, 3.6.5: glPixelTransfer, glPixelMap, glPixelZoom.
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "dlist/dispatch.hpp"
#include "execute/queries.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool inside(Context& c) {
  if (!c.recorder.inside_begin_end()) return false;
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

float* real_parameter(PixelTransfer& transfer, GLenum name) {
  switch (name) {
    case GL_RED_SCALE: return &transfer.scale[0];
    case GL_GREEN_SCALE: return &transfer.scale[1];
    case GL_BLUE_SCALE: return &transfer.scale[2];
    case GL_ALPHA_SCALE: return &transfer.scale[3];
    case GL_RED_BIAS: return &transfer.bias[0];
    case GL_GREEN_BIAS: return &transfer.bias[1];
    case GL_BLUE_BIAS: return &transfer.bias[2];
    case GL_ALPHA_BIAS: return &transfer.bias[3];
    case GL_DEPTH_SCALE: return &transfer.depth_scale;
    case GL_DEPTH_BIAS: return &transfer.depth_bias;
    default: return nullptr;
  }
}

void pixel_transfer(Context& c, GLenum name, float value) {
  if (inside(c)) return;
  PixelTransfer& transfer = c.pixels.transfer;
  const auto integer = [&] { return as_integer(ValueKind::kFloat, static_cast<double>(value)); };
  switch (name) {
    case GL_MAP_COLOR: transfer.map_color = value != 0; return;
    case GL_MAP_STENCIL: transfer.map_stencil = value != 0; return;
    case GL_INDEX_SHIFT: transfer.index_shift = integer(); return;
    case GL_INDEX_OFFSET: transfer.index_offset = integer(); return;
    default: break;
  }
  float* const parameter = real_parameter(transfer, name);
  if (!parameter) return raise_error(c, GL_INVALID_ENUM);
  *parameter = value;
}

void pixel_transfer_integer(Context& c, GLenum name, GLint value) {
  if (inside(c)) return;
  PixelTransfer& transfer = c.pixels.transfer;
  if (name == GL_INDEX_SHIFT) transfer.index_shift = value;
  else if (name == GL_INDEX_OFFSET) transfer.index_offset = value;
  else pixel_transfer(c, name, static_cast<float>(value));
}

void pixel_zoom(Context& c, float x, float y) {
  if (inside(c)) return;
  c.pixels.transfer.zoom_x = x;
  c.pixels.transfer.zoom_y = y;
}

/// kPixelMapCount: no map.
unsigned map_index(GLenum name) {
  const GLenum index = name - GL_PIXEL_MAP_I_TO_I;
  return index < kPixelMapCount ? index : static_cast<unsigned>(kPixelMapCount);
}

bool holds_indices(unsigned map) { return map == kMapIToI || map == kMapSToS; }
bool maps_indices(unsigned map) { return map <= kMapIToA; }

bool is_power_of_two(GLsizei size) { return (size & (size - 1)) == 0; }

GLenum pixel_map_error(unsigned map, GLsizei size) {
  if (map == kPixelMapCount) return GL_INVALID_ENUM;
  const bool valid =
      size >= 1 && size <= kMaxPixelMapTable && (!maps_indices(map) || is_power_of_two(size));
  return valid ? GL_NO_ERROR : GL_INVALID_VALUE;
}

void pixel_map(Context& c, GLenum name, GLsizei size, const std::vector<float>* values) {
  if (inside(c)) return;
  const unsigned map = map_index(name);
  if (const GLenum error = pixel_map_error(map, size)) return raise_error(c, error);
  if (values) c.pixels.maps[map] = *values;
}

/// GL 2.1 spec 3.6.3: what is not an index is a colour, whole numbers of which are its whole range.
template <typename T>
float map_value(unsigned map, T value) {
  if (holds_indices(map)) return static_cast<float>(value);
  if constexpr (std::is_floating_point_v<T>) return value > 0 ? std::min(value, 1.0f) : 0.0f;
  else
    return static_cast<float>(static_cast<double>(value) /
                              static_cast<double>(std::numeric_limits<T>::max()));
}

template <typename T>
void set_pixel_map(GLenum name, GLsizei size, const T* values) {
  with_context([&](Context& c) {
    std::shared_ptr<std::vector<float>> kept;
    const unsigned map = map_index(name);
    if (values && pixel_map_error(map, size) == GL_NO_ERROR) {
      kept = std::make_shared<std::vector<float>>();
      for (GLsizei i = 0; i < size; ++i) kept->push_back(map_value(map, values[i]));
      c.lists.keep(kept);
    }
    const std::vector<float>* const taken = kept.get();
    dispatch<pixel_map>(name, size, taken);
  });
}

template <typename T>
T as_map_value(unsigned map, float value) {
  if constexpr (std::is_floating_point_v<T>) return value;
  constexpr double kLargest = static_cast<double>(std::numeric_limits<T>::max());
  const double scaled = static_cast<double>(value) * (holds_indices(map) ? 1 : kLargest);
  return static_cast<T>(std::clamp(std::round(scaled), 0.0, kLargest));
}

template <typename T>
void get_pixel_map(Context& c, GLenum name, T* values) {
  if (inside(c)) return;
  const unsigned map = map_index(name);
  if (map == kPixelMapCount) return raise_error(c, GL_INVALID_ENUM);
  if (!values) return;
  for (const float value : c.pixels.maps[map]) *values++ = as_map_value<T>(map, value);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglPixelTransferf(GLenum pname, GLfloat param) {
  dispatch<pixel_transfer>(pname, param);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPixelTransferi(GLenum pname, GLint param) {
  dispatch<pixel_transfer_integer>(pname, param);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPixelZoom(GLfloat xfactor, GLfloat yfactor) {
  dispatch<pixel_zoom>(xfactor, yfactor);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPixelMapfv(GLenum map, GLsizei mapsize,
                                                    const GLfloat* values) {
  set_pixel_map(map, mapsize, values);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPixelMapuiv(GLenum map, GLsizei mapsize,
                                                     const GLuint* values) {
  set_pixel_map(map, mapsize, values);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPixelMapusv(GLenum map, GLsizei mapsize,
                                                     const GLushort* values) {
  set_pixel_map(map, mapsize, values);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetPixelMapfv(GLenum map, GLfloat* values) {
  execute_now<get_pixel_map<GLfloat>>(map, values);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetPixelMapuiv(GLenum map, GLuint* values) {
  execute_now<get_pixel_map<GLuint>>(map, values);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetPixelMapusv(GLenum map, GLushort* values) {
  execute_now<get_pixel_map<GLushort>>(map, values);
}
