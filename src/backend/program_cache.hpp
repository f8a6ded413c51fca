#pragma once
#include <legacy_gl/context.h>

#include <string>
#include <unordered_map>

#include "backend/driver.hpp"
#include "shadergen/program_key.hpp"

namespace legacy_gl {

/// Programs by key. A hit allocates nothing; asking for the last one again compares one key.
class ProgramCache {
 public:
  explicit ProgramCache(const Driver& driver) : driver_(driver) {}
  ~ProgramCache();
  ProgramCache(const ProgramCache&) = delete;
  ProgramCache& operator=(const ProgramCache&) = delete;

  /// The program's name; 0 when the driver refuses it, with the reason in error().
  GLuint find_or_build(const ProgramKey& key, legacy_gl_statistics& statistics);
  const std::string& error() const { return error_; }

 private:
  GLuint build(const ProgramKey& key, legacy_gl_statistics& statistics);
  GLuint compile(GLenum stage, const std::string& text);

  const Driver& driver_;
  std::unordered_map<ProgramKey, GLuint, ProgramKeyHash> programs_;
  ProgramKey last_key_;
  GLuint last_program_ = 0;
  std::string error_;
};

}  // namespace legacy_gl
