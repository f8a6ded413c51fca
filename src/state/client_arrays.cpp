#include "state/client_arrays.hpp"

namespace legacy_gl {

ClientArrays::ClientArrays() {
  arrays[kNormalArray].size = 3;
  arrays[kSecondaryColorArray].size = 3;
  arrays[kFogCoordArray].size = 1;
  arrays[kIndexArray].size = 1;
  arrays[kEdgeFlagArray].size = 1;
  arrays[kEdgeFlagArray].type = GL_UNSIGNED_BYTE;
}

unsigned array_index(GLenum array, unsigned client_unit) {
  switch (array) {
    case GL_VERTEX_ARRAY: return kVertexArray;
    case GL_NORMAL_ARRAY: return kNormalArray;
    case GL_COLOR_ARRAY: return kColorArray;
    case GL_SECONDARY_COLOR_ARRAY: return kSecondaryColorArray;
    case GL_FOG_COORD_ARRAY: return kFogCoordArray;
    case GL_INDEX_ARRAY: return kIndexArray;
    case GL_EDGE_FLAG_ARRAY: return kEdgeFlagArray;
    case GL_TEXTURE_COORD_ARRAY: return kTexCoordArray + client_unit;
    default: return kArrayCount;
  }
}

unsigned type_size(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT: return 2;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT: return 4;
    case GL_DOUBLE: return 8;
    default: return 0;
  }
}

namespace {

constexpr unsigned kFloat = sizeof(float);
// Four unsigned bytes take the room of a float (GL 2.1 spec table 2.5: "c" is 4 bytes rounded up to
// a float's).
constexpr unsigned kPacked = 4;

constexpr InterleavedFormat format(GLenum name, unsigned texcoord_size, unsigned color_size,
                                   GLenum color_type, bool has_normal, unsigned vertex_size) {
  InterleavedFormat f{name, texcoord_size, color_size, vertex_size, has_normal, color_type, 0, 0, 0,
                      0};
  f.color_offset = texcoord_size * kFloat;
  f.normal_offset = f.color_offset + (color_type == GL_FLOAT ? color_size * kFloat : kPacked);
  f.vertex_offset = f.normal_offset + (has_normal ? 3 * kFloat : 0);
  f.stride = f.vertex_offset + vertex_size * kFloat;
  return f;
}

constexpr InterleavedFormat kFormats[] = {
    format(GL_V2F, 0, 0, GL_FLOAT, false, 2),
    format(GL_V3F, 0, 0, GL_FLOAT, false, 3),
    format(GL_C4UB_V2F, 0, 4, GL_UNSIGNED_BYTE, false, 2),
    format(GL_C4UB_V3F, 0, 4, GL_UNSIGNED_BYTE, false, 3),
    format(GL_C3F_V3F, 0, 3, GL_FLOAT, false, 3),
    format(GL_N3F_V3F, 0, 0, GL_FLOAT, true, 3),
    format(GL_C4F_N3F_V3F, 0, 4, GL_FLOAT, true, 3),
    format(GL_T2F_V3F, 2, 0, GL_FLOAT, false, 3),
    format(GL_T4F_V4F, 4, 0, GL_FLOAT, false, 4),
    format(GL_T2F_C4UB_V3F, 2, 4, GL_UNSIGNED_BYTE, false, 3),
    format(GL_T2F_C3F_V3F, 2, 3, GL_FLOAT, false, 3),
    format(GL_T2F_N3F_V3F, 2, 0, GL_FLOAT, true, 3),
    format(GL_T2F_C4F_N3F_V3F, 2, 4, GL_FLOAT, true, 3),
    format(GL_T4F_C4F_N3F_V4F, 4, 4, GL_FLOAT, true, 4),
};

}  // namespace

const InterleavedFormat* find_interleaved_format(GLenum name) {
  for (const InterleavedFormat& candidate : kFormats)
    if (candidate.format == name) return &candidate;
  return nullptr;
}

}  // namespace legacy_gl
