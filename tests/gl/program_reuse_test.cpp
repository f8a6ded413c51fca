// Programs of an earlier run: from the cache directory, and compiled ahead from a list of keys.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene_changes.hpp"
#include "support/contexts.hpp"
#include "support/library.hpp"

namespace legacy_gl::test {
namespace {

namespace fs = std::filesystem;

class Directory {
 public:
  Directory() {
    std::string name = (fs::temp_directory_path() / "legacy_gl_cache_XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~Directory() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Directory(const Directory&) = delete;
  Directory& operator=(const Directory&) = delete;

  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(path))
      found.push_back(entry.path());
    return found;
  }

  std::string path;
};

// A few programs: lit, two-sided, textured, unlit; points among them.
std::vector<std::vector<unsigned char>> draw_states(RenderContext& context) {
  const GlFunctions& gl = context.gl;
  std::vector<std::vector<unsigned char>> images;
  const auto draw = [&] {
    draw_scene(gl);
    images.push_back(context.read_rgba8().bytes);
  };
  set_up_scene(gl);
  draw();
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  draw();
  const unsigned char texels[] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 255};
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  gl.Enable(GL_TEXTURE_2D);
  gl.Enable(GL_TEXTURE_GEN_S);
  draw();
  gl.Disable(GL_LIGHTING);
  draw();
  return images;
}

legacy_gl_options with_cache(const Directory& directory) {
  legacy_gl_options options{};
  options.cache_directory = directory.path.c_str();
  return options;
}

template <typename RenderContextType>
void expect_second_run_compiles_nothing() {
  const Directory directory;
  std::vector<std::vector<unsigned char>> first_images;
  std::uint64_t programs = 0;
  {
    RenderContextType first(64, 64, PixelFormat::rgba8, with_cache(directory));
    first_images = draw_states(first);
    programs = statistics_now().programs_compiled;
    EXPECT_GE(programs, 4u);
    EXPECT_EQ(statistics_now().programs_loaded, 0u);
    EXPECT_EQ(directory.files().size(), programs);
  }
  RenderContextType second(64, 64, PixelFormat::rgba8, with_cache(directory));
  EXPECT_EQ(draw_states(second), first_images);
  EXPECT_EQ(statistics_now().programs_generated, 0u);
  EXPECT_EQ(statistics_now().programs_loaded, programs);
}

TEST(ProgramReuse, FromDiskGivesTheSamePicture) {
  expect_second_run_compiles_nothing<CoreContext>();
}

TEST(ProgramReuse, FromDiskGivesTheSamePictureOnOpenGlEs) {
  expect_second_run_compiles_nothing<GlesContext>();
}

TEST(ProgramReuse, DriversDoNotMix) {
  const Directory directory;
  {
    CoreContext core(64, 64, PixelFormat::rgba8, with_cache(directory));
    draw_states(core);
  }
  GlesContext es(64, 64, PixelFormat::rgba8, with_cache(directory));
  draw_states(es);
  EXPECT_EQ(statistics_now().programs_loaded, 0u);
  EXPECT_GE(statistics_now().programs_compiled, 4u);
}

TEST(ProgramReuse, DamagedFilesAreCompiledAnew) {
  const Directory directory;
  std::vector<std::vector<unsigned char>> images;
  {
    CoreContext first(64, 64, PixelFormat::rgba8, with_cache(directory));
    images = draw_states(first);
  }
  std::size_t damaged = 0;
  for (const fs::path& path : directory.files()) {
    switch (damaged++ % 4) {
      case 0: fs::resize_file(path, fs::file_size(path) / 2); break;
      case 1: std::ofstream(path, std::ios::in | std::ios::binary) << "junk"; break;
      case 2: std::ofstream(path, std::ios::trunc); break;
      default: {
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(static_cast<std::streamoff>(fs::file_size(path) - 20));
        file << "another program";
      }
    }
  }
  {
    CoreContext second(64, 64, PixelFormat::rgba8, with_cache(directory));
    EXPECT_EQ(draw_states(second), images);
    EXPECT_EQ(statistics_now().programs_loaded, 0u);
    EXPECT_EQ(statistics_now().programs_compiled, damaged);
  }
  CoreContext third(64, 64, PixelFormat::rgba8, with_cache(directory));
  EXPECT_EQ(draw_states(third), images);
  EXPECT_EQ(statistics_now().programs_loaded, damaged);
}

TEST(ProgramReuse, ADirectoryThatCannotBeIsNoError) {
  legacy_gl_options options{};
  options.cache_directory = "/dev/null/cache";
  CoreContext context(64, 64, PixelFormat::rgba8, options);
  draw_states(context);
  EXPECT_GE(statistics_now().programs_compiled, 4u);
}

// On llvmpipe: lights change the vertex stage alone.
TEST(ProgramReuse, ProgramsShareTheFragmentStage) {
  CoreContext context(64, 64);
  const GlFunctions& gl = context.gl;
  set_up_scene(gl);
  draw_scene(gl);
  gl.Flush();
  legacy_gl_reset_statistics();
  const float position[] = {1, 1, 2, 1};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  draw_scene(gl);
  gl.Flush();
  EXPECT_EQ(statistics_now().programs_compiled, 2u);  // and that of points
  EXPECT_EQ(statistics_now().fragment_stages_shared, 2u);
}

std::string program_keys() {
  std::string keys(legacy_gl_get_program_keys(nullptr, 0), '\0');
  std::vector<char> text(keys.size() + 1);
  EXPECT_EQ(legacy_gl_get_program_keys(text.data(), text.size()), keys.size());
  return {text.data(), keys.size()};
}

template <typename RenderContextType>
void expect_precompiled_run_compiles_nothing(legacy_gl_programs policy) {
  legacy_gl_options options{};
  options.programs = policy;
  std::string keys;
  {
    RenderContextType first(64, 64, PixelFormat::rgba8, options);
    draw_states(first);
    keys = program_keys();
  }
  RenderContextType second(64, 64, PixelFormat::rgba8, options);
  const std::size_t ready = legacy_gl_precompile(keys.data(), keys.size());
  EXPECT_GE(ready, 2u);
  EXPECT_EQ(statistics_now().programs_compiled, ready);
  legacy_gl_reset_statistics();
  draw_states(second);
  EXPECT_EQ(statistics_now().programs_generated, 0u);
  EXPECT_EQ(statistics_now().programs_compiled, 0u);
  EXPECT_EQ(program_keys(), keys);
  EXPECT_EQ(legacy_gl_precompile(keys.data(), keys.size()), ready);
  EXPECT_EQ(statistics_now().programs_compiled, 0u);
}

TEST(ProgramReuse, CompiledAheadNothingIsCompiledLater) {
  expect_precompiled_run_compiles_nothing<CoreContext>(LEGACY_GL_PROGRAMS_SPECIALISED);
  expect_precompiled_run_compiles_nothing<CoreContext>(LEGACY_GL_PROGRAMS_GENERAL_FIRST);
  expect_precompiled_run_compiles_nothing<GlesContext>(LEGACY_GL_PROGRAMS_SPECIALISED);
}

TEST(ProgramReuse, ForeignKeysArePassedOver) {
  CoreContext context(64, 64);
  draw_states(context);
  const std::string keys = program_keys();
  const std::size_t title_end = keys.find('\n') + 1;
  const std::string title = keys.substr(0, title_end);
  CoreContext other(64, 64);
  const auto precompile = [](const std::string& text) {
    return legacy_gl_precompile(text.data(), text.size());
  };
  EXPECT_EQ(precompile(""), 0u);
  EXPECT_EQ(precompile("something else\n" + keys), 0u);
  EXPECT_EQ(precompile(title), 0u);
  EXPECT_EQ(precompile(title + "\n\n \nkey\n0123 4567\n" + std::string(300, '0')), 0u);
  std::string damaged = keys;
  for (std::size_t at = title_end; at < damaged.size(); at += 7)
    if (damaged[at] != '\n') damaged[at] = damaged[at] == '1' ? '2' : '1';
  EXPECT_EQ(precompile(damaged), 0u);
  std::string older = keys;
  older[title_end - 2] = older[title_end - 2] == '0' ? '1' : '0';  // of another generator
  EXPECT_EQ(precompile(older), 0u);
  EXPECT_EQ(legacy_gl_precompile(nullptr, 5), 0u);
  EXPECT_EQ(statistics_now().programs_generated, 0u);
  // A list cut short still has its whole lines.
  EXPECT_GE(precompile(keys.substr(0, keys.size() - 5)), 3u);
}

TEST(ProgramReuse, WithoutAContextIsNothing) {
  EXPECT_EQ(legacy_gl_get_program_keys(nullptr, 0), 0u);
  EXPECT_EQ(legacy_gl_precompile("", 0), 0u);
}

}  // namespace
}  // namespace legacy_gl::test
