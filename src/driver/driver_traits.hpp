#pragma once
// What is true of this driver and not of every one. The only place that looks at a driver's name.
#include <span>
#include <string>
#include <string_view>

namespace legacy_gl {

struct Driver;

struct DriverTraits {
  /// Triangles and pixels cost CPU time: work that spares the rasteriser pays here, and not on a
  /// GPU.
  bool rasterises_on_cpu = false;
  /// A vertex shader's product of matrix and position has the bits that the same product has in
  /// C++. Vertices that are transformed here and those that the driver transforms then meet without
  /// gaps, and pass GL_EQUAL.
  bool matches_cpu_arithmetic = false;
  /// A program as two stages that are linked apart: a new vertex stage keeps the compiled fragment
  /// stage.
  bool shares_fragment_stages = false;
  /// glLineWidth draws lines wider than one pixel.
  bool draws_wide_lines = true;
};

/// One trait for people: its name in LEGACY_GL_DRIVER_TRAITS, and why it is looked at.
struct DriverTraitInfo {
  const char* name;
  bool DriverTraits::*value;
  bool generic;        ///< what a driver that nothing is known of has
  const char* reason;  ///< with its source
};
std::span<const DriverTraitInfo> driver_trait_table();

/// What is found of the driver, which is current, and what `overrides` says of it: names separated
/// by commas, each of which turns a trait on, with a minus before it off; "generic" gives every
/// trait the value of a driver that nothing is known of. Names that there are not are put into
/// `unknown`.
DriverTraits find_driver_traits(const Driver& driver, std::string_view overrides,
                                std::string& unknown);

}  // namespace legacy_gl
