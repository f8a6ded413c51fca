#include "driver/driver_objects.hpp"

#include <utility>

namespace legacy_gl {

namespace {

constexpr std::size_t kVertexRingBytes = std::size_t{8} << 20;
constexpr std::size_t kIndexRingBytes = std::size_t{2} << 20;
constexpr std::size_t kUniformRingBytes = std::size_t{1} << 20;

}  // namespace

DriverObjects::DriverObjects(const Driver& loaded, legacy_gl_programs policy, ProgramFiles files)
    : functions(loaded),
      buffers(functions),
      queries(functions),
      textures(functions),
      programs(functions, policy, std::move(files)),
      vertex_stream(functions, GL_ARRAY_BUFFER, kVertexRingBytes, StreamBuffer::Use::kOneDraw),
      index_stream(functions, GL_COPY_WRITE_BUFFER, kIndexRingBytes, StreamBuffer::Use::kOneDraw),
      uniform_stream(functions, GL_UNIFORM_BUFFER, kUniformRingBytes,
                     StreamBuffer::Use::kManyDraws),
      vertex_arrays(functions),
      meshes(functions),
      buffer_arrays(functions),
      bitmaps(functions),
      pixel_texture(functions) {
  if (!functions.traits.draws_wide_lines) raster.keep_lines_thin();
}

void DriverObjects::bind_vertex_array(GLuint array) {
  if (array == bound_array) return;
  functions.BindVertexArray(array);
  bound_array = array;
}

bool DriverObjects::bind_program(GLuint program) {
  if (program == bound_program_) return false;
  programs.bind(program, bound_program_ != 0);
  bound_program_ = program;
  return true;
}

void DriverObjects::delete_buffer(GLuint name) {
  if (const BufferPointer buffer = buffers.find(name)) {
    buffer_arrays.forget(buffer->serial);
    bound_array = 0;
  }
  buffers.remove(name);
}

void DriverObjects::free_deleted() {
  const bool stale = buffers.deleted_elsewhere();
  if (stale) buffer_arrays.clear();
  if (meshes.free_deleted() || stale) bound_array = 0;  // it may be one of those
  buffers.free_deleted();
}

void DriverObjects::forget_bindings() {
  bound_program_ = bound_array = 0;
  raster.forget();
  framebuffer_facts.reset();
  textures.forget_bindings();
}

}  // namespace legacy_gl
