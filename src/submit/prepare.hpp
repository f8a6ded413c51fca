#pragma once
// What every draw does first: brings the driver up to the context's state.
#include "context/context.hpp"
#include "driver/framebuffer_facts.hpp"
#include "submit/submission.hpp"

namespace legacy_gl {

/// Brings submission.inputs up to the state, for vertices of `layout`.
void update_inputs(Context& context, const VertexLayout& layout, const DrawFacts& facts = {});
/// Brings the driver up to submission.inputs: uniform blocks, raster state, textures.
void apply_inputs(Context& context);
/// Both.
void prepare(Context& context, const VertexLayout& layout);

/// Brings blend, depth, masks, viewport and their like in the driver up to the context's.
void apply_raster(Context& context);

/// Makes the program current that primitives of `mode` need, or that of the key. `vertices`: how
/// many it draws. False when the driver has refused it.
bool use_program(Context& context, GLenum mode, std::uint64_t vertices);
bool use_program(Context& context, const ProgramKey& key, std::uint64_t vertices);
/// Makes `key` one that draws points.
void choose_points(const Context& context, ProgramKey& key);

/// What the driver says of the framebuffer, asked once.
const FramebufferFacts& framebuffer_facts(const Context& context);

/// Lines are made wide here, because the driver draws thin ones alone.
bool widens_lines(const Context& context);
/// Lines are drawn as others, made here: wide or stippled.
bool replaces_lines(const Context& context);

/// Copies indices to the driver's memory; the offset, as glDrawElements takes it.
const void* write_indices(Context& context, const void* indices, std::size_t size);

/// Others have used the driver: nothing that is bound or set is known.
void forget_driver_state(Context& context);

/// Deletes in the driver what no context has any more. The driver context is current.
void free_deleted(Context& context);

/// The text of both stages of the program that polygons are drawn with in the present state.
std::string program_source(Context& context);

}  // namespace legacy_gl
