#pragma once
#include <array>
#include <optional>
#include <vector>

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
#include "geometry/unfilled.hpp"
#include "geometry/visible_object.hpp"
#include "geometry/wide_lines.hpp"
#include "software/kept_batches.hpp"
#include "software/kept_objects.hpp"
#include "software/repeated_arrays.hpp"
#include "software/repeated_batches.hpp"
#include "software/repeated_objects.hpp"
#include "submit/accumulation_buffer.hpp"
#include "translate/draw_inputs.hpp"

namespace legacy_gl {

class ArrayGather;
struct ArrayDraw;
struct ElementRange;

/// The driver's side of a context: everything here may call the real GL, and nothing else may.
class Backend {
 public:
  Backend(const Driver& loaded, legacy_gl_programs programs, ProgramFiles files);

  /// Draws the recorder's batch and clears it. Unless it is the last part of its batch, more of the
  /// same state follows.
  void draw_recorded(Context& context, bool last);

  /// Transforms the recorder's last object, so that objects under other matrices can join its
  /// batch. False when the batch is to be drawn instead.
  bool transform_recorded(Context& context);

  /// Lights the recorder's last object, or what is recorded of it inside Begin/End, so that objects
  /// of any lights, materials and matrices share a batch. False when that cannot be.
  bool light_recorded(Context& context);
  /// An object that is recorded now can be lit as the batch's others are.
  bool stays_lit(Context& context);

  /// The mesh joins the recorder's batch, if it is small and that is worth it.
  bool join_mesh(Context& context, const ListMesh& mesh);

  /// Draws a display list's mesh in the present state.
  void draw_mesh(Context& context, const ListMesh& mesh);

  /// Brings blend, depth, masks, viewport and their like in the driver up to the context's.
  void apply_raster(Context& context);

  /// The text of both stages of the program that polygons are drawn with in the present state.
  std::string program_source(Context& context);

  ProgramCache& programs() { return programs_; }

  /// Forgets what is believed to be bound.
  void reset_driver_state();

  bool has_logic_op() const { return driver.LogicOp != nullptr; }

  BufferObjects& buffers() { return buffers_; }
  QueryObjects& queries() { return queries_; }
  Textures& textures() { return textures_; }
  void delete_buffer(GLuint name);

  /// Draws the enabled client arrays from the buffer objects that they lie in, without a copy.
  /// False when one of them does not lie in one, or not in a form that the driver draws.
  bool draw_from_buffers(Context& context, const ArrayDraw& draw);
  /// Draws many vertices of client arrays: converted straight into the driver's memory. False when
  /// that is not worth it, or when the primitives themselves are needed.
  bool draw_streamed(Context& context, const ArrayDraw& draw);

  /// A bitmap whose left lower corner is at the window coordinates (x, y); draw_bitmaps draws it.
  void add_bitmap(Context& context, GLint x, GLint y, const BitmapImage& image);
  void draw_bitmaps(Context& context);

  /// Draws the image at the current raster position, zoomed (GL 2.1 spec 3.6.4). Nothing waits.
  void draw_pixels(Context& context, const PixelImage& image);

  /// Lines are made wide here, because the driver draws thin ones alone.
  bool widens_lines(const Context& context) const;
  /// Lines are drawn as others, made here: wide or stippled.
  bool replaces_lines(const Context& context) const;

  void clear_accumulation(const Context& context);
  /// glAccum. Nothing waits.
  void accumulate(Context& context, GLenum operation, float value);

  const Driver driver;

