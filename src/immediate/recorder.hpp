#pragma once
#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "immediate/vertex_layout.hpp"
#include "state/gl_types.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// Vertices `first` to `first + count - 1` of the batch, drawn as one or more primitives of `mode`.
/// An indexed run counts elements() instead, each of which names a vertex of the batch.
struct PrimitiveRun {
  GLenum mode = GL_POINTS;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool indexed = false;
};

/// Records glBegin/glEnd. Pairs that no state change separates join one batch, which is drawn when
/// a state changes, when it is large, or when the program asks for pixels.
class Recorder {
 public:
  bool inside_begin_end() const { return inside_; }
  bool has_pending() const { return !runs_.empty(); }
  bool is_idle() const { return !has_pending() && !inside_; }

  void begin(legacy_gl_context& context, GLenum mode);
  void end(legacy_gl_context& context);

  /// The hot path: the vertex takes the current values.
  void vertex(legacy_gl_context& context, float x, float y, float z);
  void vertex(legacy_gl_context& context, float x, float y, float z, float w);

  /// For client arrays: room for `count` vertices, which the caller fills as layout() says. The
  /// position has a w when `with_w`, or when the batch has one already. Follow with append_run or
  /// append_elements.
  float* append_vertices(legacy_gl_context& context, std::uint32_t count, bool with_w);
  /// The last `count` vertices as primitives of `mode`.
  void append_run(legacy_gl_context& context, GLenum mode, std::uint32_t count);
  /// Room for `count` elements: vertices of the batch, drawn as primitives of `mode`.
  std::uint32_t* append_elements(legacy_gl_context& context, GLenum mode, std::uint32_t count);

  /// From here on vertices carry these material properties; those recorded before get the values of
  /// now.
  void carry_materials(legacy_gl_context& context, MaterialMask mask);

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
  enum class Shape : std::uint8_t { kOther, kNormal, kColor, kNormalAndColor };

  void set_layout(const VertexLayout& layout);
  void vertex_slowly(legacy_gl_context& context, float x, float y, float z);
  void set_limit();
  void draw_part(legacy_gl_context& context);

  float* cursor_ = nullptr;
  float* limit_ = nullptr;  ///< a vertex fits while the cursor is before it; null outside Begin/End
  Shape shape_ = Shape::kOther;
  bool inside_ = false;
  VertexLayout layout_;
  VertexOffsets offsets_;
  GLenum mode_ = GL_POINTS;
  std::uint32_t first_ = 0;
  std::unique_ptr<float[]> storage_;
  std::size_t capacity_floats_ = 0;
  std::vector<PrimitiveRun> runs_;
  std::vector<std::uint32_t> elements_;
};

/// Vertices at the end of a run that complete no primitive are dropped (GL 2.1 spec 2.6.1).
std::uint32_t whole_primitives(GLenum mode, std::uint32_t count);

}  // namespace legacy_gl
