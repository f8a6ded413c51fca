#include "backend/program_cache.hpp"

#include <utility>

#include "shadergen/general.hpp"
#include "shadergen/generator_version.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

ProgramCache::ProgramCache(const Driver& driver, legacy_gl_programs policy, ProgramFiles files)
    : driver_(driver), policy_(policy), files_(std::move(files)) {
  if (!files_.enabled()) return;
  environment_ = std::string(generator_version()) + (driver_.is_es() ? " es\n" : " core\n");
  for (const int name : {GL_VENDOR, GL_RENDERER, GL_VERSION}) {
    const auto* const text =
        reinterpret_cast<const char*>(driver_.GetString(static_cast<GLenum>(name)));
    environment_ += std::string(text ? text : "") + "\n";
  }
  GLint formats = 0;
  if (driver_.GetProgramBinary && driver_.ProgramBinary && driver_.ProgramParameteri)
    driver_.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
  binaries_ = formats > 0;
}

ProgramCache::~ProgramCache() {
  for (const auto& [key, entry] : programs_) driver_.DeleteProgram(entry.program);
}

ProgramCache::Entry& ProgramCache::find(const ProgramKey& key) {
  if (last_ && key == last_key_) return *last_;
  last_key_ = key;
  last_ = &programs_[key];  // stays where it is while others are added
  return *last_;
}

void ProgramCache::build_entry(const ProgramKey& key, Entry& entry,
                               legacy_gl_statistics& statistics) {
  entry.built = true;
  entry.program = build(key, statistics);
}

GLuint ProgramCache::find_or_build(const ProgramKey& key, legacy_gl_statistics& statistics) {
  Entry& entry = find(key);
  if (!entry.built) build_entry(key, entry, statistics);
  return entry.program;
}

bool ProgramCache::worth_it(const ProgramKey& key, std::uint64_t vertices, Entry& entry) {
  if (policy_ == LEGACY_GL_PROGRAMS_GENERAL) return false;
  const bool again = entry.work > 0;  // what is drawn once is not worth a program of its own
  const std::uint64_t work = vertices * (key.light_count() + 1);
  entry.work += work;
  work_since_last_build_ += work;
  if (!again || entry.work < kWorthCompiling || work_since_last_build_ < kWorthCompiling)
    return false;
  work_since_last_build_ = 0;
  return true;
}

ProgramCache::Choice ProgramCache::choose(const ProgramKey& key, std::uint64_t vertices,
                                          legacy_gl_statistics& statistics) {
  Entry& entry = find(key);
  if (entry.built) return {entry.program, false};
  if (!entry.general && policy_ != LEGACY_GL_PROGRAMS_SPECIALISED) {
    if (const ProgramKey general = generalise(key); general != key) {
      const GLuint program = find_or_build(general, statistics);
      last_ = nullptr;
      entry.general = program;
    }
  }
  if (!entry.general || worth_it(key, vertices, entry)) {
    build_entry(key, entry, statistics);
    return {entry.program, false};
  }
  ++statistics.general_draws;
  return {entry.general, true};
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

/// Sampler texture<n> reads unit n.
void ProgramCache::set_samplers(GLuint program, unsigned count) {
  GLint in_use = 0;
  driver_.GetIntegerv(GL_CURRENT_PROGRAM, &in_use);
  driver_.UseProgram(program);
  for (unsigned unit = 0; unit < count; ++unit) {
    const std::string name = "texture" + std::to_string(unit);
    const GLint location = driver_.GetUniformLocation(program, name.c_str());
    if (location >= 0) driver_.Uniform1i(location, static_cast<GLint>(unit));
  }
  driver_.UseProgram(static_cast<GLuint>(in_use));
}

bool ProgramCache::is_linked(GLuint program) const {
  GLint linked = 0;
  driver_.GetProgramiv(program, GL_LINK_STATUS, &linked);
  return linked != 0;
}

GLuint ProgramCache::compile(const ProgramSource& source, legacy_gl_statistics& statistics) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, source.vertex);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, source.fragment);
  if (!vertex || !fragment) {
    driver_.DeleteShader(vertex);  // 0 is ignored
    driver_.DeleteShader(fragment);
    return 0;
  }
  const GLuint program = driver_.CreateProgram();
  driver_.AttachShader(program, vertex);
  driver_.AttachShader(program, fragment);
  if (binaries_) driver_.ProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  driver_.LinkProgram(program);
  driver_.DeleteShader(vertex);
  driver_.DeleteShader(fragment);
  if (!is_linked(program)) {
    GLchar log[2048] = {};
    driver_.GetProgramInfoLog(program, sizeof log, nullptr, log);
    error_ = std::string(log) + "\n" + source.vertex + source.fragment;
    driver_.DeleteProgram(program);
    return 0;
  }
  ++statistics.programs_compiled;
  return program;
}

GLuint ProgramCache::build(const ProgramKey& key, legacy_gl_statistics& statistics) {
  const std::string identity = files_.enabled() ? identity_of(key) : std::string();
  GLuint program = files_.enabled() ? load(identity, statistics) : 0;
  if (!program) {
    const ProgramSource source = generate(key, driver_.dialect);
    ++statistics.programs_generated;
    program = compile(source, statistics);
    if (program && files_.enabled()) store(identity, program, source);
  }
  if (program) connect(key, program);
  return program;
}

/// What a program begins without, whether it is compiled or loaded.
void ProgramCache::connect(const ProgramKey& key, GLuint program) {
  for (GLuint block = 0; block < kUniformBlockCount; ++block) {
    const GLuint index = driver_.GetUniformBlockIndex(program, kUniformBlockNames[block]);
    if (index != GL_INVALID_INDEX) driver_.UniformBlockBinding(program, index, block);
  }
  if (key.pixels != PixelSource::kNone) set_sampler(program, "pixel_texture", kPixelTextureUnit);
  if (key.textures.count) set_samplers(program, key.textures.count);
}

void ProgramCache::set_sampler(GLuint program, const char* name, unsigned unit) {
  GLint in_use = 0;
  driver_.GetIntegerv(GL_CURRENT_PROGRAM, &in_use);
  driver_.UseProgram(program);
  driver_.Uniform1i(driver_.GetUniformLocation(program, name), static_cast<GLint>(unit));
  driver_.UseProgram(static_cast<GLuint>(in_use));
}

}  // namespace legacy_gl
