#pragma once
#include "shadergen/program_key.hpp"
#include "shadergen/writer.hpp"

namespace legacy_gl {

/// The key of the general program that draws what `key` draws: which lights there are, the space
/// they are in, how normals and the viewer are treated come from the General block instead of from
/// the text. What decides inputs and varyings, and all that is not lighting, stays in the key.
/// `key` itself where no general program is made: unlit, or lit per fragment.
ProgramKey generalise(const ProgramKey& key);

/// The statements and blocks of a key whose general_lights is not 0; as their namesakes in
/// emit.hpp.
void emit_general_blocks(Writer& w, const ProgramKey& key);
void emit_general_functions(Writer& w);
void emit_general_space(Writer& w, const ProgramKey& key);
void emit_general_lights(Writer& w, const ProgramKey& key);

}  // namespace legacy_gl
