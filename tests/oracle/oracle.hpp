// The referee: what OpenGL 2.1 (sections 2.11.3 and 2.14) says one lit vertex must come out as.
//
// It takes the values exactly as they were given to GL and evaluates the whole equation in a wide
// scalar. It shares no code with the library. `double` is the working precision; the same code in
// a wider scalar measures how far `double` can be trusted.
#pragma once

#include <array>
#include <vector>

#include "oracle/vector.hpp"

namespace oracle {

using Color = std::array<float, 4>;

struct Light {
  Color ambient{0, 0, 0, 1};
  Color diffuse{1, 1, 1, 1};
  Color specular{1, 1, 1, 1};
  // As given to glLight, with the modelview of that moment (identity: eye coordinates).
  std::array<float, 4> position_specified{0, 0, 1, 0};
  Matrix4 position_modelview = identity_matrix;
  std::array<float, 3> spot_direction_specified{0, 0, -1};
  Matrix4 spot_direction_modelview = identity_matrix;
  float spot_exponent = 0;
  float spot_cutoff_degrees = 180;
  float constant_attenuation = 1;
  float linear_attenuation = 0;
  float quadratic_attenuation = 0;
};

struct Material {
  Color ambient{0.2f, 0.2f, 0.2f, 1};
  Color diffuse{0.8f, 0.8f, 0.8f, 1};
  Color specular{0, 0, 0, 1};
  Color emission{0, 0, 0, 1};
  float shininess = 0;
};

struct LightModel {
  Color ambient{0.2f, 0.2f, 0.2f, 1};
  bool local_viewer = false;
  bool two_side = false;
  bool separate_specular_color = false;
};

struct ColorMaterial {
  enum class Face { front, back, front_and_back };
  enum class Mode { ambient_and_diffuse, ambient, diffuse, specular, emission };
  bool enabled = false;
  Face face = Face::front_and_back;
  Mode mode = Mode::ambient_and_diffuse;
};

struct State {
  std::vector<Light> lights;  // the enabled ones
  Material front, back;
  LightModel light_model;
  ColorMaterial color_material;
  bool normalize = false;
  bool rescale_normal = false;
  Matrix4 modelview = identity_matrix;
};

struct Vertex {
  std::array<float, 4> position_object{0, 0, 0, 1};
  std::array<float, 3> normal_object{0, 0, 1};
  Color color{1, 1, 1, 1};
};

template <class Scalar>
struct FaceColors {
  std::array<Scalar, 4> primary{}, secondary{};                  // as the equation gives them
  std::array<Scalar, 4> primary_clamped{}, secondary_clamped{};  // to [0,1]; NaN becomes 0
};

template <class Scalar>
struct BasicResult {
  FaceColors<Scalar> front;
  FaceColors<Scalar> back;  // -n and the back material when two-sided, else equal to front
  // False where the specification gives no answer: zero normal with GL_NORMALIZE, singular
  // modelview, light or eye at the vertex, zero half vector, attenuation denominator 0, anything
  // that is not finite. The colours then follow the project's rule: each lost vector counts as
  // zero, a denominator of 0 gives the largest finite float.
  bool defined = true;
  // How far the vertex is from a place where the equation jumps (the cone of a spot light, n.L = 0
  // with a specular term), as a difference of cosines. Float arithmetic cannot be asked to fall on
  // the right side below a few 1e-7.
  double distance_to_jump = 1;
};

using Result = BasicResult<double>;

template <class Scalar>
BasicResult<Scalar> evaluate_as(const State& state, const Vertex& vertex);

Result evaluate(const State& state, const Vertex& vertex);

extern template BasicResult<double> evaluate_as(const State&, const Vertex&);
extern template BasicResult<long double> evaluate_as(const State&, const Vertex&);
#ifdef ORACLE_HAS_FLOAT128
extern template BasicResult<OracleFloat128> evaluate_as(const State&, const Vertex&);
#endif

}  // namespace oracle
