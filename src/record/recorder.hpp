#pragma once
#include <array>
#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "geometry/primitive_run.hpp"
#include "geometry/vertex_layout.hpp"
#include "state/gl_types.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// Records glBegin/glEnd. Pairs that no state change separates join one batch, which is drawn when
/// a state changes, when it is large, or when the program asks for pixels.
class Recorder {
 public:
  bool inside_begin_end() const { return activity_ & kInside; }
  bool has_pending() const { return activity_ & kRuns; }
  bool is_idle() const { return activity_ == 0; }

  void begin(legacy_gl_context& context, GLenum mode);
  void end(legacy_gl_context& context);

  /// The hot path: the vertex takes the current values.
  void vertex(legacy_gl_context& context, float x, float y, float z);
  void vertex(legacy_gl_context& context, float x, float y, float z, float w);

  /// For client arrays: room for `count` vertices, which the caller fills as layout() says. The
  /// position has a w when `with_w`, or when the batch has one already; so with the texture
  /// coordinates of units in `wide_texcoords`. Follow with append_run or append_elements.
  float* append_vertices(legacy_gl_context& context, std::uint32_t count, bool with_w,
                         std::uint8_t wide_texcoords = 0);
  /// The last `count` vertices as primitives of `mode`.
  void append_run(legacy_gl_context& context, GLenum mode, std::uint32_t count);
  /// Room for `count` elements: vertices of the batch, drawn as primitives of `mode`.
  std::uint32_t* append_elements(legacy_gl_context& context, GLenum mode, std::uint32_t count);

  /// From here on vertices carry these material properties; those recorded before get the values of
  /// now.
  void carry_materials(legacy_gl_context& context, MaterialMask mask);

  // A small draw is what lies between two changes of matrix or material, of at most
  // kSmallDrawVertices. Small draws join one batch, unless that was tried and nothing came of it.

  /// A new one may join the batch, or begin one that others join.
  bool joins_small_draws(const legacy_gl_context& context);
  /// The pending batch goes on after a change: its last draw is small. Otherwise it is to be drawn.
  bool small_draw_may_end() const {
    return joining_ && vertex_count() - small_draw_first_ <= kSmallDrawVertices;
  }
  /// `crosses_clip_volume`: as PrimitiveRun says.
  void end_small_draw(bool crosses_clip_volume = false);
  /// Takes back the last vertices, which no primitive names yet.
  void drop_vertices(std::uint32_t count) { cursor_ -= std::size_t{count} * offsets_.stride; }
  /// What vertices of the current values hold: a whole vertex, of which the position is not set.
  void put_template(const legacy_gl_context& context, float* vertex);
  /// Writing a vertex may touch so many floats behind it.
  static constexpr std::size_t kSlackFloats = 4;
  /// Vertices from this one on are not transformed yet, in a batch of kFieldTransformed.
  std::uint32_t first_untransformed() const { return first_untransformed_; }
  void set_all_transformed() { first_untransformed_ = vertex_count(); }
  /// A batch of kFieldShaded.
  bool is_shaded() const { return !is_idle() && layout_.fields & kFieldShaded; }
  /// One whose vertices neither matrices nor lights nor materials change any more.
  bool all_shaded() const {
    return is_shaded() && !inside_begin_end() &&
           recorded_floats() == std::size_t{first_untransformed_} * kShadedStride;
  }
  static constexpr unsigned kShadedStride = 8;  ///< position and colour
  /// The batch, an empty one or one of positions and normals, becomes one of kFieldShaded.
  void become_shaded(legacy_gl_context& context);
  /// Room for vertices that are lit already; follow with append_elements.
  float* append_shaded(std::uint32_t count);
  void add_fields(const legacy_gl_context& context, std::uint16_t fields);
  float* data() { return storage_.get(); }
  /// From here on vertices carry the unit's r and q; those recorded before get 0 and 1.
  void carry_wide_texcoords(legacy_gl_context& context, unsigned unit);

