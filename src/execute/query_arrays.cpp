// What glGet answers about client arrays and buffer bindings (GL 2.1 spec tables 6.6 to 6.9).
#include "driver/buffer_objects.hpp"
#include "execute/queries.hpp"

namespace legacy_gl {

namespace {

using enum ValueKind;

template <ArrayIndex kArray>
const ClientArray& array_of(const Context& c) {
  constexpr bool kPerUnit = kArray == kTexCoordArray;
  return c.arrays.arrays[kArray + (kPerUnit ? c.client_active_texture : 0)];
}

GLuint name_of(const BufferPointer& buffer) { return buffer ? buffer->name : 0; }

template <ArrayIndex kArray>
void size(Context& c, QueryValues& v) {
  v.put(array_of<kArray>(c).size);
}
template <ArrayIndex kArray>
void type(Context& c, QueryValues& v) {
  v.put(array_of<kArray>(c).type);
}
template <ArrayIndex kArray>
void stride(Context& c, QueryValues& v) {
  v.put(array_of<kArray>(c).stride);
}
template <ArrayIndex kArray>
void buffer(Context& c, QueryValues& v) {
  v.put(name_of(array_of<kArray>(c).buffer));
}
constexpr Query kForms[] = {
    {GL_VERTEX_ARRAY_SIZE, kInteger, size<kVertexArray>},
    {GL_VERTEX_ARRAY_TYPE, kInteger, type<kVertexArray>},
    {GL_VERTEX_ARRAY_STRIDE, kInteger, stride<kVertexArray>},
    {GL_NORMAL_ARRAY_TYPE, kInteger, type<kNormalArray>},
    {GL_NORMAL_ARRAY_STRIDE, kInteger, stride<kNormalArray>},
    {GL_COLOR_ARRAY_SIZE, kInteger, size<kColorArray>},
    {GL_COLOR_ARRAY_TYPE, kInteger, type<kColorArray>},
    {GL_COLOR_ARRAY_STRIDE, kInteger, stride<kColorArray>},
    {GL_SECONDARY_COLOR_ARRAY_SIZE, kInteger, size<kSecondaryColorArray>},
    {GL_SECONDARY_COLOR_ARRAY_TYPE, kInteger, type<kSecondaryColorArray>},
    {GL_SECONDARY_COLOR_ARRAY_STRIDE, kInteger, stride<kSecondaryColorArray>},
    {GL_FOG_COORD_ARRAY_TYPE, kInteger, type<kFogCoordArray>},
    {GL_FOG_COORD_ARRAY_STRIDE, kInteger, stride<kFogCoordArray>},
    {GL_INDEX_ARRAY_TYPE, kInteger, type<kIndexArray>},
    {GL_INDEX_ARRAY_STRIDE, kInteger, stride<kIndexArray>},
    {GL_EDGE_FLAG_ARRAY_STRIDE, kInteger, stride<kEdgeFlagArray>},
    {GL_TEXTURE_COORD_ARRAY_SIZE, kInteger, size<kTexCoordArray>},
    {GL_TEXTURE_COORD_ARRAY_TYPE, kInteger, type<kTexCoordArray>},
    {GL_TEXTURE_COORD_ARRAY_STRIDE, kInteger, stride<kTexCoordArray>},
};

constexpr Query kBindings[] = {
    {GL_ARRAY_BUFFER_BINDING, kInteger,
     [](Context& c, QueryValues& v) { v.put(name_of(c.arrays.array_buffer)); }},
    {GL_ELEMENT_ARRAY_BUFFER_BINDING, kInteger,
     [](Context& c, QueryValues& v) { v.put(name_of(c.arrays.element_buffer)); }},
    {GL_VERTEX_ARRAY_BUFFER_BINDING, kInteger, buffer<kVertexArray>},
    {GL_NORMAL_ARRAY_BUFFER_BINDING, kInteger, buffer<kNormalArray>},
    {GL_COLOR_ARRAY_BUFFER_BINDING, kInteger, buffer<kColorArray>},
    {GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING, kInteger, buffer<kSecondaryColorArray>},
    {GL_FOG_COORD_ARRAY_BUFFER_BINDING, kInteger, buffer<kFogCoordArray>},
    {GL_INDEX_ARRAY_BUFFER_BINDING, kInteger, buffer<kIndexArray>},
    {GL_EDGE_FLAG_ARRAY_BUFFER_BINDING, kInteger, buffer<kEdgeFlagArray>},
    {GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, kInteger, buffer<kTexCoordArray>},
};

constexpr std::span<const Query> kGroups[] = {kForms, kBindings};

}  // namespace

QueryGroups array_queries() { return kGroups; }

}  // namespace legacy_gl
