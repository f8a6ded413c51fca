#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include "shadergen/fragment_key.hpp"
#include "shadergen/texture_key.hpp"

namespace legacy_gl {

/// The GLSL a driver speaks. Not part of the key: one context has one dialect.
enum class Dialect : std::uint8_t { kCore330, kEs300 };

/// Facts about one light that choose code. Lights of the same kind are neighbours in the blocks and
/// in the GLSL.
enum LightKindBit : std::uint8_t {
  kLightPoint = 1,         ///< has a position; otherwise a direction
  kLightAttenuated = 2,    ///< 1/(k0 + k1 d + k2 d²) varies with d
  kLightSpot = 4,          ///< point light with a cone
  kLightSpotExponent = 8,  ///< cone with an exponent other than 0
  kLightAmbient = 16,      ///< its ambient term is not zero and not folded into the scene colour
  kLightDiffuse = 32,      ///< its diffuse term is not zero
  kLightSpecular = 64      ///< its specular term is not zero
};

/// `count` neighbouring lights of one kind; count 0 ends the list.
struct LightRun {
  std::uint8_t kind = 0;
  std::uint16_t count = 0;
  bool operator==(const LightRun&) const = default;
};
inline constexpr unsigned kMaxLightRuns = 8;

/// Where normals, positions and lights meet.
enum class LightingSpace : std::uint8_t {
  kObject,         ///< the modelview preserves angles: lights were brought to the object
  kEyeAxes,        ///< eye axes with the object's origin: no large translation to round away
  kEyeHomogeneous  ///< eye coordinates with V/w: vertex w or a perspective modelview
};

enum class NormalMode : std::uint8_t {
  kAsIs,      ///< object space, no scale
  kScaled,    ///< object space, uniform scale
  kMatrix,    ///< normal matrix (the rescale factor is in it)
  kNormalize  ///< made unit length in the shader; in eye axes after the normal matrix
};

/// How lighting is computed.
enum class Quality : std::uint8_t {
  kDefault,
  kFastest,  ///< within a quarter of a step of 8 bits
  kPrecise   ///< in pairs of floats
};

/// Where a material property comes from.
enum class MaterialSource : std::uint8_t { kUniform, kColor, kVertex };

/// What the fragments of a pixel rectangle take from the texture that holds its pixels.
enum class PixelSource : std::uint8_t {
  kNone,    ///< no pixel rectangle
  kBitmap,  ///< whether there is a fragment
  kColors,  ///< the colour
  kDepths,  ///< the depth
  kStencil  ///< whether there is a fragment: those whose index has a bit set
};

/// Glyphs lie in a texture together and have quads of their own; other images fill the texture, and
/// the quad is as large as the zoom makes them.
constexpr bool is_zoomed(PixelSource source) { return source > PixelSource::kBitmap; }

/// Everything that chooses the text of a program, and nothing else. Normalised: a field that cannot
/// matter is zero.
struct ProgramKey {
  bool lit = false;
  bool flat = false;
  bool secondary_from_vertex = false;  ///< unlit with GL_COLOR_SUM
  bool two_side = false;
  bool local_viewer = false;
  bool separate_specular = false;
  bool position4 = false;       ///< the position attribute has a w
  bool w_is_one = false;        ///< lit, and the position attribute has none
  bool parallel = false;        ///< w_is_one, and modelview and projection leave w as it is
  bool points = false;          ///< draws GL_POINTS
  bool point_distance = false;  ///< whose size depends on the distance from the eye, or fades
  bool point_fade = false;      ///< small ones fade instead
  bool per_fragment = false;
  bool scaled_sums = false;  ///< colours so large that sums of their products leave the range
  bool angle_error = false;  ///< object space under a modelview that keeps angles only nearly
  bool back_only =
      false;  ///< unfilled back faces: every primitive of the draw takes the back colour
  /// Lit at a position of its own: the provoking vertex's (flat and unfilled), or in eye
  /// coordinates where positions come transformed.
  bool lighting_position = false;
  bool depth_offset = false;  ///< unfilled with polygon offset
  bool line_offset = false;   ///< lines that make wide ones, where the driver has none
  PixelSource pixels = PixelSource::kNone;
  LightingSpace space = LightingSpace::kObject;
  NormalMode normal = NormalMode::kAsIs;
  Quality quality = Quality::kDefault;
  /// [face][ambient, diffuse, specular, emission, shininess]
  std::array<std::array<MaterialSource, 5>, 2> material{};
  /// The properties that vertices carry, bit face * 5 + property, whether they are read or not:
  /// they have locations.
  std::uint16_t vertex_materials = 0;
  /// Shininess of each face: 0 to 128 is raised by repeated squaring, kGeneralShininess by exp2 and
  /// a logarithm.
  std::array<std::uint8_t, 2> integer_shininess{};
  std::array<LightRun, kMaxLightRuns> lights{};
  /// 0, or the key is a general program's: room for this many lights, whose facts are uniforms
  /// (general.hpp).
  std::uint16_t general_lights = 0;
  FragmentKey fragments;
  TextureKey textures;
  bool operator==(const ProgramKey&) const = default;

  unsigned light_count() const {
    unsigned total = 0;
    for (const LightRun& run : lights) total += run.count;
    return total;
  }
};

/// What is lit depends on where it is: some light is a point, or the viewer is local.
bool lighting_reads_position(const ProgramKey& key);

/// Half vectors depend on the vertex: a specular light is a point, or the viewer is local.
bool computes_half_vectors(const ProgramKey& key);

/// A directional light's half vector meets the normal in two parts, whose products are exact. Else,
/// as a unit vector, it meets unit normals, or normals whose lengths are taken into account.
bool splits_half_vectors(const ProgramKey& key);

/// The texture unit that pixel rectangles are read from, as the sampler pixel_texture.
inline constexpr unsigned kPixelTextureUnit = 15;

inline constexpr std::uint8_t kGeneralShininess = 255;
/// The room of a general program unless there are more lights.
inline constexpr std::uint16_t kGeneralLights = 8;

struct ProgramKeyHash {
  std::size_t operator()(const ProgramKey& key) const noexcept;
};

/// The key in words, as line 1 of the GLSL says it.
std::string describe(const ProgramKey& key);

}  // namespace legacy_gl
