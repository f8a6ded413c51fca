#include "driver/vertex_arrays.hpp"

#include "driver/debug_labels.hpp"
#include "shadergen/attributes.hpp"

namespace legacy_gl {

VertexArrays::~VertexArrays() {
  for (const auto& [key, array] : arrays_) driver_.DeleteVertexArrays(1, &array);
}

GLuint VertexArrays::find_or_build(const VertexLayout& layout, GLuint vertex_buffer,
                                   GLuint index_buffer) {
  const Key key{std::uint64_t{layout.fields} << 48 | std::uint64_t{layout.texcoords} << 40 |
                    std::uint64_t{layout.wide_texcoords} << 32 | layout.materials,
                vertex_buffer, index_buffer};
  if (const auto at = arrays_.find(key); at != arrays_.end()) return at->second;
  const GLuint array = build_vertex_array(driver_, layout, vertex_buffer, index_buffer);
  arrays_.emplace(key, array);
  return array;
}

GLuint build_buffer(const Driver& driver, GLenum target, const void* data, std::size_t size) {
  GLuint buffer = 0;
  driver.GenBuffers(1, &buffer);
  driver.BindBuffer(target, buffer);
  driver.BufferData(target, static_cast<GLsizeiptr>(size), data, GL_STATIC_DRAW);
  label(driver, GL_BUFFER, buffer, "mesh");
  return buffer;
}

GLuint build_vertex_array(const Driver& driver, const VertexLayout& layout, GLuint vertex_buffer,
                          GLuint index_buffer) {
  GLuint array = 0;
  driver.GenVertexArrays(1, &array);
  driver.BindVertexArray(array);
  driver.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer);
  driver.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer);
  const VertexOffsets offsets = offsets_of(layout);
  const auto attribute = [&](unsigned location, unsigned size, unsigned offset) {
    driver.EnableVertexAttribArray(location);
    driver.VertexAttribPointer(location, static_cast<GLint>(size), GL_FLOAT, GL_FALSE,
                               static_cast<GLsizei>(offsets.stride * sizeof(float)),
                               reinterpret_cast<const void*>(offset * sizeof(float)));
  };
  attribute(kLocationPosition, offsets.position_size, 0);
  if (layout.fields & kFieldNormal) attribute(kLocationNormal, 3, offsets.normal);
  if (layout.fields & (kFieldColor | kFieldShaded)) attribute(kLocationColor, 4, offsets.color);
  if (layout.fields & kFieldSecondaryColor)
    attribute(kLocationSecondaryColor, 3, offsets.secondary_color);
  if (layout.fields & kFieldFogCoord) attribute(kLocationFogCoord, 1, offsets.fog_coord);
  for (unsigned i = 0; i < 2 * kPropertyCount; ++i)
    if (layout.materials & (1u << i))
      attribute(material_location(layout.materials, i), material_size(i % kPropertyCount),
                offsets.materials[i]);
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
    if (layout.texcoords & 1u << unit && has_texcoord_location(layout.materials, unit))
      attribute(texcoord_location(unit), texcoord_size(layout, unit), offsets.texcoords[unit]);
  if (layout.fields & kFieldLightingPosition)
    attribute(kLocationLightingPosition, offsets.position_size, offsets.lighting_position);
  if (layout.fields & kFieldDepthOffset) attribute(kLocationDepthOffset, 1, offsets.depth_offset);
  if (layout.fields & kFieldLineOffset) attribute(kLocationLineOffset, 3, offsets.line_offset);
  return array;
}

}  // namespace legacy_gl
