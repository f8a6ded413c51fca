#pragma once
// Shared by the files that derive (derive*.cpp, reached_lights.cpp), nobody else's.
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "translate/draw_inputs.hpp"

namespace legacy_gl {

/// The clip planes that cut what is drawn, in clip coordinates.
class EnabledClipPlanes {
 public:
  explicit EnabledClipPlanes(const DrawInputs& derived) {
    for (unsigned i = 0; i < kMaxClipPlanes; ++i)
      if (derived.key.fragments.clip_planes & 1u << i)
        planes_[count_++] = derived.clip_planes.planes[i];
  }
  operator std::span<const glm::vec4>() const { return {planes_.data(), count_}; }

 private:
  std::array<glm::vec4, kMaxClipPlanes> planes_;
  std::size_t count_ = 0;
};

/// NaN becomes 0 and infinity the largest float: one bad parameter stays one bad parameter.
inline float finite(double value) {
  if (std::isnan(value)) return 0;
  return static_cast<float>(std::clamp(value, -double{FLT_MAX}, double{FLT_MAX}));
}

inline glm::vec4 finite(const glm::dvec3& v, double w) {
  return {finite(v.x), finite(v.y), finite(v.z), finite(w)};
}

/// What `part` lacks of a value; 0 of a value that is not finite.
inline glm::vec4 rest_of(const glm::dvec4& value, const glm::vec4& part) {
  const glm::dvec4 rest = value - glm::dvec4(part);
  return std::isfinite(rest.x + rest.y + rest.z + rest.w) ? glm::vec4(rest) : glm::vec4(0);
}

/// What float32 rounds off.
inline glm::vec4 low(const glm::dvec3& v, double w) {
  return rest_of(glm::dvec4(v, w), finite(v, w));
}

inline double largest_component(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

inline glm::dvec3 unit(const glm::dvec3& v) {
  const double largest = largest_component(v);
  if (!(largest > 0) || !std::isfinite(largest)) return glm::dvec3(0);
  const glm::dvec3 scaled = v / largest;
  return scaled / glm::length(scaled);
}

inline glm::dvec3 rgb(const glm::vec4& color) { return {color.r, color.g, color.b}; }

inline bool is_directional(const Light& light) { return light.position_eye.w == 0; }

inline bool is_spot(const Light& light) { return light.spot_cutoff_degrees != 180; }

/// The material as one of GL's colours, or white where it comes with the vertex.
inline glm::dvec3 uniform_material(const Context& context, const ProgramKey& key, unsigned face,
                                   unsigned property) {
  if (key.material[face][property] != MaterialSource::kUniform) return glm::dvec3(1);
  return rgb(material_value(context.lighting.materials, face, property));
}

inline bool folds_into_scene(std::uint8_t kind) {
  return !(kind & (kLightAttenuated | kLightSpot));
}

/// GL_WIN_phong_shading: the equation in every fragment.
inline bool is_per_fragment(const Context& context) {
  const GLenum shade_model = context.lighting.shade_model;
  return shade_model == GL_PHONG_WIN ||
         (shade_model == GL_SMOOTH && context.options.quality == LEGACY_GL_QUALITY_PER_FRAGMENT);
}

/// Interpolation leaves nothing of a second float.
inline bool is_precise(const Context& context) {
  return context.options.quality == LEGACY_GL_QUALITY_PRECISE && !is_per_fragment(context);
}

inline Quality quality_of(const Context& context) {
  switch (context.options.quality) {
    case LEGACY_GL_QUALITY_FASTEST: return Quality::kFastest;
    case LEGACY_GL_QUALITY_PRECISE:
      return is_precise(context) ? Quality::kPrecise : Quality::kDefault;
    case LEGACY_GL_QUALITY_DEFAULT:
    case LEGACY_GL_QUALITY_PER_FRAGMENT: break;
  }
  return Quality::kDefault;
}

inline bool has_light(const ProgramKey& key, std::uint8_t bits) {
  return std::any_of(key.lights.begin(), key.lights.end(),
                     [=](const LightRun& run) { return run.count && run.kind & bits; });
}

inline unsigned face_count(const ProgramKey& key) { return key.two_side ? 2 : 1; }

}  // namespace legacy_gl
