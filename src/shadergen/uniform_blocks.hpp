#pragma once
// Each uniform block: the C++ struct and its std140 text side by side. Sizes and offsets are
// checked here and, in the tests, against the linked program.
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace legacy_gl {

inline constexpr unsigned kMaxLights = 256;

enum UniformBlock : unsigned {
  kTransformBlock,
  kLightsBlock,
  kFrontBlock,
  kBackBlock,
  kPreciseBlock,
  kGeneralBlock,
  kFragmentsBlock,
  kClipPlanesBlock,
  kPolygonStippleBlock,
  kTexturesBlock,
  kPointsBlock,
  kUniformBlockCount
};
inline constexpr std::array<const char*, kUniformBlockCount> kUniformBlockNames{
    "Transform", "Lights",     "FrontMaterial",  "BackMaterial", "Precise", "General",
    "Fragments", "ClipPlanes", "PolygonStipple", "Textures",     "Points"};

struct TransformUniforms {
  glm::mat4 modelview_projection{1.0f};
  glm::mat4 modelview{1.0f};
  std::array<glm::vec4, 3> normal_matrix{};
  glm::vec4 viewer{0};  ///< xyz: the eye in lighting space; w: scale of the normals
  /// x: point size in pixels, y: 0.5 where it is odd; w: the side of the square that a
  /// smooth point is in
  glm::vec4 point{1, 0.5f, 0, 0};
  glm::vec4 viewport{1, 1, 0, 0};  ///< xy: half its size, zw: its centre, in window coordinates
  /// What the modelview lacks to keep angles exactly, a symmetric matrix: half its diagonal, and
  /// its yz, zx and xy.
  glm::vec4 angle_error_half{0}, angle_error_mixed{0};
};
inline constexpr const char* kTransformBlockText = R"(layout(std140) uniform Transform {
  mat4 modelview_projection;
  mat4 modelview;     // object to lighting space
  mat3 normal_matrix;
  vec4 viewer;        // xyz: the eye in lighting space, w: scale of the normals
  vec4 point;         // x: point size in pixels, y: 0.5 where it is odd, w: side of a smooth point
  vec4 viewport;      // xy: half its size, zw: its centre, in window coordinates
  vec4 angle_error_half;   // what the modelview lacks to keep angles exactly: half its diagonal
  vec4 angle_error_mixed;  // its yz, zx, xy
};
)";
static_assert(offsetof(TransformUniforms, normal_matrix) == 128);
static_assert(offsetof(TransformUniforms, viewer) == 176);
static_assert(offsetof(TransformUniforms, angle_error_half) == 224);
static_assert(sizeof(TransformUniforms) == 256);

struct LightUniforms {
  glm::vec4 position{0};  ///< lighting space; a directional light: the unit vector to it
  /// Directional with an infinite viewer: half vector, in multiples of 1/2048 where
  /// splits_half_vectors. w of a point light: the unit of its attenuation, as a factor of
  /// distances.
  glm::vec4 half_vector{0, 0, 0, 1};
  /// k0, k1, k2 for distances in lighting space, w: spot exponent. A directional light: the rest of
  /// its half vector.
  glm::vec4 attenuation{1, 0, 0, 0};
  glm::vec4 spot_direction{0, 0, -1, 2};  ///< unit; w: 2 sin^2(cutoff/2)
};
inline constexpr const char* kLightStructText = R"(struct Light {
  vec4 position;        // in lighting space; directional: the unit vector to the light
  vec4 half_vector;     // directional, infinite viewer: in multiples of 1/2048; w: factor of distances
  vec4 attenuation;     // k0, k1, k2, spot exponent; directional: the rest of half_vector
  vec4 spot_direction;  // xyz: unit vector; w: 2 sin^2(cutoff / 2)
};
)";
static_assert(sizeof(LightUniforms) == 64);

/// What float32 rounded off the blocks above; heads Precise, and a LightLow of each light follows.
struct PreciseUniforms {
  glm::mat4 modelview{0.0f};
  std::array<glm::vec4, 3> normal_matrix{};
  glm::vec4 viewer{0};
};
inline constexpr const char* kPreciseBlockHeadText =
    R"(  mat4 modelview_low;  // what float32 rounded off
  mat3 normal_matrix_low;
  vec4 viewer_low;
)";
static_assert(offsetof(PreciseUniforms, normal_matrix) == 64);
static_assert(sizeof(PreciseUniforms) == 128);

struct LightLow {
  glm::vec4 position{0}, spot_direction{0};
};
inline constexpr const char* kLightLowStructText = R"(struct LightLow {
  vec4 position;
  vec4 spot_direction;
};
)";
static_assert(sizeof(LightLow) == 32);
/// What chooses code in a specialised program, for the general one.
struct GeneralUniforms {
  glm::mat4 lighting_matrix{1.0f};           ///< object coordinates to lighting space
  std::array<glm::vec4, 3> normal_matrix{};  ///< the same for normals, with their scale
  glm::ivec4 light_ends{0};                  ///< of directional, of point, of all lights
  glm::vec4 modes{0};                        ///< x: normalize, y: local viewer
};
inline constexpr const char* kGeneralBlockText = R"(layout(std140) uniform General {
  mat4 lighting_matrix;         // object to lighting space
  mat3 lighting_normal_matrix;
  ivec4 light_ends;             // end of the directional, of the point, of all lights
  vec4 modes;                   // 1 or 0: normalize, local viewer
};
)";
static_assert(offsetof(GeneralUniforms, light_ends) == 112);
static_assert(sizeof(GeneralUniforms) == 144);

