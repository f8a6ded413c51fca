// Where vertices are. Quads and polygons are plane and convex: how others are drawn is undefined
// (2.6.1).
#include <cmath>
#include <string_view>

#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

constexpr std::size_t longest_polygon = 8;
constexpr std::array<std::pair<double, double>, longest_polygon> circle = {
    {{1, 0.1}, {0.7, 0.75}, {0, 1}, {-0.7, 0.65}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.75, -0.7}}};

double rounded(double value) { return std::round(value * 1000) / 1000; }

void add_polygon(Builder& b, std::vector<Position>& positions, std::size_t corners) {
  const double size = b.random.real(0.1, b.traits.unfilled ? 0.35 : 0.45);
  // Large ones where they may leave the view volume.
  const double scale = b.traits.outside && b.random.chance(40) ? 4 : 1;
  const double x = b.coordinate() / 2;
  const double y = b.coordinate() / 2;
  const double z = b.random.real(-0.9, 0.9);
  const bool turned = b.random.chance(30);
  for (std::size_t i = 0; i < corners; ++i) {
    const auto [cosine, sine] = circle[i * longest_polygon / corners];
    const double across = (turned ? sine : cosine) * size * scale;
    const double up = (turned ? cosine : sine) * size * scale;
    positions.push_back({rounded(x + across), rounded(y + up), z});
  }
}

void add_quad_strip(Builder& b, std::vector<Position>& positions, std::size_t count) {
  const double z = b.random.real(-0.9, 0.9);
  const double y = b.random.real(-0.8, 0.2);
  const double shrink = b.traits.unfilled ? 0.7 : 1;  // D10
  const double step = 1.6 / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = -0.8 + step * static_cast<double>(i / 2 * 2);
    const double height = i % 2 == 0 ? 0 : b.random.real(0.2, 0.6);
    positions.push_back({rounded(x * shrink), rounded((y + height) * shrink), z});
  }
}

}  // namespace

std::vector<Position> positions(Builder& b, std::string_view mode, std::size_t count) {
  std::vector<Position> result;
  while (result.size() < count) {
    if (mode == "GL_QUADS") add_polygon(b, result, 4);
    else if (mode == "GL_POLYGON") add_polygon(b, result, std::min(count, longest_polygon));
    else if (mode == "GL_QUAD_STRIP") add_quad_strip(b, result, count);
    else result.push_back({b.coordinate(), b.coordinate(), b.coordinate()});
    if (mode == "GL_POLYGON") break;
  }
  return result;
}

}  // namespace legacy_gl::fuzz
