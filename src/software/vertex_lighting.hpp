#pragma once
// Lighting as the specialised programs compute it, four vertices at once, on the CPU: for small
// objects, a program of whose state costs more than they do.
#include "translate/draw_inputs.hpp"

namespace legacy_gl {

/// Four vertices, component by component.
struct LightingBlock {
  static constexpr unsigned kVertices = 4;
  alignas(16) float position[3][kVertices];  ///< in object coordinates
  alignas(16) float normal[3][kVertices];    ///< as it was given
  alignas(16) float color[4][kVertices];     ///< the result, clamped
};

/// Whether light_block serves this state: the default quality, materials that are no vertex's own,
/// one colour, positions without a w.
bool lights_blocks(const ProgramKey& key);

/// `derived` holds the values of the state and of `face`.
void light_block(const DrawInputs& derived, unsigned face, LightingBlock& block);

}  // namespace legacy_gl