/// Fog and alpha test.
struct FragmentUniforms {
  glm::vec4 eye_depth{0};  ///< times an object position: its depth in eye coordinates
  glm::vec4 fog_color{0};
  glm::vec4 fog_parameters{0};  ///< x, y: the mode's factors; w: the alpha test's reference
};
inline constexpr const char* kFragmentsBlockText = R"(layout(std140) uniform Fragments {
  vec4 eye_depth;       // times an object position: its depth in eye coordinates
  vec4 fog_color;
  vec4 fog_parameters;  // xy: factors, w: the alpha test's reference
};
)";
static_assert(sizeof(FragmentUniforms) == 48);

/// Points whose size depends on the distance from the eye.
struct PointUniforms {
  glm::mat4 modelview{1.0f};
  glm::vec4 sizes{1, 0, 1, 1};
  glm::vec4 attenuation{1, 0, 0, 0};
};
inline constexpr const char* kPointsBlockText = R"(layout(std140) uniform Points {
  mat4 point_modelview;    // object to eye coordinates
  vec4 point_sizes;        // at distance 0, least, largest, and where fading begins
  vec4 point_attenuation;  // a, b, c
};
)";
static_assert(sizeof(PointUniforms) == 96);

inline constexpr unsigned kMaxClipDistances = 6;
struct ClipPlaneUniforms {
  std::array<glm::vec4, kMaxClipDistances> planes{};  ///< in clip coordinates
};
inline constexpr const char* kClipPlanesBlockText = R"(layout(std140) uniform ClipPlanes {
  vec4 clip_planes[6];  // in clip coordinates
};
)";
static_assert(sizeof(ClipPlaneUniforms) == 96);

struct PolygonStippleUniforms {
  std::array<std::uint32_t, 32>
      rows{};  ///< the lowest first, the leftmost pixel in the highest bit
  bool operator==(const PolygonStippleUniforms&) const = default;
};
inline constexpr const char* kPolygonStippleBlockText = R"(layout(std140) uniform PolygonStipple {
  uvec4 stipple_rows[8];  // the lowest first, the leftmost pixel in the highest bit
};
)";
static_assert(sizeof(PolygonStippleUniforms) == 128);

/// A light's colours times the material's; the light's own colour where the material comes with the
/// vertex.
struct LightProducts {
  /// In the precise quality, of a light whose ambient term is part of the scene: what float32
  /// rounded off the diffuse product.
  glm::vec4 ambient{0};
  glm::vec4 diffuse{0};  ///< w of the first light: what scaled sums are multiplied by
  glm::vec4 specular{0};
};
static_assert(sizeof(LightProducts) == 48);

/// What heads FrontMaterial and BackMaterial; LightProducts of each light follow.
struct MaterialUniforms {
  glm::vec4 scene{0};  ///< rgb: all that no light direction changes; a: alpha
  glm::vec4 ambient_light{
      0};  ///< rgb: ambient light that a per-vertex ambient material takes; w: shininess
};
inline constexpr const char* kProductsStructText = R"(struct Products {  // light times material
  vec4 ambient;   // precise, where this is part of the scene: the rest of diffuse
  vec4 diffuse;
  vec4 specular;
};
)";
static_assert(sizeof(MaterialUniforms) == 32);

struct TextureUnitUniforms {
  glm::mat4 matrix{1.0f};
  std::array<glm::vec4, 4> planes{};  ///< of s, t, r, q, in object coordinates
  glm::vec4 color{0};                 ///< of the environment
  glm::vec4 parameters{0};            ///< x: level of detail bias
};
inline constexpr const char* kTextureUnitStructText = R"(struct TextureUnit {
  mat4 matrix;
  vec4 planes[4];   // of s, t, r, q, in object coordinates
  vec4 color;       // of the environment
  vec4 parameters;  // x: level of detail bias
};
)";
static_assert(sizeof(TextureUnitUniforms) == 160);

/// What heads Textures; units follow.
struct TexturesUniforms {
  glm::mat4 modelview{1.0f};                 ///< object to eye coordinates
  std::array<glm::vec4, 3> normal_matrix{};  ///< to eye coordinates
};
inline constexpr const char* kTexturesHeadText = R"(layout(std140) uniform Textures {
  mat4 texgen_modelview;  // object to eye coordinates
  mat3 texgen_normal_matrix;
)";
static_assert(sizeof(TexturesUniforms) == 112);

}  // namespace legacy_gl
