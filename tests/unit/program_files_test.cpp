// Files of compiled programs: what is not exactly what was stored is not there.
#include "driver/program_files.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <vector>

namespace legacy_gl::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPlenty = 1 << 20;

class ProgramFilesTest : public testing::Test {
 protected:
  ProgramFilesTest() {
    std::string name = (fs::temp_directory_path() / "legacy_gl_files_XXXXXX").string();
    directory = mkdtemp(name.data());
  }
  ~ProgramFilesTest() override {
    std::error_code ignored;
    fs::permissions(directory, fs::perms::owner_all, ignored);
    fs::remove_all(directory, ignored);
  }

  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory))
      found.push_back(entry.path());
    return found;
  }
  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
  }

  fs::path directory;
  const StoredProgram binary{0x875f, std::string("\0\1binary", 8), "", ""};
};

TEST_F(ProgramFilesTest, GiveBackWhatTheyWereGiven) {
  ProgramFiles files(directory.string(), kPlenty);
  EXPECT_FALSE(files.load("a"));
  files.store("a", binary);
  files.store("b", {0, "", "vertex text", "fragment text"});
  const std::optional<StoredProgram> a = files.load("a");
  ASSERT_TRUE(a);
  EXPECT_EQ(a->format, binary.format);
  EXPECT_EQ(a->binary, binary.binary);
  const std::optional<StoredProgram> b = ProgramFiles(directory.string(), kPlenty).load("b");
  ASSERT_TRUE(b);
  EXPECT_EQ(b->format, 0u);
  EXPECT_EQ(b->vertex, "vertex text");
  EXPECT_EQ(b->fragment, "fragment text");
  files.erase("a");
  EXPECT_FALSE(files.load("a"));
}

TEST_F(ProgramFilesTest, WithoutADirectoryAreNone) {
  ProgramFiles none("", kPlenty);
  none.store("a", binary);
  EXPECT_FALSE(none.load("a"));
  EXPECT_FALSE(none.enabled());
}

TEST_F(ProgramFilesTest, MakeTheirDirectoryAndLeaveNoOtherFile) {
  ProgramFiles files((directory / "deep" / "er").string(), kPlenty);
  files.store("a", binary);
  EXPECT_TRUE(files.load("a"));
  std::size_t count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory / "deep" / "er")) {
    EXPECT_EQ(entry.path().extension(), ".program");
    ++count;
  }
  EXPECT_EQ(count, 1u);
}

TEST_F(ProgramFilesTest, OfAnotherIdentityAreNotRead) {
  ProgramFiles files(directory.string(), kPlenty);
  files.store("this driver, this key", binary);
  ASSERT_EQ(this->files().size(), 1u);
  const std::string bytes = read(this->files().front());
  files.store("another driver, this key", binary);
  // The first program's bytes under the other's name, as if both names' hashes were one.
  for (const fs::path& path : this->files()) write(path, bytes);
  EXPECT_TRUE(files.load("this driver, this key"));
  EXPECT_FALSE(files.load("another driver, this key"));
}

TEST_F(ProgramFilesTest, CutShortAnywhereAreNotRead) {
  ProgramFiles files(directory.string(), kPlenty);
  files.store("a", binary);
  const fs::path path = this->files().front();
  const std::string bytes = read(path);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    write(path, bytes.substr(0, size));
    EXPECT_FALSE(files.load("a")) << size;
  }
  write(path, bytes + '\0');
  EXPECT_FALSE(files.load("a"));
  write(path, bytes);
  EXPECT_TRUE(files.load("a"));
}

TEST_F(ProgramFilesTest, WithAnyBitChangedAreNotRead) {
  ProgramFiles files(directory.string(), kPlenty);
  files.store("a", binary);
  const fs::path path = this->files().front();
  const std::string bytes = read(path);
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ 1 << bit);
      write(path, damaged);
      EXPECT_FALSE(files.load("a")) << at << " " << bit;
    }
}