 private:
  void return_accumulation(Context& context, const PixelRectangle& area, float factor);
  void load_tile(const PixelImage& image, const PixelTile& tile, const glm::vec4& place);
  void draw_tile(Context& context, const PixelImage& image, const PixelTile& tile);
  void draw_stencil(Context& context, const PixelRectangle& covered);
  /// `coordinates`: of the raster position, for textures; nullptr: pixels go to the framebuffer
  /// past texturing, fog and their like, as stencil indices do.
  void draw_pixel_quads(Context& context, PixelSource source, const std::vector<float>& vertices,
                        const RasterState& raster, const RasterTextureCoordinates* coordinates);
  const FramebufferFacts& framebuffer_facts(const Context& context);
  std::optional<SurfaceView> surface_view(Context& context, const ListMesh& mesh,
                                          const Surface& surface);
  /// False when the mesh is to be drawn whole.
  bool draw_surface(Context& context, const ListMesh& mesh, MeshBuffers::Entry& buffers);
  /// Triangles that cover no sample, or that others of their surface hide, are worth finding: the
  /// driver draws on the CPU.
  bool skips_unseen(const Context& context) const {
    return driver.traits.matches_cpu_arithmetic && !context.options.keep_unseen_triangles;
  }
  void draw_batch(Context& context);
  void draw_held(Context& context);
  void prepare(Context& context, const VertexLayout& layout);
  /// Brings the driver up to what is derived.
  void apply_derived(Context& context);
  /// False when the driver has refused it. The general block is uploaded where it is read.
  bool use_program(Context& context, GLenum mode, std::uint64_t vertices);
  /// The key of a draw, for its points.
  void draw_points(const Context& context, ProgramKey& key);
  bool splits_in_pipeline(const Recorder& recorder, const PrimitiveRun& run) const;
  bool use_program(Context& context, const ProgramKey& key, std::uint64_t vertices);
  /// Draws the batch when it has polygons that become lines or points, or lines that become others;
  /// otherwise false.
  bool draw_unfilled(Context& context);
  void widen_lines_of(Context& context, const VertexLayout& layout, const float* vertices);
  void stipple_lines_of(const Context& context);
  void upload_uniforms(Context& context);
  void upload_stale_blocks(Context& context);
  void stage_stale_blocks(Context& context);
  /// Where the block's values are to be written before upload_staged. It is bound with room for
  /// `room` bytes, as programs with longer arrays ask for.
  std::byte* stage_block(Context& context, UniformBlock block, std::size_t size, std::size_t room);
  void stage_block(Context& context, UniformBlock block, const void* data, std::size_t size);
  void stage_with_tail(Context& context, UniformBlock block, const void* head,
                       std::size_t head_size, const void* tail, std::size_t tail_size,
                       std::size_t room);
  void upload_staged();
  void bind_vertex_array(GLuint array);
  /// Those that have to see every dirty bit, each in its time.
  enum DirtyReader : unsigned {
    kDerivedReader,
    kLightingReader,
    kKeptObjectsReader,
    kDirtyReaders
  };
  /// The bits that this reader has not seen yet; what the context has is put by for the others.
  std::uint32_t take_dirty_bits(const Context& context, DirtyReader reader);
  /// Brings derived_ up to the state.
  void derive(Context& context, const VertexLayout& layout, const DrawFacts& facts = {});
  /// Objects may be lit here, if lighting_ does not say otherwise.
  bool may_light(Context& context) const;
  /// Brings lighting_ up to the state; false when vertices are not lit here in it.
  bool derive_lighting(Context& context, const DrawFacts& facts);
  bool joins_lit_objects(Context& context, const ListMesh& mesh);
  void light_vertices(Context& context);
  bool join_lit_mesh(Context& context, const ListMesh& mesh);
  bool join_repeated_object(Context& context);
  struct PlacedObject;
  void append_lit_object(Context& context, const ListMesh& mesh, const PlacedObject& placed,
                         bool keeps);
  std::uint32_t surroundings(Context& context);
  std::optional<KeptObjects::Key> kept_key(Context& context, const ListMesh& mesh);
  const KeptObjects::Entry* find_kept(const std::optional<KeptObjects::Key>& key);
  void append_kept_object(Context& context, const KeptObjects::Entry& kept);
  void draw_followed(Context& context);
  const std::vector<std::uint16_t>& seen_triangles(Context& context, const ObjectSurface& surface,
                                                   const Float4* clip, bool inside);
  bool can_transform(Context& context);
  bool begin_transformed(Context& context);
  void transform_vertices(Context& context);
  void enlarge_normals(Context& context, std::uint32_t first);
  void draw_runs(Context& context, std::uint32_t base_vertex);
  std::uint32_t upload_vertices(Context& context);
  std::optional<std::uint32_t> stream_vertices(Context& context, const ArrayGather& gather,
                                               const ElementRange& range);
  void set_constant_attributes(const Context& context, const VertexLayout& layout);
  const void* write_indices(Context& context, const void* indices, std::size_t size);

  BufferObjects buffers_;
  QueryObjects queries_;
  Textures textures_;
  ProgramCache programs_;
  StreamBuffer vertices_;
  StreamBuffer indices_;
  StreamBuffer uniforms_;
  VertexArrays arrays_;
  MeshBuffers meshes_;
  SeenTriangles seen_triangles_;
  SeenObject seen_object_;
  RepeatedBatches repeated_batches_;
  RepeatedArrays repeated_arrays_;
  RepeatedObjects repeated_objects_;
  std::optional<FramebufferFacts> framebuffer_facts_;
  BufferArrays buffer_arrays_;
  RasterApplier raster_;
  Bitmaps bitmaps_;
  /// Of the bitmaps that wait; it matters where they are textured.
  RasterTextureCoordinates bitmap_texture_coordinates_ = kInitialTextureCoordinates;
  PixelTexture pixel_texture_;
  AccumulationBuffer accumulation_;
  Derived derived_;
  Derived lighting_;  ///< of objects that are lit here: derived_ draws them with a program without
  SurroundingsNumbers surroundings_;
  std::uint32_t lit_surroundings_ = 0;  ///< in which usual objects are lit here; 0: not known
  KeptObjects kept_objects_;
  KeptBatches kept_batches_;
  /// Dirty bits that other readers have taken from the context.
  std::array<std::uint32_t, kDirtyReaders> unseen_{0, kDirtyAll, kDirtyAll};
  std::size_t uniform_alignment_ = 256;
  bool general_program_ = false;        ///< the program in use reads the general block
  GLuint bound_program_ = 0;
  GLuint bound_array_ = 0;
  std::vector<std::uint32_t> index_scratch_;
  std::vector<std::uint32_t> element_scratch_;
  std::vector<float> float_scratch_;
  struct StagedBlock {
    UniformBlock block;
    std::size_t offset, room;
  };
  std::vector<std::byte> block_scratch_;
  std::array<StagedBlock, kUniformBlockCount> staged_{};
  unsigned staged_count_ = 0;
  ExpandedBatch unfilled_scratch_;
  std::vector<float> wide_scratch_;
  std::vector<std::size_t> wide_ends_;  ///< in wide_scratch_, by group of the expanded batch
  std::vector<GLint> first_scratch_;
  std::vector<GLsizei> count_scratch_;
};

}  // namespace legacy_gl
