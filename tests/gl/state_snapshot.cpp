#include "gl/state_snapshot.hpp"

#include <array>
#include <cstdint>
#include <sstream>

namespace legacy_gl::test {

namespace {

struct NamedEnum {
  const char* name;
  GLenum value;
};
#define NAMED(e) \
  { #e, e }

constexpr NamedEnum kValues[] = {
#include "gl/snapshot_values.inc"
};

constexpr NamedEnum kCapabilities[] = {
#include "gl/snapshot_capabilities.inc"
};

constexpr NamedEnum kLightParameters[] = {
    NAMED(GL_AMBIENT),
    NAMED(GL_DIFFUSE),
    NAMED(GL_SPECULAR),
    NAMED(GL_POSITION),
    NAMED(GL_SPOT_DIRECTION),
    NAMED(GL_SPOT_EXPONENT),
    NAMED(GL_SPOT_CUTOFF),
    NAMED(GL_CONSTANT_ATTENUATION),
    NAMED(GL_LINEAR_ATTENUATION),
    NAMED(GL_QUADRATIC_ATTENUATION),
};
constexpr NamedEnum kMaterialParameters[] = {
    NAMED(GL_AMBIENT),  NAMED(GL_DIFFUSE),   NAMED(GL_SPECULAR),
    NAMED(GL_EMISSION), NAMED(GL_SHININESS), NAMED(GL_COLOR_INDEXES),
};
constexpr NamedEnum kPointers[] = {
    NAMED(GL_VERTEX_ARRAY_POINTER),        NAMED(GL_NORMAL_ARRAY_POINTER),
    NAMED(GL_COLOR_ARRAY_POINTER),         NAMED(GL_SECONDARY_COLOR_ARRAY_POINTER),
    NAMED(GL_INDEX_ARRAY_POINTER),         NAMED(GL_FOG_COORD_ARRAY_POINTER),
    NAMED(GL_TEXTURE_COORD_ARRAY_POINTER), NAMED(GL_EDGE_FLAG_ARRAY_POINTER),
};

#undef NAMED

// More than a query returns stays 0, on both sides of the comparison. The last value is the query's
// own error.
template <typename T, typename Query>
std::vector<double> values_of(const GlFunctions& gl, Query query) {
  std::array<T, 16> values{};
  query(values.data());
  std::vector<double> result(values.begin(), values.end());
  result.push_back(gl.GetError());
  return result;
}

}  // namespace

StateSnapshot take_snapshot(const GlFunctions& gl) {
  StateSnapshot snapshot;
  for (const NamedEnum& item : kValues)
    snapshot[item.name] =
        values_of<GLdouble>(gl, [&](GLdouble* values) { gl.GetDoublev(item.value, values); });
  for (const NamedEnum& item : kCapabilities)
    snapshot[item.name] =
        values_of<GLint>(gl, [&](GLint* value) { *value = gl.IsEnabled(item.value); });
  for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light)
    for (const NamedEnum& item : kLightParameters)
      snapshot["GL_LIGHT" + std::to_string(light - GL_LIGHT0) + " " + item.name] =
          values_of<GLfloat>(gl,
                             [&](GLfloat* values) { gl.GetLightfv(light, item.value, values); });
  for (const GLenum face : {GLenum{GL_FRONT}, GLenum{GL_BACK}})
    for (const NamedEnum& item : kMaterialParameters)
      snapshot[(face == GL_FRONT ? "GL_FRONT " : "GL_BACK ") + std::string(item.name)] =
          values_of<GLfloat>(gl,
                             [&](GLfloat* values) { gl.GetMaterialfv(face, item.value, values); });
  for (const NamedEnum& item : kPointers) {
    snapshot[item.name] = values_of<std::uintptr_t>(gl, [&](std::uintptr_t* value) {
      void* pointer = nullptr;
      gl.GetPointerv(item.value, &pointer);
      *value = reinterpret_cast<std::uintptr_t>(pointer);
    });
  }
  return snapshot;
}

std::string difference(const StateSnapshot& before, const StateSnapshot& after) {
  std::ostringstream text;
  for (const auto& [name, values] : before) {
    const std::vector<double>& other = after.at(name);
    if (values == other) continue;
    text << name << ':';
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i] != other[i]) text << " [" << i << "] " << values[i] << " became " << other[i];
    text << '\n';
  }
  return text.str();
}

std::string unknown_names(const StateSnapshot& snapshot) {
  std::string names;
  for (const auto& [name, values] : snapshot)
    if (values.back() != GL_NO_ERROR) names += name + '\n';
  return names;
}

}  // namespace legacy_gl::test
