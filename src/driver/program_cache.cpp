#include "driver/program_cache.hpp"

#include <utility>

#include "debug/log.hpp"
#include "shadergen/general.hpp"
#include "shadergen/generator_version.hpp"

namespace legacy_gl {

ProgramCache::ProgramCache(const Driver& driver, legacy_gl_programs policy, ProgramFiles files)
    : driver_(driver),
      policy_(policy),
      files_(std::move(files)),
      linker_(driver, files_.enabled()) {
  if (!files_.enabled()) return;
  environment_ = std::string(generator_version()) + (driver_.is_es() ? " es\n" : " core\n");
  for (const int name : {GL_VENDOR, GL_RENDERER, GL_VERSION}) {
    const auto* const text =
        reinterpret_cast<const char*>(driver_.GetString(static_cast<GLenum>(name)));
    environment_ += std::string(text ? text : "") + "\n";
  }
}

ProgramCache::~ProgramCache() = default;

ProgramCache::Entry& ProgramCache::find(const ProgramKey& key) {
  if (last_ && key == last_key_) return *last_;
  Entry& entry = programs_[key];  // stays where it is while others are added
  last_key_ = key;
  last_ = &entry;
  return entry;
}

void ProgramCache::build_entry(const ProgramKey& key, Entry& entry,
                               legacy_gl_statistics& statistics) {
  entry.program = build(key, statistics);
  entry.built = entry.program || ++entry.refusals == kMostRefusals;
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
  if (entry.built && (entry.program || !entry.general)) return {entry.program, false};
  if (!entry.general && policy_ != LEGACY_GL_PROGRAMS_SPECIALISED) {
    const ProgramKey general = generalise(key);
    // The first state waits less for its own program than for a general one, which it may be the
    // only one to use.
    const bool first = !has_lit_program_ && policy_ != LEGACY_GL_PROGRAMS_GENERAL;
    if (general != key && !first) {
      const GLuint program = find_or_build(general, statistics);
      last_ = nullptr;
      entry.general = program;
    }
  }
  if (!entry.built && (!entry.general || worth_it(key, vertices, entry))) {
    build_entry(key, entry, statistics);
    if (entry.program || !entry.general) return {entry.program, false};
  }
  ++statistics.general_draws;
  return {entry.general, true};
}

GLuint ProgramCache::build(const ProgramKey& key, legacy_gl_statistics& statistics) {
  has_lit_program_ = has_lit_program_ || key.lit;
  const std::string identity = files_.enabled() ? identity_of(key) : std::string();
  GLuint program = files_.enabled() ? load(identity, statistics) : 0;
  if (!program) {
    const ProgramSource source = generate(key, driver_.dialect);
    ++statistics.programs_generated;
    if (debug::wants(debug::kGlsl)) debug::log_text(source.vertex + source.fragment);
    program = linker_.link(source, statistics);
    if (program && files_.enabled()) files_.store(identity, linker_.stored(program, source));
  }
  if (program) linker_.connect(key, program);
  return program;
}

}  // namespace legacy_gl
