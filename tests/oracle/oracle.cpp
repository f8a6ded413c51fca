#include "oracle/oracle.hpp"

#include <limits>

namespace oracle {
namespace {

constexpr double largest_float = std::numeric_limits<float>::max();

// A vertex given exactly on the cone has its cosine rounded to either side even in double; ties
// within a few units of the last place of `double` count as on the cone, which is lit (2.14.1, >=).
constexpr double cone_tie = 1e-15;

template <class Scalar>
struct Basis {
  Vector3<Scalar> normal_eye;
  Vector4<Scalar> position_eye;
  bool defined = true;
};

// GL 2.1 spec 2.11.3: n' = n * Mu^-1, times the rescale factor, then unit length.
template <class Scalar>
Basis<Scalar> transform_vertex(const State& state, const Vertex& vertex) {
  Basis<Scalar> basis;
  const auto& p = vertex.position_object;
  basis.position_eye =
      transform<Scalar>(state.modelview, {Scalar(p[0]), Scalar(p[1]), Scalar(p[2]), Scalar(p[3])});

  const Vector3<Scalar> c0 = upper_column<Scalar>(state.modelview, 0);
  const Vector3<Scalar> c1 = upper_column<Scalar>(state.modelview, 1);
  const Vector3<Scalar> c2 = upper_column<Scalar>(state.modelview, 2);
  const Vector3<Scalar> n{Scalar(vertex.normal_object[0]), Scalar(vertex.normal_object[1]),
                          Scalar(vertex.normal_object[2])};
  // Columns of the cofactor matrix; the inverse's rows are these over the determinant.
  const Vector3<Scalar> k0 = cross(c1, c2), k1 = cross(c2, c0), k2 = cross(c0, c1);
  const Scalar determinant = dot(c0, k0);
  const Scalar volume = length(c0) * length(c1) * length(c2);
  // Below this the determinant of a double matrix is rounding, not information.
  if (!(scalar::abs(determinant) > Scalar(1e-13) * volume)) {
    basis.defined = false;
    return basis;
  }
  Vector3<Scalar> m = (Scalar(1) / determinant) * (n.x * k0 + n.y * k1 + n.z * k2);
  if (state.rescale_normal) {
    // f = 1 / length of the third row of the inverse.
    m = (scalar::abs(determinant) / length(k2)) * m;
  }
  if (state.normalize) {
    if (length(m) == Scalar(0)) basis.defined = false;
    m = unit(m);
  }
  basis.normal_eye = m;
  return basis;
}

// The unit vector from `from` to `to`, homogeneous (2.14.1), and their distance.
template <class Scalar>
struct Direction {
  Vector3<Scalar> unit_vector;
  Scalar distance{};
};

template <class Scalar>
Direction<Scalar> direction(Vector4<Scalar> from, Vector4<Scalar> to) {
  const Scalar zero(0);
  if (to.w == zero && from.w == zero) {
    const auto difference = xyz(to) - xyz(from);
    return {unit(difference), length(difference)};
  }
  const Scalar infinite = Scalar(std::numeric_limits<double>::infinity());
  if (to.w == zero) return {unit(xyz(to)), infinite};
  if (from.w == zero) return {unit(Scalar(-1) * xyz(from)), infinite};
  const auto difference = (Scalar(1) / to.w) * xyz(to) - (Scalar(1) / from.w) * xyz(from);
  return {unit(difference), length(difference)};
}

// 0^0 is 1, for the shininess and for the spot exponent. Saturated far above every float, so that a
// long normal to the power 128 times a black material is 0 and not NaN.
template <class Scalar>
Scalar power(Scalar base, float exponent) {
  if (exponent == 0) return Scalar(1);
  const Scalar result = scalar::pow(base, Scalar(exponent));
  return result > Scalar(1e150) ? Scalar(1e150) : result;
}

template <class Scalar>
bool is_zero(Vector3<Scalar> v) {
  return v.x == Scalar(0) && v.y == Scalar(0) && v.z == Scalar(0);
}

bool any_nonzero(const Color& a, const Color& b) {
  return a[0] * b[0] != 0 || a[1] * b[1] != 0 || a[2] * b[2] != 0;
}

// Everything of one light that does not depend on the face.
template <class Scalar>
struct Incidence {
  Vector3<Scalar> to_light, half_vector;
  Scalar attenuation_times_spot{};
};

template <class Scalar>
Incidence<Scalar> incidence(const State& state, const Light& light, Vector4<Scalar> position_eye,
                            BasicResult<Scalar>& result) {
  Incidence<Scalar> out;
  const Scalar zero(0), one(1);
  const auto& p = light.position_specified;
  const Vector4<Scalar> light_eye = transform<Scalar>(
      light.position_modelview, {Scalar(p[0]), Scalar(p[1]), Scalar(p[2]), Scalar(p[3])});
  const Direction<Scalar> to_light = direction(position_eye, light_eye);
  out.to_light = to_light.unit_vector;
  if (is_zero(out.to_light)) result.defined = false;

  Scalar attenuation = one;
  if (light_eye.w != zero) {
    const Scalar d = to_light.distance;
    Scalar denominator = Scalar(light.constant_attenuation);
    // Guarded so that 0 * infinity (a vertex at infinity) stays 0.
    if (light.linear_attenuation != 0) denominator += Scalar(light.linear_attenuation) * d;
    if (light.quadratic_attenuation != 0)
      denominator += Scalar(light.quadratic_attenuation) * d * d;
    if (denominator == zero) {
      result.defined = false;
      attenuation = Scalar(largest_float);
    } else {
      attenuation = one / denominator;
    }
  }

  Scalar spot = one;
  if (light.spot_cutoff_degrees != 180) {
    const auto& s = light.spot_direction_specified;
    const Vector3<Scalar> spot_direction = unit(xyz(transform<Scalar>(
        light.spot_direction_modelview, {Scalar(s[0]), Scalar(s[1]), Scalar(s[2]), zero})));
    if (is_zero(spot_direction)) result.defined = false;
    const Scalar cos_angle = -dot(out.to_light, spot_direction);
    const Scalar cos_cutoff = scalar::cos_degrees(Scalar(light.spot_cutoff_degrees));
    // The cone is tested on the dot product before it is clamped: what is behind a spot light of
    // 90 degrees is outside it.
    const Scalar margin = cos_angle - cos_cutoff;
    const bool inside = margin >= Scalar(-cone_tie);
    spot = inside ? power(scalar::max(cos_angle, zero), light.spot_exponent) : zero;
    const double jump = double(scalar::abs(margin));
    if (jump < result.distance_to_jump) result.distance_to_jump = jump;
  }
  out.attenuation_times_spot = attenuation * spot;

  Vector3<Scalar> to_eye{zero, zero, one};
  if (state.light_model.local_viewer) {
    to_eye = direction(position_eye, Vector4<Scalar>{zero, zero, zero, one}).unit_vector;
    if (is_zero(to_eye)) result.defined = false;
  }
  const Vector3<Scalar> half = out.to_light + to_eye;
  // Nothing meaningful is left of a sum this short: L is opposite to E, and h counts as zero.
  if (!(length(half) < Scalar(1e-14))) out.half_vector = unit(half);
  return out;
}

template <class Scalar>
Scalar clamp01(Scalar x) {
  if (!(x > Scalar(0))) return Scalar(0);  // NaN too
  return x > Scalar(1) ? Scalar(1) : x;
}

Material tracked(const State& state, bool back, const Color& current) {
  Material material = back ? state.back : state.front;
  const ColorMaterial& tracking = state.color_material;
  const ColorMaterial::Face other = back ? ColorMaterial::Face::front : ColorMaterial::Face::back;
  if (!tracking.enabled || tracking.face == other) return material;
  switch (tracking.mode) {
    case ColorMaterial::Mode::ambient_and_diffuse:
      material.ambient = material.diffuse = current;
      break;
    case ColorMaterial::Mode::ambient: material.ambient = current; break;
    case ColorMaterial::Mode::diffuse: material.diffuse = current; break;
    case ColorMaterial::Mode::specular: material.specular = current; break;
    case ColorMaterial::Mode::emission: material.emission = current; break;
  }
  return material;
}

template <class Scalar>
FaceColors<Scalar> light_face(const State& state, const Material& material,
                              const std::vector<Incidence<Scalar>>& incidences,
                              Vector3<Scalar> normal, BasicResult<Scalar>& result) {
  const Scalar zero(0);
  std::array<Scalar, 3> sum{}, specular_sum{};
  for (std::size_t c = 0; c < 3; ++c) {
    sum[c] = Scalar(material.emission[c]) +
             Scalar(material.ambient[c]) * Scalar(state.light_model.ambient[c]);
  }
  for (std::size_t i = 0; i < state.lights.size(); ++i) {
    const Light& light = state.lights[i];
    const Incidence<Scalar>& at = incidences[i];
    const Scalar n_dot_l_signed = dot(normal, at.to_light);
    const Scalar n_dot_l = scalar::max(n_dot_l_signed, zero);
    const Scalar n_dot_h = scalar::max(dot(normal, at.half_vector), zero);
    const Scalar specular_factor =
        n_dot_l != zero ? power(n_dot_h, material.shininess) : zero;  // f_i
    if (any_nonzero(material.specular, light.specular) && at.attenuation_times_spot != zero) {
      if (n_dot_l != zero && is_zero(at.half_vector)) result.defined = false;
      const Scalar normal_length = length(normal);
      const double jump =
          normal_length > zero ? double(scalar::abs(n_dot_l_signed) / normal_length) : 1.0;
      if (jump < result.distance_to_jump) result.distance_to_jump = jump;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += at.attenuation_times_spot *
                (Scalar(material.ambient[c]) * Scalar(light.ambient[c]) +
                 n_dot_l * Scalar(material.diffuse[c]) * Scalar(light.diffuse[c]));
      specular_sum[c] += at.attenuation_times_spot * specular_factor *
                         Scalar(material.specular[c]) * Scalar(light.specular[c]);
    }
  }
  FaceColors<Scalar> colors;
  for (std::size_t c = 0; c < 3; ++c) {
    const bool separate = state.light_model.separate_specular_color;
    colors.primary[c] = separate ? sum[c] : sum[c] + specular_sum[c];
    colors.secondary[c] = separate ? specular_sum[c] : zero;
  }
  colors.primary[3] = Scalar(material.diffuse[3]);
  for (std::size_t c = 0; c < 4; ++c) {
    if (!scalar::is_finite(colors.primary[c]) || !scalar::is_finite(colors.secondary[c])) {
      result.defined = false;
    }
    colors.primary_clamped[c] = clamp01(colors.primary[c]);
    colors.secondary_clamped[c] = clamp01(colors.secondary[c]);
  }
  return colors;
}

}  // namespace

template <class Scalar>
BasicResult<Scalar> evaluate_as(const State& state, const Vertex& vertex) {
  BasicResult<Scalar> result;
  const Basis<Scalar> basis = transform_vertex<Scalar>(state, vertex);
  result.defined = basis.defined;
  std::vector<Incidence<Scalar>> incidences;
  incidences.reserve(state.lights.size());
  for (const Light& light : state.lights) {
    incidences.push_back(incidence(state, light, basis.position_eye, result));
  }
  result.front =
      light_face(state, tracked(state, false, vertex.color), incidences, basis.normal_eye, result);
  result.back = state.light_model.two_side
                    ? light_face(state, tracked(state, true, vertex.color), incidences,
                                 Scalar(-1) * basis.normal_eye, result)
                    : result.front;
  return result;
}

Result evaluate(const State& state, const Vertex& vertex) {
  return evaluate_as<double>(state, vertex);
}

template BasicResult<double> evaluate_as(const State&, const Vertex&);
template BasicResult<long double> evaluate_as(const State&, const Vertex&);
#ifdef ORACLE_HAS_FLOAT128
template BasicResult<OracleFloat128> evaluate_as(const State&, const Vertex&);
#endif

}  // namespace oracle
