// Client arrays that lie in buffer objects in a form that the core profile takes: drawn from where
// they are.
#include "submit/arrays_direct.hpp"

#include <algorithm>
#include <array>

#include "geometry/clip_test.hpp"
#include "geometry/primitives.hpp"
#include "shadergen/attributes.hpp"
#include "submit/constant_attributes.hpp"
#include "submit/prepare.hpp"
#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

/// An array that the state may make relevant, and where the programs expect it.
struct Source {
  unsigned array;
  unsigned location;
  std::uint16_t field = 0;  ///< of VertexLayout; 0 for positions and texture coordinates
};

/// The arrays that `layout` asks for, the positions first.
template <typename Visit>
void for_each_source(const VertexLayout& layout, Visit visit) {
  visit(Source{kVertexArray, kLocationPosition});
  if (layout.fields & kFieldNormal) visit(Source{kNormalArray, kLocationNormal, kFieldNormal});
  if (layout.fields & kFieldColor) visit(Source{kColorArray, kLocationColor, kFieldColor});
  if (layout.fields & kFieldSecondaryColor)
    visit(Source{kSecondaryColorArray, kLocationSecondaryColor, kFieldSecondaryColor});
  if (layout.fields & kFieldFogCoord)
    visit(Source{kFogCoordArray, kLocationFogCoord, kFieldFogCoord});
  if (layout.texcoords)
    for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
      if (layout.texcoords & 1u << unit)
        visit(Source{kTexCoordArray + unit, texcoord_location(unit)});
}

/// What the driver would fetch is what the specification of OpenGL 1.5 says. Drivers differ in how
/// they normalise signed integers: (2c + 1) / (2^b - 1) of GL 2.1 table 2.9, or the later c /
/// (2^(b-1) - 1).
bool driver_fetches(const Driver& driver, unsigned array, GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_SHORT:
    case GL_INT: return !is_normalised(array);
    case GL_DOUBLE: return !driver.is_es();
    default: return true;
  }
}

/// The attributes of the arrays that matter; nothing when one of them cannot be drawn from where it
/// is.
std::optional<BufferAttributes> find_attributes(Context& context, const VertexLayout& layout,
                                                const ArrayDraw& draw) {
  BufferAttributes found;
  bool drawable = true;
  for_each_source(layout, [&](const Source& source) {
    const ClientArray& array = context.arrays.arrays[source.array];
    if (!array.enabled || !drawable) return;
    const BufferObject* const buffer = array.buffer.get();
    drawable = buffer && driver_fetches(context.driver->functions, source.array, array.type);
    if (!drawable) return;
    const ArrayView view = make_view(array, nullptr);
    const std::uint64_t offset = reinterpret_cast<std::uintptr_t>(array.pointer);
    const std::uint64_t end = offset + (std::uint64_t{draw.first} + draw.count - 1) * view.stride +
                              std::uint64_t{view.size} * type_size(view.type);
    // What a draw reads past the end is the driver's business, and not every driver's is harmless.
    drawable = draw.is_indexed() || end <= static_cast<std::uint64_t>(buffer->size);
    if (!drawable) return;
    found.add({source.location, buffer->driver_name.get(), buffer->serial, array.size, array.type,
               array.stride, is_normalised(source.array), array.pointer});
  });
  if (!drawable) return {};
  return found;
}

/// Whether clipping cuts one of these quads.
bool is_cut(const ArrayDraw& draw, ReadableArrays& arrays, const DrawInputs& inputs) {
  if (draw.mode != GL_QUADS || draw.is_indexed()) return false;
  const ArrayView& positions = arrays.views()[kVertexArray];
  constexpr std::uint32_t kBlock = 256;
  std::array<float, 4 * kBlock> block;
  const ReadFunction read = find_reader(positions.type, false, positions.size, 4);
  const EnabledClipPlanes planes(inputs);
  for (std::uint32_t done = 0; done < draw.count; done += kBlock) {
    const std::uint32_t count = std::min(kBlock, draw.count - done);
    positions.read(read, draw.first + done, count, block.data(), 4, 4);
    if (any_outside(inputs.transform.modelview_projection, planes, block.data(), count, 4, true))
      return true;
  }
  return false;
}

