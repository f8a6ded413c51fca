#include "driver/program_linker.hpp"

#include <algorithm>
#include <vector>

#include "driver/debug_labels.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

/// Without the two lines that say the version and the key.
std::string without_title(const std::string& text) {
  const std::size_t first = text.find('\n');
  const std::size_t second = first == std::string::npos ? first : text.find('\n', first + 1);
  return second == std::string::npos ? text : text.substr(second + 1);
}

}  // namespace

ProgramLinker::ProgramLinker(const Driver& driver, bool keeps_binaries) : driver_(driver) {
  pipelines_ = driver.traits.shares_fragment_stages;
  GLint formats = 0;
  if (keeps_binaries && driver.GetProgramBinary && driver.ProgramBinary && driver.ProgramParameteri)
    driver.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
  binaries_ = formats > 0;
}

ProgramLinker::~ProgramLinker() {
  for (const auto& [program, stages] : programs_) {
    if (pipelines_) driver_.DeleteProgramPipelines(1, &program);
    driver_.DeleteProgram(stages.vertex);
  }
  for (const auto& [text, fragment] : fragments_) driver_.DeleteProgram(fragment);
}

bool ProgramLinker::is_linked(GLuint program) const {
  GLint linked = 0;
  driver_.GetProgramiv(program, GL_LINK_STATUS, &linked);
  return linked != 0;
}

GLuint ProgramLinker::compile(GLenum stage, const std::string& text) {
  const GLuint shader = driver_.CreateShader(stage);
  const GLchar* const source = text.c_str();
  driver_.ShaderSource(shader, 1, &source, nullptr);
  driver_.CompileShader(shader);
  GLint compiled = 0;
  driver_.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  GLchar log[2048] = {};
  driver_.GetShaderInfoLog(shader, sizeof log, nullptr, log);
  error_ = std::string(log) + "\n" + text;
  driver_.DeleteShader(shader);
  return 0;
}

/// One of them may be 0 where programs are pipelines. Both are deleted.
GLuint ProgramLinker::link_shaders(GLuint vertex, GLuint fragment) {
  GLuint program = driver_.CreateProgram();
  for (const GLuint shader : {vertex, fragment})
    if (shader) driver_.AttachShader(program, shader);
  if (pipelines_) driver_.ProgramParameteri(program, GL_PROGRAM_SEPARABLE, GL_TRUE);
  if (binaries_) driver_.ProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  driver_.LinkProgram(program);
  driver_.DeleteShader(vertex);  // 0 is ignored
  driver_.DeleteShader(fragment);
  if (is_linked(program)) return program;
  GLchar log[2048] = {};
  driver_.GetProgramInfoLog(program, sizeof log, nullptr, log);
  error_ = log;
  driver_.DeleteProgram(program);
  return 0;
}

GLuint ProgramLinker::link_stage(GLenum stage, const std::string& text) {
  const GLuint shader = compile(stage, text);
  if (!shader) return 0;
  const bool vertex = stage == GL_VERTEX_SHADER;
  const GLuint program = link_shaders(vertex ? shader : 0, vertex ? 0 : shader);
  if (!program) error_ += "\n" + text;
  return program;
}

GLuint ProgramLinker::fragment_stage(const std::string& text, legacy_gl_statistics& statistics) {
  GLuint& program = fragments_[without_title(text)];
  if (program) ++statistics.fragment_stages_shared;
  else program = link_stage(GL_FRAGMENT_SHADER, text);
  return program;
}

/// A pipeline of the vertex stage and the fragment stage of that text. Takes the vertex stage.
GLuint ProgramLinker::join(GLuint vertex, const std::string& fragment_text,
                           legacy_gl_statistics& statistics) {
  const GLuint fragment = fragment_stage(fragment_text, statistics);
  if (!fragment) {
    driver_.DeleteProgram(vertex);
    return 0;
  }
  GLuint pipeline = 0;
  driver_.GenProgramPipelines(1, &pipeline);
  driver_.UseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, vertex);
  driver_.UseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, fragment);
  programs_[pipeline] = {vertex, fragment};
  return pipeline;
}

GLuint ProgramLinker::link(const ProgramSource& source, legacy_gl_statistics& statistics) {
  GLuint program = 0;
  if (pipelines_) {
    const GLuint vertex = link_stage(GL_VERTEX_SHADER, source.vertex);
    program = vertex ? join(vertex, source.fragment, statistics) : 0;
  } else {
    const GLuint vertex = compile(GL_VERTEX_SHADER, source.vertex);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, source.fragment);
    if (vertex && fragment) {
      program = link_shaders(vertex, fragment);
      if (program) programs_[program] = {program, program};
      else error_ += "\n" + source.vertex + source.fragment;
    } else {
      driver_.DeleteShader(vertex);
      driver_.DeleteShader(fragment);
    }
  }
  if (program) ++statistics.programs_compiled;
  return program;
}

