#include "driver/arithmetic_test.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>

#include "geometry/float4.hpp"
#include "shadergen/attributes.hpp"
#include "shadergen/generate.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

constexpr unsigned kVertices = 64;
using Positions = std::array<std::array<float, 3>, kVertices>;
using ClipPositions = std::array<std::array<float, 4>, kVertices>;

/// Numbers of full mantissas: each fused multiplication shows in some of them.
float awkward(unsigned i) {
  const float fraction = static_cast<float>(i * 2654435761u >> 8) / 16777216.0f;
  return (fraction - 0.5f) * static_cast<float>(1u << i % 7);
}

Positions test_positions() {
  Positions positions;
  for (unsigned i = 0; i < kVertices; ++i)
    for (unsigned c = 0; c < 3; ++c) positions[i][c] = awkward(3 * i + c + 1);
  return positions;
}

glm::mat4 test_matrix() {
  glm::mat4 matrix;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      matrix[column][row] = awkward(static_cast<unsigned>(1000 + 4 * column + row));
  return matrix;
}

bool can_capture(const Driver& driver) {
  GLint active = 1;
  if (!driver.TransformFeedbackVaryings || !driver.BeginTransformFeedback ||
      !driver.EndTransformFeedback || !driver.BindBufferBase)
    return false;
  driver.GetIntegerv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
  return !active;
}

/// The program's and the library's bindings that a capture changes.
class SavedBindings {
 public:
  explicit SavedBindings(const Driver& driver) : driver_(driver) {
    driver.GetIntegerv(GL_CURRENT_PROGRAM, &program_);
    driver.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &array_);
    driver.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &vertex_buffer_);
    driver.GetIntegerv(GL_UNIFORM_BUFFER_BINDING, &uniform_buffer_);
    driver.GetIntegerv(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, &capture_buffer_);
    driver.GetIntegerv(GL_RASTERIZER_DISCARD, &discard_);
  }
  ~SavedBindings() {
    if (!discard_) driver_.Disable(GL_RASTERIZER_DISCARD);
    driver_.UseProgram(name(program_));
    driver_.BindVertexArray(name(array_));
    driver_.BindBuffer(GL_ARRAY_BUFFER, name(vertex_buffer_));
    driver_.BindBuffer(GL_UNIFORM_BUFFER, name(uniform_buffer_));
    driver_.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, name(capture_buffer_));
  }
  SavedBindings(const SavedBindings&) = delete;
  SavedBindings& operator=(const SavedBindings&) = delete;

 private:
  static GLuint name(GLint value) { return static_cast<GLuint>(value); }
  const Driver& driver_;
  GLint program_ = 0, array_ = 0, vertex_buffer_ = 0, uniform_buffer_ = 0, capture_buffer_ = 0;
  GLint discard_ = 0;
};

GLuint compile(const Driver& driver, GLenum stage, const std::string& text) {
  const GLuint shader = driver.CreateShader(stage);
  const GLchar* const source = text.c_str();
  driver.ShaderSource(shader, 1, &source, nullptr);
  driver.CompileShader(shader);
  return shader;
}

/// The program of unlit primitives, its clip coordinates captured; 0 when it does not link.
GLuint capturing_program(const Driver& driver) {
  const ProgramSource source = generate(ProgramKey{}, driver.dialect);
  const GLuint program = driver.CreateProgram();
  for (const GLuint shader : {compile(driver, GL_VERTEX_SHADER, source.vertex),
                              compile(driver, GL_FRAGMENT_SHADER, source.fragment)}) {
    driver.AttachShader(program, shader);
    driver.DeleteShader(shader);
  }
  const GLchar* const captured = "gl_Position";
  driver.TransformFeedbackVaryings(program, 1, &captured, GL_INTERLEAVED_ATTRIBS);
  driver.LinkProgram(program);
  GLint linked = 0;
  driver.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return program;
  driver.DeleteProgram(program);
  return 0;
}

