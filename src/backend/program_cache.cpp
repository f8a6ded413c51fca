#include "backend/program_cache.hpp"

#include "shadergen/generate.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

ProgramCache::~ProgramCache() {
  for (const auto& [key, program] : programs_) driver_.DeleteProgram(program);
}

GLuint ProgramCache::find_or_build(const ProgramKey& key, legacy_gl_statistics& statistics) {
  if (last_program_ && key == last_key_) return last_program_;
  auto at = programs_.find(key);
  if (at == programs_.end()) at = programs_.emplace(key, build(key, statistics)).first;
  last_key_ = key;
  last_program_ = at->second;
  return at->second;
}

GLuint ProgramCache::compile(GLenum stage, const std::string& text) {
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

GLuint ProgramCache::build(const ProgramKey& key, legacy_gl_statistics& statistics) {
  const ProgramSource source = generate(key, driver_.dialect);
  ++statistics.programs_generated;
  const GLuint vertex = compile(GL_VERTEX_SHADER, source.vertex);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, source.fragment);
  if (!vertex || !fragment) return 0;
  const GLuint program = driver_.CreateProgram();
  driver_.AttachShader(program, vertex);
  driver_.AttachShader(program, fragment);
  driver_.LinkProgram(program);
  driver_.DeleteShader(vertex);
  driver_.DeleteShader(fragment);
  GLint linked = 0;
  driver_.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked) {
    GLchar log[2048] = {};
    driver_.GetProgramInfoLog(program, sizeof log, nullptr, log);
    error_ = std::string(log) + "\n" + source.vertex + source.fragment;
    driver_.DeleteProgram(program);
    return 0;
  }
  ++statistics.programs_compiled;
  for (GLuint block = 0; block < kUniformBlockCount; ++block) {
    const GLuint index = driver_.GetUniformBlockIndex(program, kUniformBlockNames[block]);
    if (index != GL_INVALID_INDEX) driver_.UniformBlockBinding(program, index, block);
  }
  return program;
}

}  // namespace legacy_gl