/// What the layout asks for and no array gives.
void set_attributes_without_array(const Context& context, const VertexLayout& layout) {
  unsigned fields = 0, texcoords = 0;
  for_each_source(layout, [&](const Source& source) {
    if (context.arrays.arrays[source.array].enabled) return;
    fields |= source.field;
    if (source.array >= kTexCoordArray) texcoords |= 1u << (source.array - kTexCoordArray);
  });
  set_constant_attributes(context, static_cast<std::uint16_t>(fields), texcoords);
}

/// What the state reads, as the arrays have it.
VertexLayout layout_of_arrays(const Context& context) {
  VertexLayout layout = Recorder::relevant_layout(context);
  if (context.arrays.arrays[kVertexArray].size == 4) layout.fields |= kFieldPositionW;
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit) {
    const ClientArray& array = context.arrays.arrays[kTexCoordArray + unit];
    if (!(layout.texcoords & 1u << unit) || !array.enabled) continue;
    const auto bit = static_cast<std::uint8_t>(1u << unit);
    layout.wide_texcoords &= static_cast<std::uint8_t>(~bit);
    if (array.size > 2) layout.wide_texcoords |= bit;
  }
  return layout;
}

const BufferObject* element_buffer(Context& context, const ArrayDraw& draw) {
  return draw.is_indexed() ? context.arrays.element_buffer.get() : nullptr;
}

}  // namespace

std::optional<DirectArrays> find_direct_arrays(Context& context, const ArrayDraw& draw) {
  const VertexLayout layout = layout_of_arrays(context);
  std::optional<BufferAttributes> attributes = find_attributes(context, layout, draw);
  if (!attributes) return {};
  const BufferObject* const elements = element_buffer(context, draw);
  if (elements && reinterpret_cast<std::uintptr_t>(draw.elements) +
                          std::uint64_t{draw.count} * type_size(draw.element_type) >
                      static_cast<std::uint64_t>(elements->size))
    return {};
  return DirectArrays{layout, *attributes};
}

void draw_arrays_direct(Context& context, const ArrayDraw& draw, DirectArrays arrays) {
  DriverObjects& objects = *context.driver;
  const Driver& driver = context.driver->functions;
  Submission& submission = *context.submission;
  const bool native = draws_without_indices(draw.mode);
  const BufferObject* const elements = element_buffer(context, draw);
  if (draw.is_indexed() && !elements && !draw.elements) return;
  prepare(context, arrays.layout);
  if (!use_program(context, draw.mode, draw.count)) return;
  const bool indices_lie_there = elements && native;
  arrays.attributes.index_buffer =
      indices_lie_there ? elements->driver_name.get() : objects.index_stream.name();
  arrays.attributes.index_serial = indices_lie_there ? elements->serial : 0;
  context.driver->bind_vertex_array(objects.buffer_arrays.find_or_build(arrays.attributes));
  set_attributes_without_array(context, arrays.layout);

  GLsizei count = static_cast<GLsizei>(draw.count);
  GLenum type = draw.element_type;
  const void* offset = draw.elements;
  if (!native) {
    ReadableArrays readable(context);
    // As quads of Begin/End are, where a look at the positions does not cost a GPU's memory.
    const bool splits =
        submission.inputs.key.flat || (context.driver->functions.traits.rasterises_on_cpu &&
                                       is_cut(draw, readable, submission.inputs));
    submission.elements.clear();
    if (draw.is_indexed()) read_elements(readable.elements(draw), submission.elements);
    const auto available =
        draw.is_indexed() ? static_cast<std::uint32_t>(submission.elements.size()) : draw.count;
    submission.indices.clear();
    append_indices({draw.mode, draw.first, available, draw.is_indexed()}, submission.elements, 0,
                   splits, submission.indices);
    count = static_cast<GLsizei>(submission.indices.size());
    type = GL_UNSIGNED_INT;
    offset = write_indices(context, submission.indices.data(),
                           submission.indices.size() * sizeof(std::uint32_t));
  } else if (draw.is_indexed() && !elements) {
    offset = write_indices(context, draw.elements, draw.count * std::size_t{type_size(type)});
  }
  if (draw.is_indexed() || !native) driver.DrawElements(core_mode(draw.mode), count, type, offset);
  else driver.DrawArrays(draw.mode, static_cast<GLint>(draw.first), count);
  ++context.statistics.draws;
  ++context.statistics.batches;
  context.statistics.vertices += draw.count;
}

}  // namespace legacy_gl
