// Programs that outlive the process: on disk, and as a list of keys to compile ahead.
#include <algorithm>
#include <vector>

#include "driver/program_cache.hpp"
#include "shadergen/generator_version.hpp"
#include "shadergen/key_text.hpp"

namespace legacy_gl {

namespace {

constexpr const char* kListTitle = "legacy_gl program keys, generator ";

std::string hexadecimal(std::uint64_t value) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (int digit = 15; digit >= 0; --digit) text += kDigits[value >> 4 * digit & 15];
  return text;
}

/// The first line of `text`, which it is taken off.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// "<key> <checksum>".
std::optional<ProgramKey> read_key_line(std::string_view line) {
  const std::size_t space = line.find(' ');
  if (space == std::string_view::npos) return {};
  const std::string_view key = line.substr(0, space);
  if (line.substr(space + 1) != hexadecimal(checksum(key))) return {};
  return key_of(key);
}

}  // namespace

std::string ProgramCache::identity_of(const ProgramKey& key) const {
  return environment_ + to_text(key);
}

GLuint ProgramCache::load(const std::string& identity, legacy_gl_statistics& statistics) {
  const std::optional<StoredProgram> stored = files_.load(identity);
  if (!stored) return 0;
  const GLuint program = linker_.load(*stored, statistics);
  if (program) ++statistics.programs_loaded;
  else files_.erase(identity);
  return program;
}

std::string ProgramCache::keys() const {
  std::vector<std::string> lines;
  for (const auto& [key, entry] : programs_) {
    if (entry.built ? entry.program == 0 : entry.work < kWorthCompiling) continue;
    const std::string text = to_text(key);
    lines.push_back(text + " " + hexadecimal(checksum(text)) + "\n");
  }
  std::sort(lines.begin(), lines.end());
  std::string list = std::string(kListTitle) + generator_version() + "\n";
  for (const std::string& line : lines) list += line;
  return list;
}

std::size_t ProgramCache::precompile(std::string_view text, legacy_gl_statistics& statistics) {
  if (take_line(text) != std::string(kListTitle) + generator_version()) return 0;
  std::size_t ready = 0;
  while (!text.empty()) {
    const std::optional<ProgramKey> key = read_key_line(take_line(text));
    if (!key) continue;
    if (find_or_build(*key, statistics)) {
      ++ready;
      continue;
    }
    programs_.erase(*key);  // no state leads to it
    last_ = nullptr;
  }
  return ready;
}

}  // namespace legacy_gl