enum BufferUse : unsigned { kVertexUse, kUniformUse, kCaptureUse, kUses };

/// Draws the positions; `result` gets their clip coordinates.
bool capture(const Driver& driver, const Positions& positions, const TransformUniforms& uniforms,
             ClipPositions& result) {
  const SavedBindings saved(driver);
  const GLuint program = capturing_program(driver);
  if (!program) return false;
  std::array<GLuint, kUses> buffers{};
  GLuint array = 0;
  driver.GenBuffers(kUses, buffers.data());
  driver.GenVertexArrays(1, &array);
  driver.BindVertexArray(array);
  driver.BindBuffer(GL_ARRAY_BUFFER, buffers[kVertexUse]);
  driver.BufferData(GL_ARRAY_BUFFER, sizeof positions, positions.data(), GL_STATIC_DRAW);
  driver.EnableVertexAttribArray(kLocationPosition);
  driver.VertexAttribPointer(kLocationPosition, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  driver.BindBufferBase(GL_UNIFORM_BUFFER, kTransformBlock, buffers[kUniformUse]);
  driver.BufferData(GL_UNIFORM_BUFFER, sizeof uniforms, &uniforms, GL_STATIC_DRAW);
  driver.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[kCaptureUse]);
  driver.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, sizeof result, nullptr, GL_STATIC_READ);
  const GLuint block = driver.GetUniformBlockIndex(program, kUniformBlockNames[kTransformBlock]);
  driver.UniformBlockBinding(program, block, kTransformBlock);
  driver.UseProgram(program);
  driver.Enable(GL_RASTERIZER_DISCARD);
  driver.BeginTransformFeedback(GL_POINTS);
  driver.DrawArrays(GL_POINTS, 0, kVertices);
  driver.EndTransformFeedback();
  const void* const mapped =
      driver.MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof result, GL_MAP_READ_BIT);
  if (mapped) std::memcpy(result.data(), mapped, sizeof result);
  if (mapped) driver.UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  driver.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  driver.BindBufferBase(GL_UNIFORM_BUFFER, kTransformBlock, 0);
  driver.DeleteVertexArrays(1, &array);
  driver.DeleteBuffers(kUses, buffers.data());
  driver.DeleteProgram(program);
  return mapped != nullptr;
}

}  // namespace

bool measure_cpu_arithmetic(const Driver& driver) {
  if (!can_capture(driver)) return false;
  const Positions positions = test_positions();
  TransformUniforms uniforms;
  uniforms.modelview_projection = test_matrix();
  ClipPositions captured{};
  if (!capture(driver, positions, uniforms, captured)) return false;
  const Columns matrix = columns(uniforms.modelview_projection);
  for (unsigned i = 0; i < kVertices; ++i) {
    const Float4 expected =
        product(matrix, positions[i][0], positions[i][1], positions[i][2], 1.0f);
    // Bit by bit: -0 differs from 0, and a NaN equals itself.
    using Bits = std::array<std::uint32_t, 4>;
    if (std::bit_cast<Bits>(expected) != std::bit_cast<Bits>(captured[i])) return false;
  }
  return true;
}

namespace {

/// What tells one driver from another.
std::string identity_of(const Driver& driver) {
  std::string identity;
  for (const int name : {GL_VENDOR, GL_RENDERER, GL_VERSION})
    if (const auto* const text =
            reinterpret_cast<const char*>(driver.GetString(static_cast<GLenum>(name))))
      identity.append(text).push_back('\n');
  return identity;
}

}  // namespace

bool matches_cpu_arithmetic(const Driver& driver) {
  static std::mutex mutex;
  static std::map<std::string, bool> known;
  const std::string identity = identity_of(driver);
  const std::lock_guard lock(mutex);
  if (const auto at = known.find(identity); at != known.end()) return at->second;
  return known[identity] = measure_cpu_arithmetic(driver);
}

}  // namespace legacy_gl
