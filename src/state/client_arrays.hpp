#pragma once
#include <array>
#include <cstddef>
#include <memory>

#include "state/current.hpp"
#include "state/gl_types.hpp"

namespace legacy_gl {

struct BufferObject;

/// The client arrays of GL 1.5 (GL 2.1 spec 2.8), and where each is kept.
enum ArrayIndex : unsigned {
  kVertexArray,
  kNormalArray,
  kColorArray,
  kSecondaryColorArray,
  kFogCoordArray,
  kIndexArray,
  kEdgeFlagArray,
  kTexCoordArray,  ///< and one for each further texture unit
};
inline constexpr unsigned kArrayCount = kTexCoordArray + kMaxTextureUnits;

/// What gl*Pointer and glEnableClientState set (GL 2.1 spec table 6.6 and 6.7).
struct ClientArray {
  bool enabled = false;
  GLint size = 4;
  GLenum type = GL_FLOAT;
  GLsizei stride = 0;             ///< as given: 0 stands for tightly packed
  const void* pointer = nullptr;  ///< an address, or an offset in bytes into `buffer`
  std::shared_ptr<BufferObject> buffer;
  bool buffer_deleted = false;  ///< `pointer` is an offset into a buffer object that is gone
  bool operator==(const ClientArray&) const = default;
};

struct ClientArrays {
  ClientArrays();

  std::array<ClientArray, kArrayCount> arrays;
  std::shared_ptr<BufferObject> array_buffer;
  std::shared_ptr<BufferObject> element_buffer;
  bool operator==(const ClientArrays&) const = default;
};

/// GL_VERTEX_ARRAY ... GL_SECONDARY_COLOR_ARRAY to its place; kArrayCount for another enum.
unsigned array_index(GLenum array, unsigned client_unit);

/// Bytes of one component; 0 for an enum that is no component type.
unsigned type_size(GLenum type);

/// One format of glInterleavedArrays (GL 2.1 spec table 2.5), offsets and stride in bytes.
struct InterleavedFormat {
  GLenum format;
  unsigned texcoord_size, color_size, vertex_size;  ///< 0: no such array
  bool has_normal;
  GLenum color_type;
  unsigned color_offset, normal_offset, vertex_offset, stride;
};

/// nullptr for an enum that is no format.
const InterleavedFormat* find_interleaved_format(GLenum format);

}  // namespace legacy_gl
