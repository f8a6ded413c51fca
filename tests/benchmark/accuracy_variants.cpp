#include "benchmark/accuracy_variants.hpp"

#include <algorithm>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "benchmark/textbook.hpp"
#include "oracle/single_vertex.hpp"

namespace legacy_gl::test {

namespace {

using oracle::Batch;
using oracle::batch_side;
using oracle::Matrix4;
using oracle::State;
using oracle::Vertex;

constexpr int kWidth = kTilesAcross * batch_side;
constexpr int kStressSize = 2;
constexpr int kFrameSize = 64;
constexpr GLenum kRasterizerDiscard = 0x8C89;  // of the driver's OpenGL 3.0

Matrix4 product(const Matrix4& a, const Matrix4& b) {
  const glm::dmat4 m = glm::make_mat4(a.data()) * glm::make_mat4(b.data());
  Matrix4 out;
  std::copy_n(glm::value_ptr(m), 16, out.begin());
  return out;
}

// Mesa or this library: anything that speaks OpenGL 1.x.
template <class Context>
class FixedFunction final : public Variant {
 public:
  template <class... Options>
  explicit FixedFunction(std::string name, const Options&... options)
      : Variant(std::move(name)),
        picture_(kWidth, kWidth, PixelFormat::rgba32f, options...),
        vertex_(kStressSize, kStressSize, PixelFormat::rgba32f, options...),
        frames_(kFrameSize, kFrameSize, PixelFormat::rgba32f, options...) {
    const GlFunctions& gl = frames_.gl;
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    // The library leaves the driver's own state alone.
    if constexpr (std::is_same_v<Context, CoreContext>)
      reinterpret_cast<void (*)(GLenum)>(CoreContext::driver_proc("glEnable"))(kRasterizerDiscard);
    else gl.Enable(kRasterizerDiscard);
  }

  oracle::SampleTarget target() override {
    return {[this] {
              picture_.make_current();
              picture_.gl.ClearColor(0, 0, 0, 0);
              picture_.gl.Clear(GL_COLOR_BUFFER_BIT);
            },
            [this](const Batch& batch, std::uint32_t number) {
              oracle::draw_batch(picture_.gl, batch, number, kTilesAcross);
            },
            [this] {
              image_ = picture_.read_float();
              return static_cast<const float*>(image_.floats.data());
            }};
  }

  oracle::Color stress(const oracle::StressSample& sample) override {
    vertex_.make_current();
    return oracle::draw_lit_vertex(vertex_, sample.state, sample.vertex);
  }

  void prepare_frames(const State& state, const std::vector<Vertex>& vertices) override {
    frames_.make_current();
    const GlFunctions& gl = frames_.gl;
    oracle::apply_state(gl, state, oracle::placing_projection(state.modelview, 1));
    count_ = GLsizei(vertices.size());
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
                  GL_STATIC_DRAW);
    constexpr auto stride = GLsizei(sizeof(Vertex));
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    gl.VertexPointer(3, GL_FLOAT, stride, at(offsetof(Vertex, position_object)));
    gl.NormalPointer(GL_FLOAT, stride, at(offsetof(Vertex, normal_object)));
    gl.ColorPointer(4, GL_FLOAT, stride, at(offsetof(Vertex, color)));
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_NORMAL_ARRAY);
    if (state.color_material.enabled) gl.EnableClientState(GL_COLOR_ARRAY);
    else gl.DisableClientState(GL_COLOR_ARRAY);
  }

  void frame() override {
    frames_.make_current();
    frames_.gl.DrawArrays(GL_TRIANGLES, 0, count_);
    frames_.gl.Finish();
  }

 private:
  Context picture_, vertex_, frames_;
  Image image_;
  GLsizei count_ = 0;
};

class TextbookVariant final : public Variant {
 public:
  TextbookVariant()
      : Variant("textbook GLSL"),
        picture_(kWidth, kWidth),
        vertex_(kStressSize, kStressSize),
        frames_(kFrameSize, kFrameSize) {
    frames_.discard_fragments();
  }

  oracle::SampleTarget target() override {
    return {[this] {
              picture_.make_current();
              picture_.clear();
            },
            [this](const Batch& batch, std::uint32_t number) {
              const int x = int(number) % kTilesAcross,
                        y = int(number) / kTilesAcross % kTilesAcross;
              picture_.viewport(x * batch_side, y * batch_side, batch_side, batch_side);
              const Matrix4& modelview = batch.state.modelview;
              picture_.set_state(
                  batch.state,
                  product(oracle::placing_projection(modelview, batch.object_radius), modelview));
              const std::vector<Vertex> vertices = oracle::drawn_vertices(batch, number);
              picture_.upload(vertices);
              picture_.draw(oracle::drawn_mode(batch), int(vertices.size()));
            },
            [this] {
              image_ = picture_.read();
              return static_cast<const float*>(image_.floats.data());
            }};
  }

  oracle::Color stress(const oracle::StressSample& sample) override {
    vertex_.make_current();
    vertex_.clear();
    const Matrix4& modelview = sample.state.modelview;
    vertex_.set_state(
        sample.state,
        product(oracle::pinning_projection(modelview, sample.vertex.position_object), modelview));
    vertex_.point_size(2 * kStressSize);
    vertex_.upload({&sample.vertex, 1});
    vertex_.draw(GL_POINTS, 1);
    const Image image = vertex_.read();
    oracle::Color color;
    std::copy_n(image.floats.begin() + 12, 4, color.begin());
    return color;
  }

  void prepare_frames(const State& state, const std::vector<Vertex>& vertices) override {
    frames_.make_current();
    frames_.set_state(state,
                      product(oracle::placing_projection(state.modelview, 1), state.modelview));
    frames_.upload(vertices);
    count_ = int(vertices.size());
  }

  void frame() override {
    frames_.make_current();
    frames_.draw(GL_TRIANGLES, count_);
    frames_.finish();
  }

 private:
  Textbook picture_, vertex_, frames_;
  Image image_;
  int count_ = 0;
};

std::unique_ptr<Variant> of_quality(const char* name, legacy_gl_quality quality) {
  legacy_gl_options options = {};
  options.quality = quality;
  return std::make_unique<FixedFunction<CoreContext>>(name, options);
}

}  // namespace

std::vector<std::unique_ptr<Variant>> accuracy_variants() {
  std::vector<std::unique_ptr<Variant>> variants;
  variants.push_back(std::make_unique<FixedFunction<MesaContext>>("Mesa"));
  variants.push_back(std::make_unique<TextbookVariant>());
  variants.push_back(of_quality("fastest", LEGACY_GL_QUALITY_FASTEST));
  variants.push_back(of_quality("default", LEGACY_GL_QUALITY_DEFAULT));
  variants.push_back(of_quality("precise", LEGACY_GL_QUALITY_PRECISE));
  return variants;
}

}  // namespace legacy_gl::test
