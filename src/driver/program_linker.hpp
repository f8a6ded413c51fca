#pragma once
#include <legacy_gl/context.h>

#include <string>
#include <unordered_map>

#include "driver/driver.hpp"
#include "driver/program_files.hpp"
#include "shadergen/generate.hpp"

namespace legacy_gl {

/// Makes the driver's programs of texts. Where the driver is llvmpipe a program is a pipeline of
/// two stages, and programs whose fragment stages have one text share that stage: it is compiled
/// once, and a switch between them leaves the rasteriser's state as it is.
class ProgramLinker {
 public:
  ProgramLinker(const Driver& driver, bool keeps_binaries);
  ~ProgramLinker();
  ProgramLinker(const ProgramLinker&) = delete;
  ProgramLinker& operator=(const ProgramLinker&) = delete;

  /// A program's name; 0 when the driver refuses it, with the reason in error().
  GLuint link(const ProgramSource& source, legacy_gl_statistics& statistics);
  /// The same of what was stored.
  GLuint load(const StoredProgram& stored, legacy_gl_statistics& statistics);
  /// What load takes.
  StoredProgram stored(GLuint program, const ProgramSource& source) const;
  /// What a program begins without, whether it is linked or loaded: blocks and samplers.
  void connect(const ProgramKey& key, GLuint program);
  /// `after_ours`: the program before it was bound here too.
  void bind(GLuint program, bool after_ours) const;
  const std::string& error() const { return error_; }

 private:
  /// Two programs of one stage each, or one of both.
  struct Stages {
    GLuint vertex = 0, fragment = 0;
  };
  GLuint compile(GLenum stage, const std::string& text);
  GLuint link_shaders(GLuint vertex, GLuint fragment);
  GLuint link_stage(GLenum stage, const std::string& text);
  GLuint load_binary(const StoredProgram& stored);
  GLuint fragment_stage(const std::string& text, legacy_gl_statistics& statistics);
  GLuint join(GLuint vertex, const std::string& fragment_text, legacy_gl_statistics& statistics);
  bool offers_format(GLenum format) const;
  bool is_linked(GLuint program) const;
  void connect_stage(const ProgramKey& key, GLuint program);
  void set_samplers(GLuint program, unsigned count);
  void set_sampler(GLuint program, const char* name, unsigned unit);

  const Driver& driver_;
  bool pipelines_ = false;
  bool binaries_ = false;  ///< the driver gives and takes them, and they are wanted
  std::unordered_map<GLuint, Stages> programs_;
  std::unordered_map<std::string, GLuint> fragments_;  ///< of pipelines, by their text
  std::string error_;
};

}  // namespace legacy_gl
