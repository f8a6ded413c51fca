// Random samples of the lighting equation, sorted by feature: what accuracy is measured on.
//
// A class makes batches. A batch is one lighting state and a grid of vertices, each with its own
// position, normal and colour, in ordinary ranges (coordinates of some units, colours of which the
// sum stays near 1). Everything comes from the seed and the batch's number.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"

namespace oracle {

constexpr int batch_side = 32;  // vertices along an edge of the grid
constexpr int batch_size = batch_side * batch_side;

// The object-space x and y of vertex i of a batch lie in cell (i % batch_side, i / batch_side) of a
// grid over [-object_radius, object_radius]^2, so that a fixed orthographic placement gives each
// vertex a pixel of its own, while z, the modelview and the eye-space position are free.
struct Batch {
  State state;
  std::vector<Vertex> vertices;
  float object_radius = 1;
  // Vertex i belongs to a triangle that faces back when (i + batch number) is odd.
  bool alternate_faces = false;
};

struct LightingClass {
  std::string name;
  Batch (*make)(std::uint32_t seed, std::uint32_t number);
};

// In the order in which reports list them.
std::span<const LightingClass> lighting_classes();

}  // namespace oracle