// The checksum is right, the rest is not: lengths that point past the end, wrong texts.
TEST_F(ProgramFilesTest, ForgedWithARightChecksumAreParsedSafely) {
  ProgramFiles files(directory.string(), kPlenty);
  files.store("a", binary);
  const fs::path path = this->files().front();
  const std::string bytes = read(path);
  constexpr std::size_t kHead = 16;  // magic and checksum
  std::minstd_rand random(3);
  unsigned read_back = 0;
  for (int round = 0; round < 600; ++round) {
    std::string body = bytes.substr(kHead);
    for (auto changes = 1 + random() % 4; changes > 0; --changes)
      body[random() % body.size()] = static_cast<char>(random());
    if (random() % 3 == 0) body.resize(random() % (body.size() + 1));
    std::string head = bytes.substr(0, 8);
    for (unsigned byte = 0; byte < 8; ++byte)
      head += static_cast<char>(checksum(body) >> 8 * byte & 255);
    write(path, head + body);
    if (files.load("a")) ++read_back;
  }
  EXPECT_GT(read_back, 0u);  // only the binary's bytes or its format were changed
  EXPECT_LT(read_back, 600u);
}

TEST_F(ProgramFilesTest, OfSomethingElseAreNotRead) {
  ProgramFiles files(directory.string(), kPlenty);
  files.store("a", binary);
  const fs::path path = this->files().front();
  for (const std::string& bytes :
       {std::string(), std::string("#!/bin/sh\n"), std::string(5000, 'x'), std::string("lglprog1"),
        std::string("lglprog1\0\0\0\0\0\0\0\0", 16)}) {
    write(path, bytes);
    EXPECT_FALSE(files.load("a"));
  }
  fs::remove(path);
  fs::create_directory(path);  // a directory of that name
  EXPECT_FALSE(files.load("a"));
  files.store("a", binary);
  EXPECT_FALSE(files.load("a"));
}

TEST_F(ProgramFilesTest, ThatCannotBeWrittenAreMissing) {
  const fs::path file = directory / "file";
  write(file, "no directory");
  ProgramFiles files((file / "below").string(), kPlenty);
  files.store("a", binary);
  EXPECT_FALSE(files.load("a"));
}

TEST_F(ProgramFilesTest, StayWithinTheirBound) {
  constexpr std::uint64_t kLimit = 20000;
  ProgramFiles files(directory.string(), kLimit);
  const StoredProgram large{1, std::string(1500, 'b'), "", ""};
  for (int i = 0; i < 60; ++i) {
    files.store("program " + std::to_string(i), large);
    std::uint64_t total = 0;
    for (const fs::path& path : this->files()) total += fs::file_size(path);
    EXPECT_LE(total, kLimit);
  }
  EXPECT_FALSE(files.load("program 0"));
  EXPECT_TRUE(files.load("program 59"));
  EXPECT_GE(this->files().size(), 6u);
  files.store("too large", {1, std::string(kLimit + 1, 'b'), "", ""});
  EXPECT_FALSE(files.load("too large"));
  EXPECT_TRUE(files.load("program 59"));
}

TEST_F(ProgramFilesTest, OfOthersAreLeftAlone) {
  write(directory / "notes.txt", std::string(5000, 'x'));
  ProgramFiles files(directory.string(), 3000);
  for (int i = 0; i < 10; ++i)
    files.store("program " + std::to_string(i), {1, std::string(900, 'b'), "", ""});
  EXPECT_TRUE(fs::exists(directory / "notes.txt"));
}

TEST_F(ProgramFilesTest, LeftBehindByAnEndedWriterGo) {
  const fs::path stale = directory / "0123456789abcdef.program.1.2.3.new";
  const fs::path fresh = directory / "0123456789abcdef.program.4.5.6.new";
  write(stale, "half a prog");
  write(fresh, "half a prog");
  fs::last_write_time(stale, fs::file_time_type::clock::now() - std::chrono::hours(5));
  ProgramFiles files(directory.string(), kPlenty);
  files.store("a", binary);
  EXPECT_FALSE(fs::exists(stale));
  EXPECT_TRUE(fs::exists(fresh));
}

}  // namespace
}  // namespace legacy_gl::test