bool ProgramLinker::offers_format(GLenum format) const {
  GLint count = 0;
  driver_.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &count);
  std::vector<GLint> formats(static_cast<std::size_t>(std::max(count, 0)));
  if (count > 0) driver_.GetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
  return std::find(formats.begin(), formats.end(), static_cast<GLint>(format)) != formats.end();
}

GLuint ProgramLinker::load_binary(const StoredProgram& stored) {
  if (!binaries_ || !offers_format(stored.format)) return 0;
  const GLuint program = driver_.CreateProgram();
  if (pipelines_) driver_.ProgramParameteri(program, GL_PROGRAM_SEPARABLE, GL_TRUE);
  driver_.ProgramBinary(program, stored.format, stored.binary.data(),
                        static_cast<GLsizei>(stored.binary.size()));
  if (is_linked(program)) return program;
  driver_.DeleteProgram(program);
  return 0;
}

GLuint ProgramLinker::load(const StoredProgram& stored, legacy_gl_statistics& statistics) {
  if (!stored.format) return link({stored.vertex, stored.fragment}, statistics);
  const GLuint program = load_binary(stored);
  if (program && pipelines_) return join(program, stored.fragment, statistics);
  if (program) programs_[program] = {program, program};
  return program;
}

/// The binary of a pipeline is its vertex stage's; the fragment stage is small and shared.
StoredProgram ProgramLinker::stored(GLuint program, const ProgramSource& source) const {
  StoredProgram text{0, "", source.vertex, source.fragment};
  const auto at = programs_.find(program);
  if (!binaries_ || at == programs_.end()) return text;
  const GLuint with_binary = at->second.vertex;
  GLint size = 0;
  driver_.GetProgramiv(with_binary, GL_PROGRAM_BINARY_LENGTH, &size);
  if (size <= 0) return text;
  StoredProgram stored;
  stored.binary.resize(static_cast<std::size_t>(size));
  GLsizei written = 0;
  GLenum format = 0;
  driver_.GetProgramBinary(with_binary, size, &written, &format, stored.binary.data());
  if (written <= 0 || format == 0) return text;
  stored.binary.resize(static_cast<std::size_t>(written));
  stored.format = format;
  if (pipelines_) stored.fragment = source.fragment;
  return stored;
}

void ProgramLinker::bind(GLuint program, bool after_ours) const {
  if (!pipelines_) return driver_.UseProgram(program);
  if (!after_ours) driver_.UseProgram(0);  // a program in use would hide the pipeline
  driver_.BindProgramPipeline(program);
}

void ProgramLinker::connect(const ProgramKey& key, GLuint program) {
  const auto at = programs_.find(program);
  if (at == programs_.end()) return;
  if (driver_.ObjectLabel) label(driver_, GL_PROGRAM, at->second.vertex, describe(key));
  connect_stage(key, at->second.vertex);
  if (pipelines_) connect_stage(key, at->second.fragment);
}

void ProgramLinker::connect_stage(const ProgramKey& key, GLuint program) {
  for (GLuint block = 0; block < kUniformBlockCount; ++block) {
    const GLuint index = driver_.GetUniformBlockIndex(program, kUniformBlockNames[block]);
    if (index != GL_INVALID_INDEX) driver_.UniformBlockBinding(program, index, block);
  }
  if (key.pixels != PixelSource::kNone) set_sampler(program, "pixel_texture", kPixelTextureUnit);
  if (key.textures.count) set_samplers(program, key.textures.count);
}

/// Sampler texture<n> reads unit n.
void ProgramLinker::set_samplers(GLuint program, unsigned count) {
  for (unsigned unit = 0; unit < count; ++unit)
    set_sampler(program, ("texture" + std::to_string(unit)).c_str(), unit);
}

void ProgramLinker::set_sampler(GLuint program, const char* name, unsigned unit) {
  const GLint location = driver_.GetUniformLocation(program, name);
  if (location < 0) return;
  GLint in_use = 0;
  driver_.GetIntegerv(GL_CURRENT_PROGRAM, &in_use);
  driver_.UseProgram(program);
  driver_.Uniform1i(location, static_cast<GLint>(unit));
  driver_.UseProgram(static_cast<GLuint>(in_use));
}

}  // namespace legacy_gl
