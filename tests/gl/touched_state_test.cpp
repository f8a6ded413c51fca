// docs/coexistence.md lists the driver's state that the library changes. What a loader sees while
// every area of the library is drawn has to be there; which of the driver's functions set state is
// asked of the library's own table of them.
#ifndef __clang__
// GCC 12 says so of <regex> itself, where sanitizers are on (its bug 105562).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "driver/driver.hpp"
#include "every_area.hpp"
#include "scene_changes.hpp"
#include "support/contexts.hpp"
#include "support/driver_shim.hpp"

namespace legacy_gl::test {
namespace {

using Touched = std::map<std::string, std::set<std::string>>;  // function to its first arguments

std::string read_file(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_FALSE(text.str().empty()) << path;
  return text.str();
}

// Functions that change objects (of the library's own, by their names or by a binding that is
// listed), draw, ask or wait. All others set state.
bool changes_objects_alone(const std::string& function) {
  static const std::regex pattern(
      "gl(Get|Is|Gen|Delete|Create|Attach|Compile|Link|Draw(Arrays|Elements)|MultiDraw|BufferData|"
      "BufferSubData|MapBuffer|UnmapBuffer|Tex(Image|SubImage|Parameter)|CompressedTex|CopyTex|"
      "ShaderSource|UniformBlockBinding|Uniform1i|FramebufferTexture|Clear$|ReadPixels|Flush|"
      "Finish|"
      "FenceSync|ClientWaitSync|EndQuery|Program(Binary|Parameteri)|UseProgramStages).*");
  return std::regex_match(function, pattern);
}

// What of them has a state for each value of its first argument.
bool has_selector(const std::string& function) {
  static const std::set<std::string> selecting = {
      "glBindBuffer", "glBindBufferRange", "glBindTexture", "glBindFramebuffer",
      "glEnable",     "glDisable",         "glPixelStorei", "glBeginQuery"};
  return selecting.contains(function);
}

std::string enum_name(std::uint64_t value) {
  // The names that the documentation uses, by the header's values.
  static const std::map<std::uint64_t, std::string> names = [] {
    std::map<std::uint64_t, std::string> found;
    const std::string header = read_file(LEGACY_GL_TEST_GLCOREARB);
    const std::string page = read_file(LEGACY_GL_TEST_SOURCE_DIR "/docs/coexistence.md");
    static const std::regex define("#define (GL_[A-Z0-9_]+)\\s+(0x[0-9A-Fa-f]+)");
    for (std::sregex_iterator at(header.begin(), header.end(), define), end; at != end; ++at)
      if (page.find('`' + at->str(1) + '`') != std::string::npos)
        found[std::stoull(at->str(2), nullptr, 16)] = at->str(1);
    return found;
  }();
  const auto at = names.find(value);
  if (at != names.end()) return at->second;
  std::ostringstream text;
  text << "0x" << std::hex << value;
  return text.str();
}

class Recording : public DriverObserver {
 public:
  bool before(const DriverCall& call) override {
    std::string function = call.name;
    if (changes_objects_alone(function)) return true;
    if (!has_selector(function)) {
      touched[function];
      return true;
    }
    if (function == "glDisable") function = "glEnable";
    touched[function].insert(enum_name(call.argument(0)));
    return true;
  }
  Touched touched;
};

// Rows of the page's table: | `glFunction`, ... | `GL_SELECTOR`, ... |
Touched documented() {
  Touched result;
  std::istringstream page(read_file(LEGACY_GL_TEST_SOURCE_DIR "/docs/coexistence.md"));
  static const std::regex row("\\| (`gl[^|]*) \\|(.*)"), function("`(gl[A-Za-z0-9]+)`"),
      name("`(GL_[A-Z0-9_]+)`");
  for (std::string line; std::getline(page, line);) {
    std::smatch found;
    if (!std::regex_match(line, found, row)) continue;
    const std::string functions = found.str(1), rest = found.str(2);
    std::set<std::string> selectors;
    for (std::sregex_iterator at(rest.begin(), rest.end(), name), end; at != end; ++at)
      selectors.insert(at->str(1));
    for (std::sregex_iterator at(functions.begin(), functions.end(), function), end; at != end;
         ++at)
      result[at->str(1)].insert(selectors.begin(), selectors.end());
  }
  return result;
}

std::string text_of(const Touched& touched) {
  std::string text;
  for (const auto& [function, selectors] : touched) {
    text += function + ':';
    for (const std::string& selector : selectors) text += ' ' + selector;
    text += '\n';
  }
  return text;
}

// What `found` has and `listed` has not.
Touched missing_in(const Touched& listed, const Touched& found) {
  Touched missing;
  for (const auto& [function, selectors] : found) {
    const auto at = listed.find(function);
    if (at == listed.end()) missing[function] = selectors;
    else
      for (const std::string& selector : selectors)
        if (!at->second.contains(selector)) missing[function].insert(selector);
  }
  return missing;
}

TEST(TouchedState, IsOnThePage) {
  Recording recording;
  {
    for (const legacy_gl_programs programs :
         {LEGACY_GL_PROGRAMS_SPECIALISED, LEGACY_GL_PROGRAMS_GENERAL}) {
      legacy_gl_options options{};
      options.programs = programs;
      CoreContext context(kEveryAreaSize, kEveryAreaSize, PixelFormat::rgba8, options,
                          {.loader = shimmed_proc});
      for (int frame = 0; frame < 4; ++frame) draw_every_area(context.gl);
      for (const SceneChange& change : scene_changes()) {
        context.gl.PushAttrib(GL_ALL_ATTRIB_BITS);
        set_up_scene(context.gl);
        change.apply(context.gl);
        draw_scene(context.gl);
        context.gl.PopAttrib();
      }
      legacy_gl_flush();
    }
  }
  // The page lists more: what other drivers, options and calls than these lead to.
  EXPECT_EQ(text_of(missing_in(documented(), recording.touched)), "");
}

// A function that comes to the table is looked at here: it is one of those that the page lists, or
// one of those that set no state, or of the other dialect.
TEST(TouchedState, EveryFunctionOfTheTableIsAccountedFor) {
  static const std::set<std::string> of_es = {"glClearDepthf", "glDepthRangef"};
  const Touched listed = documented();
  std::vector<std::string> unknown;
  const auto look = [&](const std::string& function) {
    const std::string state = function == "glDisable" ? "glEnable" : function;
    if (!changes_objects_alone(function) && !listed.contains(state) && !of_es.contains(function))
      unknown.push_back(function);
  };
#define LEGACY_GL_TEST_LOOK(name, NAME) look("gl" #name);
  LEGACY_GL_DRIVER_FUNCTIONS(LEGACY_GL_TEST_LOOK)
  LEGACY_GL_OPTIONAL_DRIVER_FUNCTIONS(LEGACY_GL_TEST_LOOK)
#undef LEGACY_GL_TEST_LOOK
  EXPECT_EQ(unknown, std::vector<std::string>{});
}

}  // namespace
}  // namespace legacy_gl::test
