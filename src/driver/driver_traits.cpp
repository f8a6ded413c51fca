#include "driver/driver_traits.hpp"

#include <cstring>

#include "driver/arithmetic_test.hpp"
#include "driver/driver.hpp"
#include "state/name_list.hpp"

namespace legacy_gl {

namespace {

constexpr DriverTraitInfo kTable[] = {
    {"rasterises_on_cpu", &DriverTraits::rasterises_on_cpu, false,
     "GL_RENDERER names llvmpipe, alone or below zink (lavapipe): Mesa's rasteriser on the CPU"},
    {"matches_cpu_arithmetic", &DriverTraits::matches_cpu_arithmetic, false,
     "measured: a vertex shader's products, read back, compared bit by bit with the CPU's; GLSL "
     "3.30 spec 4.5.2 lets a compiler fuse a multiplication with an addition"},
    {"shares_fragment_stages", &DriverTraits::shares_fragment_stages, false,
     "on llvmpipe compiling the fragment stage takes most of a program's time, and a pipeline "
     "object keeps it; other drivers optimise across stages and lose by pipelines"},
    {"draws_wide_lines", &DriverTraits::draws_wide_lines, true,
     "forward-compatible contexts raise GL_INVALID_VALUE for wide lines, whatever range they tell "
     "(OpenGL 3.3 core spec E.2.1)"},
};

bool name_has(const Driver& driver, const char* part) {
  const auto* const renderer = reinterpret_cast<const char*>(driver.GetString(GL_RENDERER));
  return renderer && std::strstr(renderer, part);
}

bool offers_wide_lines(const Driver& driver) {
  GLint flags = 0;
  GLfloat widths[2] = {1, 1};
  if (!driver.is_es()) driver.GetIntegerv(GL_CONTEXT_FLAGS, &flags);
  driver.GetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
  return !(flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) && widths[1] > 1;
}

bool has_pipelines(const Driver& driver) {
  return driver.GenProgramPipelines && driver.DeleteProgramPipelines &&
         driver.BindProgramPipeline && driver.UseProgramStages && driver.ProgramParameteri;
}

/// True for a name of the table.
bool override_one(DriverTraits& traits, std::string_view name, bool value) {
  for (const DriverTraitInfo& info : kTable) {
    if (name == info.name) traits.*info.value = value;
    else if (name == "generic") traits.*info.value = info.generic;
    else continue;
    if (name != "generic") return true;
  }
  return name == "generic";
}

void override_traits(DriverTraits& traits, std::string_view overrides, std::string& unknown) {
  for_each_name(overrides, [&](std::string_view name) {
    const bool off = name.front() == '-';
    if (off) name.remove_prefix(1);
    if (!name.empty() && !override_one(traits, name, !off)) append_name(unknown, name);
  });
}

}  // namespace

std::span<const DriverTraitInfo> driver_trait_table() { return kTable; }

DriverTraits find_driver_traits(const Driver& driver, std::string_view overrides,
                                std::string& unknown) {
  DriverTraits traits;
  traits.rasterises_on_cpu = name_has(driver, "llvmpipe");
  traits.shares_fragment_stages = traits.rasterises_on_cpu;
  const bool offers_wide = offers_wide_lines(driver);
  traits.draws_wide_lines = offers_wide;
  override_traits(traits, overrides, unknown);
  // Nobody asks elsewhere, and measuring takes a few milliseconds.
  traits.matches_cpu_arithmetic = traits.rasterises_on_cpu && matches_cpu_arithmetic(driver);
  std::string known;
  override_traits(traits, overrides, known);
  // What the driver does not have no override gives it.
  traits.shares_fragment_stages &= has_pipelines(driver);
  traits.draws_wide_lines &= offers_wide;
  return traits;
}

}  // namespace legacy_gl
