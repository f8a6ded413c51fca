#pragma once
// Evaluators (GL 2.1 spec 5.1): polynomial maps to vertices and their attributes.
#include <array>
#include <cstdint>
#include <vector>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// In the order of their enums, from GL_MAP1_COLOR_4 and GL_MAP2_COLOR_4 on.
enum EvaluatorMap : unsigned {
  kMapColor4,
  kMapIndex,
  kMapNormal,
  kMapTexcoord1,
  kMapTexcoord2,
  kMapTexcoord3,
  kMapTexcoord4,
  kMapVertex3,
  kMapVertex4,
  kMapCount
};

inline constexpr GLint kMaxEvalOrder = 30;

/// How many values a control point has.
constexpr unsigned map_components(unsigned map) {
  constexpr unsigned kComponents[kMapCount] = {4, 1, 3, 1, 2, 3, 4, 3, 4};
  return kComponents[map];
}

/// One polynomial in Bernstein form: control points, the second parameter's fastest.
struct Polynomial {
  std::array<GLint, 2> order{1, 1};         ///< the second is 1 for one parameter
  std::array<float, 4> domain{0, 1, 0, 1};  ///< u1, u2, v1, v2
  std::vector<float> points;
};

/// What GL_EVAL_BIT saves.
struct EvaluatorModes {
  std::array<std::uint16_t, 2> enabled{};  ///< a bit for each map of one, and of two parameters
  bool auto_normal = false;
  std::array<GLint, 3> segments{1, 1, 1};  ///< of the curve's grid; of the surface's, u and v
  std::array<float, 6> grid{0, 1, 0, 1, 0, 1};
  bool operator==(const EvaluatorModes&) const = default;
};

struct EvaluatorState {
  EvaluatorState();
  std::array<std::array<Polynomial, kMapCount>, 2> maps;  ///< of one, and of two parameters
  EvaluatorModes modes;
};

/// Values at (u, v), and the derivatives by u and v.
struct Evaluated {
  std::array<float, 4> value{0, 0, 0, 1}, du{}, dv{};
};
Evaluated evaluate(const Polynomial& polynomial, unsigned components, float u, float v);

}  // namespace legacy_gl
