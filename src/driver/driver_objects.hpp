#pragma once
#include <optional>

#include "driver/bitmap_atlas.hpp"
#include "driver/buffer_arrays.hpp"
#include "driver/buffer_objects.hpp"
#include "driver/driver.hpp"
#include "driver/framebuffer_facts.hpp"
#include "driver/mesh_buffers.hpp"
#include "driver/pixel_texture.hpp"
#include "driver/program_cache.hpp"
#include "driver/query_objects.hpp"
#include "driver/raster_applier.hpp"
#include "driver/stream_buffer.hpp"
#include "driver/textures.hpp"
#include "driver/vertex_arrays.hpp"

namespace legacy_gl {

/// What one context has in the driver, and what of it is bound.
struct DriverObjects {
  DriverObjects(const Driver& loaded, legacy_gl_programs policy, ProgramFiles files);

  void bind_vertex_array(GLuint array);
  /// The program is the driver's current one afterwards. True when another was before.
  bool bind_program(GLuint program);
  /// Deletes the application's buffer object, and what refers to it.
  void delete_buffer(GLuint name);
  /// Deletes the driver's objects of lists and buffers that are gone.
  void free_deleted();
  /// Others have used the driver: nothing is known to be bound.
  void forget_bindings();

  const Driver functions;
  BufferObjects buffers;
  QueryObjects queries;
  Textures textures;
  ProgramCache programs;
  StreamBuffer vertex_stream, index_stream, uniform_stream;
  VertexArrays vertex_arrays;  ///< over vertex_stream and index_stream
  MeshBuffers meshes;
  BufferArrays buffer_arrays;
  RasterApplier raster;
  BitmapAtlas bitmaps;
  PixelTexture pixel_texture;
  std::optional<FramebufferFacts> framebuffer_facts;  ///< once asked
  GLuint bound_array = 0;                             ///< 0: not known

 private:
  GLuint bound_program_ = 0;  ///< 0: none of ours
};

}  // namespace legacy_gl
