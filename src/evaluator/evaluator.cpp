#include "evaluator/evaluator.hpp"

namespace legacy_gl {

namespace {

struct Basis {
  std::array<double, kMaxEvalOrder> weight{}, slope{};
};

/// Bernstein polynomials of `order` control points, and their derivatives by the parameter that
/// goes from `begin` to `end`.
Basis bernstein(GLint order, float parameter, float begin, float end) {
  const double length = static_cast<double>(end) - static_cast<double>(begin);
  const double t = (static_cast<double>(parameter) - static_cast<double>(begin)) / length;
  Basis basis;
  basis.weight[0] = 1;
  const auto count = static_cast<unsigned>(order);
  for (unsigned n = 1; n < count; ++n) {
    if (n + 1 == count)  // the derivatives come from the degree below
      for (unsigned i = 0; i <= n; ++i)
        basis.slope[i] =
            n / length * ((i ? basis.weight[i - 1] : 0) - (i < n ? basis.weight[i] : 0));
    for (unsigned i = n; i > 0; --i)
      basis.weight[i] = (1 - t) * basis.weight[i] + t * basis.weight[i - 1];
    basis.weight[0] *= 1 - t;
  }
  return basis;
}

/// GL 2.1 spec table 5.1: one control point, as the current values are at first.
std::vector<float> initial_point(unsigned map) {
  switch (map) {
    case kMapColor4: return {1, 1, 1, 1};
    case kMapIndex: return {1};
    case kMapNormal: return {0, 0, 1};
    case kMapTexcoord4:
    case kMapVertex4: return {0, 0, 0, 1};
    default: return std::vector<float>(map_components(map), 0.0f);
  }
}

}  // namespace

EvaluatorState::EvaluatorState() {
  for (auto& dimension : maps)
    for (unsigned map = 0; map < kMapCount; ++map) dimension[map].points = initial_point(map);
}

Evaluated evaluate(const Polynomial& polynomial, unsigned components, float u, float v) {
  const auto [u1, u2, v1, v2] = polynomial.domain;
  const Basis along_u = bernstein(polynomial.order[0], u, u1, u2);
  const Basis along_v = bernstein(polynomial.order[1], v, v1, v2);
  std::array<double, 4> value{0, 0, 0, 1}, du{}, dv{};
  for (unsigned c = 0; c < components; ++c) value[c] = 0;
  const float* point = polynomial.points.data();
  for (unsigned i = 0; i < static_cast<unsigned>(polynomial.order[0]); ++i)
    for (unsigned j = 0; j < static_cast<unsigned>(polynomial.order[1]); ++j)
      for (unsigned c = 0; c < components; ++c) {
        const auto p = static_cast<double>(*point++);
        value[c] += along_u.weight[i] * along_v.weight[j] * p;
        du[c] += along_u.slope[i] * along_v.weight[j] * p;
        dv[c] += along_u.weight[i] * along_v.slope[j] * p;
      }
  Evaluated result;
  for (unsigned c = 0; c < 4; ++c) {
    result.value[c] = static_cast<float>(value[c]);
    result.du[c] = static_cast<float>(du[c]);
    result.dv[c] = static_cast<float>(dv[c]);
  }
  return result;
}

}  // namespace legacy_gl