  const VertexLayout& layout() const { return layout_; }
  const VertexOffsets& offsets() const { return offsets_; }
  const float* data() const { return storage_.get(); }
  std::uint32_t vertex_count() const {
    return static_cast<std::uint32_t>(cursor_ - storage_.get()) /
           (offsets_.stride ? offsets_.stride : 1);
  }
  const std::vector<PrimitiveRun>& runs() const { return runs_; }
  const std::vector<std::uint32_t>& elements() const { return elements_; }

  /// The current values in `count` vertices of `layout`, behind their positions.
  static void put_current(const legacy_gl_context& context, const VertexLayout& layout,
                          float* vertices, std::uint32_t count);

  /// Draws the batch when it has become large.
  void flush_if_large(legacy_gl_context& context);

  /// Forgets the batch; the storage stays.
  void clear();
  /// The same after an exception, inside Begin/End too: the primitive goes on with the next vertex.
  void abandon();

  /// The layout that the present state asks for.
  static VertexLayout relevant_layout(const legacy_gl_context& context);

 private:
  void start_batch(legacy_gl_context& context);
  void reserve(std::uint32_t more_vertices);
  void widen(const legacy_gl_context& context, const VertexLayout& layout);
  float* emit(legacy_gl_context& context);
  std::size_t recorded_floats() const { return static_cast<std::size_t>(cursor_ - storage_.get()); }
  void close_run(legacy_gl_context& context, GLenum mode, std::uint32_t first);
  void add_run(legacy_gl_context& context, const PrimitiveRun& run);

  /// The layouts that most programs use; their vertices are stored without a look at the layout.
  enum class Shape : std::uint8_t {
    kOther,
    kNormal,
    kShaded,
    kColor,
    kNormalAndColor,
    kNormalAndTexcoord,
    kColorAndTexcoord
  };

  /// What is under way, in one byte that calls look at: inside Begin/End; there are runs.
  enum Activity : std::uint8_t { kInside = 1, kRuns = 2 };
  void set_activity(Activity what, bool on) {
    activity_ = static_cast<std::uint8_t>(on ? activity_ | what : activity_ & ~what);
  }
  void runs_changed() { set_activity(kRuns, !runs_.empty()); }
  void set_layout(const VertexLayout& layout);
  void vertex_slowly(legacy_gl_context& context, float x, float y, float z);
  void set_limit();
  void draw_part(legacy_gl_context& context);

  /// A draw begins: counts those before it that differ in matrices and materials alone.
  void note_small_draw(const legacy_gl_context& context);
  bool worth_trying() const { return skip_ == 0 && similar_draws_ >= kSimilarDraws; }
  float* put_materials(const legacy_gl_context& context, float* at);

  std::uint32_t small_draw_first_ = 0;
  std::size_t small_draw_run_ = 0;  ///< its first of runs_
  std::uint32_t small_draws_ = 0;   ///< that ended in this batch
  std::uint32_t first_untransformed_ = 0;
  static constexpr std::uint32_t kSimilarDraws = 3;  ///< in a row before joining is tried
  std::uint32_t similar_draws_ = 0;  ///< that differ in matrices and materials alone
  bool joining_ = false;
  bool tried_joining_ = false;
  std::uint32_t skip_ = 0;  ///< batches that are not to be tried
  std::uint32_t backoff_ = 0;
  MaterialMask usual_materials_ = 0;  ///< what the last batch of several objects carried
  bool materials_cached_ = false;
  std::array<float, 34> materials_{};  ///< as the vertices carry them
  float* cursor_ = nullptr;
  float* limit_ = nullptr;  ///< a vertex fits while the cursor is before it; null outside Begin/End
  Shape shape_ = Shape::kOther;
  std::uint8_t activity_ = 0;
  VertexLayout layout_;
  VertexOffsets offsets_;
  GLenum mode_ = GL_POINTS;
  std::uint32_t first_ = 0;
  std::unique_ptr<float[]> storage_;
  std::size_t capacity_floats_ = 0;
  std::unique_ptr<float[]> spare_;  ///< what the vertices are moved to when they are widened
  std::size_t spare_floats_ = 0;
  std::vector<PrimitiveRun> runs_;
  std::vector<std::uint32_t> elements_;
};

}  // namespace legacy_gl
