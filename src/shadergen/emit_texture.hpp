#pragma once
#include "shadergen/emit.hpp"

namespace legacy_gl {

/// The Textures block, where the stage reads it.
void emit_texture_block(Writer& w, const TextureKey& key);
bool vertex_reads_texture_block(const TextureKey& key);
bool fragment_reads_texture_block(const TextureKey& key);

/// The texture coordinates that go from the vertex to the fragment.
void emit_texture_varyings(Writer& w, const TextureKey& key, const std::string& direction);

/// Statements that generate and transform the coordinates (GL 2.1 spec 2.11.2, 2.11.4). Reads
/// `position`, the attributes and, where a coordinate depends on it, `normal`.
void emit_texture_coordinates(Writer& w, const TextureKey& key);
void emit_texture_functions(Writer& w, const TextureKey& key);

void emit_samplers(Writer& w, const TextureKey& key, Dialect dialect);

/// Texture application (GL 2.1 spec 3.8.13 to 3.8.15), unit after unit.
void emit_textures(Writer& w, const TextureKey& key, FragmentColors& colors);

}  // namespace legacy_gl
