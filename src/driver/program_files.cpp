#include "driver/program_files.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

namespace legacy_gl {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSuffix = ".program";
constexpr const char* kScratchSuffix = ".new";
constexpr std::string_view kMagic = "lglprog1";
/// No program is as large: what is larger is not read.
constexpr std::uint64_t kLargestFile = std::uint64_t{16} << 20;

void put(std::string& to, std::uint64_t value) {
  for (int byte = 0; byte < 8; ++byte) to += static_cast<char>(value >> 8 * byte & 255);
}

void put(std::string& to, std::string_view bytes) {
  put(to, bytes.size());
  to += bytes;
}

/// Takes values off the front; after the first that is not there all are empty.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t number() {
    const std::string_view bytes = take(8);
    std::uint64_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;)
      value = value << 8 | static_cast<unsigned char>(bytes[i]);
    return value;
  }
  std::string_view text() { return take(number()); }
  /// All was there, and nothing more.
  bool complete() const { return good_ && rest_.empty(); }

 private:
  std::string_view take(std::uint64_t size) {
    good_ = good_ && size <= rest_.size();
    if (!good_) return {};
    const std::string_view bytes = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return bytes;
  }

  std::string_view rest_;
  bool good_ = true;
};

std::string contents(std::string_view identity, const StoredProgram& program) {
  std::string body;
  put(body, identity);
  put(body, program.format);
  put(body, program.binary);
  put(body, program.vertex);
  put(body, program.fragment);
  std::string file(kMagic);
  put(file, checksum(body));
  return file + body;
}

std::optional<StoredProgram> parse(std::string_view file, std::string_view identity) {
  if (file.substr(0, kMagic.size()) != kMagic) return {};
  file.remove_prefix(kMagic.size());
  if (file.size() < 8) return {};
  const std::string_view body = file.substr(8);
  if (Reader(file.substr(0, 8)).number() != checksum(body)) return {};
  Reader reader(body);
  if (reader.text() != identity) return {};
  StoredProgram program;
  const std::uint64_t format = reader.number();
  program.format = static_cast<std::uint32_t>(format);
  program.binary = reader.text();
  program.vertex = reader.text();
  program.fragment = reader.text();
  if (!reader.complete() || program.format != format) return {};
  return program;
}

std::optional<std::string> read_file(const fs::path& path) {
  std::error_code error;
  const std::uint64_t size = fs::file_size(path, error);
  if (error || size > kLargestFile) return {};
  std::string bytes(size, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) return {};
  return bytes;
}

bool write_file(const fs::path& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return !file.fail();
}

/// A name that no other writer has, in this process or another.
std::string scratch_name(const std::string& name) {
  static std::atomic<unsigned> writes = 0;
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  const auto place = reinterpret_cast<std::uintptr_t>(&name);
  return name + "." + std::to_string(now) + "." + std::to_string(place) + "." +
         std::to_string(writes++) + kScratchSuffix;
}

/// What a writer that was ended did not rename.
bool is_left_behind(const fs::directory_entry& entry) {
  std::error_code unknown;
  if (entry.path().extension() != kScratchSuffix) return false;
  if (entry.path().stem().string().find(kSuffix) == std::string::npos) return false;
  const fs::file_time_type written = entry.last_write_time(unknown);
  return !unknown && written + std::chrono::hours(1) < fs::file_time_type::clock::now();
}

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ull;
  return hash;
}

ProgramFiles::ProgramFiles(std::string directory, std::uint64_t limit)
    : directory_(std::move(directory)), limit_(limit) {}

fs::path ProgramFiles::path_of(std::string_view identity) const {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string name;
  for (std::uint64_t hash = checksum(identity); name.size() < 16; hash >>= 4)
    name += kDigits[hash & 15];
  return directory_ / (name + kSuffix);
}

std::optional<StoredProgram> ProgramFiles::load(std::string_view identity) const {
  if (!enabled()) return {};
  const fs::path path = path_of(identity);
  const std::optional<std::string> file = read_file(path);
  if (!file) return {};
  std::optional<StoredProgram> program = parse(*file, identity);
  std::error_code ignored;  // what is used stays the longest
  if (program) fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  return program;
}

void ProgramFiles::store(std::string_view identity, const StoredProgram& program) {
  if (!enabled()) return;
  std::error_code error;
  fs::create_directories(directory_, error);
  const std::string bytes = contents(identity, program);
  if (bytes.size() > std::min(limit_, kLargestFile)) return;
  make_room(bytes.size());
  const fs::path path = path_of(identity);
  const fs::path scratch = directory_ / scratch_name(path.filename().string());
  bool written = write_file(scratch, bytes);
  if (written) {
    fs::rename(scratch, path, error);
    written = !error;
  }
  if (written) *size_ += bytes.size();
  else fs::remove(scratch, error);
}

void ProgramFiles::erase(std::string_view identity) {
  std::error_code ignored;
  if (enabled()) fs::remove(path_of(identity), ignored);
}

void ProgramFiles::make_room(std::uint64_t bytes) {
  if (size_ && *size_ + bytes <= limit_) return;
  struct File {
    fs::path path;
    fs::file_time_type used;
    std::uint64_t size;
  };
  std::vector<File> files;
  std::uint64_t total = 0;
  std::error_code error;
  for (fs::directory_iterator at(directory_, error), end; !error && at != end;
       at.increment(error)) {
    const fs::path& path = at->path();
    std::error_code unknown;
    if (is_left_behind(*at)) fs::remove(path, unknown);
    if (path.extension() != kSuffix || !at->is_regular_file(unknown)) continue;
    const std::uint64_t size = fs::file_size(path, unknown);
    const fs::file_time_type used = fs::last_write_time(path, unknown);
    if (unknown) continue;
    files.push_back({path, used, size});
    total += size;
  }
  if (total + bytes > limit_) {
    // A quarter more than is needed: the directory is not read again for the next file.
    const std::uint64_t wanted = limit_ - std::min(limit_, bytes + limit_ / 4);
    std::sort(files.begin(), files.end(),
              [](const File& a, const File& b) { return a.used < b.used; });
    for (const File& file : files) {
      if (total <= wanted) break;
      if (fs::remove(file.path, error)) total -= file.size;
    }
  }
  size_ = total;
}

}  // namespace legacy_gl
