#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace legacy_gl {

/// What the driver made of a program, or where it gives none the text that it was made from.
struct StoredProgram {
  std::uint32_t format = 0;  ///< the driver's format of `binary`; 0: the texts of the two stages
  std::string binary;
  std::string vertex, fragment;
};

/// FNV-1a, 64 bits.
std::uint64_t checksum(std::string_view bytes);

/// Programs in a directory, each in a file of its own. Nothing that is read is trusted: a file that
/// is cut short, changed or of something else counts as missing. Files are written under another
/// name and then renamed, so that no reader meets half of one. Errors of the file system cost the
/// cache and nothing else.
class ProgramFiles {
 public:
  /// "": no files at all. The oldest files go when all together are larger than `limit` bytes.
  ProgramFiles(std::string directory, std::uint64_t limit);

  bool enabled() const { return !directory_.empty(); }
  /// The program that was stored under exactly this identity.
  std::optional<StoredProgram> load(std::string_view identity) const;
  void store(std::string_view identity, const StoredProgram& program);
  /// Takes out what the driver refuses.
  void erase(std::string_view identity);

 private:
  std::filesystem::path path_of(std::string_view identity) const;
  void make_room(std::uint64_t bytes);

  std::filesystem::path directory_;
  std::uint64_t limit_;
  std::optional<std::uint64_t> size_;  ///< of all files, once it is known
};

}  // namespace legacy_gl
