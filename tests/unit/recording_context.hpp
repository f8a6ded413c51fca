// A context without a driver, current in this thread, and a renderer that writes down what it is
// asked to draw.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

#include "api/whole_context.hpp"
#include "dlist/dispatch.hpp"
#include "record/pending.hpp"
#include "record/renderer.hpp"

namespace legacy_gl::test {

/// The recorder's batch at the moment at which it was to be drawn.
struct DrawnBatch {
  VertexLayout layout;
  VertexOffsets offsets;
  std::vector<float> vertices;
  std::vector<PrimitiveRun> runs;
  std::vector<std::uint32_t> elements;

  std::size_t vertex_count() const { return vertices.size() / offsets.stride; }
  std::vector<float> floats(std::size_t vertex, unsigned offset, unsigned size) const {
    const auto begin =
        vertices.begin() + static_cast<std::ptrdiff_t>(vertex * offsets.stride + offset);
    return {begin, begin + size};
  }
  std::vector<float> position(std::size_t vertex) const {
    return floats(vertex, 0, offsets.position_size);
  }
  std::vector<float> color(std::size_t vertex) const { return floats(vertex, offsets.color, 4); }
  std::vector<float> normal(std::size_t vertex) const { return floats(vertex, offsets.normal, 3); }
  std::vector<float> material(std::size_t vertex, unsigned face, unsigned property) const {
    return floats(vertex, offsets.materials[face * kPropertyCount + property],
                  material_size(property));
  }
};

class NotingRenderer final : public Renderer {
 public:
  void draw_batch(Context& context) override {
    if (before_batch) before_batch();
    const Recorder& recorder = context.recorder;
    const std::size_t floats = std::size_t{recorder.vertex_count()} * recorder.offsets().stride;
    batches.push_back({recorder.layout(),
                       recorder.offsets(),
                       {recorder.data(), recorder.data() + floats},
                       recorder.runs(),
                       recorder.elements()});
    context.recorder.clear();
    context.dirty = 0;  // a draw brings everything up to date
  }
  void draw_bitmaps(Context&) override { ++bitmaps; }
  void draw_mesh(Context& context, const ListMesh& mesh) override {
    flush_pending(context);
    meshes.push_back(mesh.shared_from_this());
    colors_of_meshes.push_back(context.current.color);
  }
  bool detach_from_matrices(Context&) override { return false; }
  bool shade_batch(Context&) override { return false; }
  bool shades_next_draw(Context&) override { return false; }
  void recover(Context&) noexcept override {}

  std::vector<DrawnBatch> batches;
  std::vector<std::shared_ptr<const ListMesh>> meshes;
  std::vector<glm::vec4> colors_of_meshes;  ///< the current colour when each was drawn
  unsigned bitmaps = 0;
  std::function<void()> before_batch;
};

class RecordingTest : public testing::Test {
 protected:
  explicit RecordingTest(const legacy_gl_options& options = {}) : context(options) {
    context.renderer = &renderer;
    current_context = &context;
    update_direct_context();
  }
  ~RecordingTest() override {
    current_context = nullptr;
    update_direct_context();
  }

  /// All that was recorded until now.
  const std::vector<DrawnBatch>& drawn() {
    flush_pending(context);
    return renderer.batches;
  }
  GLenum take_error() { return std::exchange(context.error, GLenum{GL_NO_ERROR}); }
  /// A texture on unit 0, as far as the recorder asks.
  void enable_texture() {
    TextureObject& texture = *context.texture.units[0].bound[kTexture2D];
    texture.parameters.min_filter = GL_LINEAR;
    TextureImage& image = texture.images.at(0, 0);
    image.width = image.height = image.depth = 1;
    lglEnable(GL_TEXTURE_2D);
  }

  NotingRenderer renderer;
  WholeContext context;
};

/// Vertices (first, 0, 0), (first + 1, 0, 0), ...
inline void vertices_in_a_row(int count, int first = 0) {
  for (int i = 0; i < count; ++i) lglVertex3f(static_cast<float>(first + i), 0, 0);
}

inline void primitive(GLenum mode, int count, int first = 0) {
  lglBegin(mode);
  vertices_in_a_row(count, first);
  lglEnd();
}

}  // namespace legacy_gl::test
