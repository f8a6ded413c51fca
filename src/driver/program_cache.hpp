#pragma once
#include <legacy_gl/context.h>

#include <string>
#include <string_view>
#include <unordered_map>

#include "driver/driver.hpp"
#include "driver/program_files.hpp"
#include "driver/program_linker.hpp"
#include "shadergen/program_key.hpp"

namespace legacy_gl {

/// Programs by key. A hit allocates nothing; asking for the last one again compares one key.
class ProgramCache {
 public:
  explicit ProgramCache(const Driver& driver,
                        legacy_gl_programs policy = LEGACY_GL_PROGRAMS_SPECIALISED,
                        ProgramFiles files = {"", 0});
  ~ProgramCache();
  ProgramCache(const ProgramCache&) = delete;
  ProgramCache& operator=(const ProgramCache&) = delete;

  struct Choice {
    GLuint program = 0;  ///< 0: the driver refuses it, with the reason in error()
    bool general = false;
  };
  /// The program for a draw of so many vertices: the specialised one where it exists, is asked for,
  /// or has become worth it; until then a general one.
  Choice choose(const ProgramKey& key, std::uint64_t vertices, legacy_gl_statistics& statistics);

  /// A key's first draws need not wait for its program: something stands in.
  bool has_stand_ins() const {
    return policy_ == LEGACY_GL_PROGRAMS_DEFAULT || policy_ == LEGACY_GL_PROGRAMS_GENERAL_FIRST;
  }

  /// The specialised program's name; 0 when the driver refuses it, with the reason in error().
  GLuint find_or_build(const ProgramKey& key, legacy_gl_statistics& statistics);
  const std::string& error() const { return linker_.error(); }
  /// Makes it the driver's current program.
  void bind(GLuint program, bool after_ours) const { linker_.bind(program, after_ours); }

  /// The keys of the programs that are built or would be next, in text, for precompile.
  std::string keys() const;
  /// Builds the programs of such a text that are not there yet. Returns how many of its keys are
  /// ready; what another version of the generator wrote, or nobody, is passed over.
  std::size_t precompile(std::string_view text, legacy_gl_statistics& statistics);

 private:
  /// Vertices times lights that a general program draws before it has cost about as much more time
  /// as a compilation takes: with this for each program and for all together, what is spent is at
  /// most twice what the best choice in hindsight would spend.
  static constexpr std::uint64_t kWorthCompiling = 1'000'000;

  /// A driver that is out of memory refuses a program that it takes later; one that it never takes
  /// must not be compiled for every draw.
  static constexpr unsigned kMostRefusals = 3;

  struct Entry {
    bool built = false;  ///< or refused for good
    unsigned refusals = 0;
    GLuint program = 0;
    GLuint general = 0;      ///< of the key's general program, which other entries share
    std::uint64_t work = 0;  ///< what the general program drew in its place
  };
  Entry& find(const ProgramKey& key);
  void build_entry(const ProgramKey& key, Entry& entry, legacy_gl_statistics& statistics);
  bool worth_it(const ProgramKey& key, std::uint64_t vertices, Entry& entry);
  GLuint build(const ProgramKey& key, legacy_gl_statistics& statistics);
  std::string identity_of(const ProgramKey& key) const;
  GLuint load(const std::string& identity, legacy_gl_statistics& statistics);

  const Driver& driver_;
  legacy_gl_programs policy_;
  std::unordered_map<ProgramKey, Entry, ProgramKeyHash> programs_;
  ProgramKey last_key_;
  Entry* last_ = nullptr;
  bool has_lit_program_ = false;
  std::uint64_t work_since_last_build_ = 0;
  ProgramFiles files_;
  std::string environment_;  ///< generator, dialect and driver: what stored programs depend on
  ProgramLinker linker_;
};

}  // namespace legacy_gl
