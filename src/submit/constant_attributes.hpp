#pragma once
#include <cstdint>

#include "context/context.hpp"

namespace legacy_gl {

/// Attributes that the vertices of a draw do not hold: `fields` of VertexLayout, and the texture
/// coordinates of these units. Each vertex has the current value.
void set_constant_attributes(const Context& context, std::uint16_t fields, unsigned texcoords);

}  // namespace legacy_gl
