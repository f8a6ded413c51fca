#include "execute/eval_coord.hpp"

#include <glm/geometric.hpp>

#include "execute/attributes.hpp"

namespace legacy_gl {

namespace {

/// GL_AUTO_NORMAL: the cross product of the derivatives, made unit length; of a homogeneous vertex
/// those of x/w, y/w and z/w.
glm::vec3 surface_normal(const Evaluated& vertex, bool homogeneous) {
  glm::dvec3 du, dv;
  for (int c = 0; c < 3; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const auto by = [&](const std::array<float, 4>& derivative) {
      const auto d = static_cast<double>(derivative[i]);
      if (!homogeneous) return d;
      return d * static_cast<double>(vertex.value[3]) -
             static_cast<double>(derivative[3]) * static_cast<double>(vertex.value[i]);
    };
    du[c] = by(vertex.du);
    dv[c] = by(vertex.dv);
  }
  const glm::dvec3 normal = glm::cross(du, dv);
  const double length = glm::length(normal);
  return length > 0 ? glm::vec3(normal / length) : glm::vec3(normal);
}

class Evaluation {
 public:
  Evaluation(Context& context, unsigned dimensions, float u, float v)
      : state_(context.evaluators), dimensions_(dimensions), u_(u), v_(v) {}

  bool enabled(unsigned map) const { return state_.modes.enabled[dimensions_ - 1] >> map & 1; }
  Evaluated at(unsigned map) const {
    return evaluate(state_.maps[dimensions_ - 1][map], map_components(map), u_, v_);
  }

 private:
  const EvaluatorState& state_;
  unsigned dimensions_;
  float u_, v_;
};

}  // namespace

void eval_coord(Context& context, unsigned dimensions, float u, float v) {
  const Evaluation evaluation(context, dimensions, u, v);
  const bool vertex4 = evaluation.enabled(kMapVertex4);
  if (!vertex4 && !evaluation.enabled(kMapVertex3)) return;
  const Evaluated vertex = evaluation.at(vertex4 ? kMapVertex4 : kMapVertex3);

  CurrentValues& current = context.current;
  const glm::vec4 color = current.color, texcoord = current.texture_coordinates[0];
  const glm::vec3 normal = current.normal;
  if (evaluation.enabled(kMapColor4)) {
    const auto [r, g, b, a] = evaluation.at(kMapColor4).value;
    execute::color4(context, r, g, b, a);
  }
  if (dimensions == 2 && context.evaluators.modes.auto_normal) {
    current.normal = surface_normal(vertex, vertex4);
  } else if (evaluation.enabled(kMapNormal)) {
    const auto [x, y, z, unused] = evaluation.at(kMapNormal).value;
    execute::normal3(context, x, y, z);
  }
  for (unsigned map = kMapTexcoord4; map >= kMapTexcoord1; --map)
    if (evaluation.enabled(map)) {  // the one of the most coordinates
      const auto [s, t, r, q] = evaluation.at(map).value;
      execute::texcoord4(context, 0, s, t, r, q);
      break;
    }
  const auto [x, y, z, w] = vertex.value;
  if (vertex4) execute::vertex4(context, x, y, z, w);
  else execute::vertex3(context, x, y, z);
  current.color = color;
  current.normal = normal;
  current.texture_coordinates[0] = texcoord;
}

}  // namespace legacy_gl
