#include "submit/uniforms.hpp"

#include <algorithm>
#include <cstring>

#include "driver/driver_objects.hpp"
#include "translate/draw_inputs.hpp"

namespace legacy_gl {

UniformUploader::UniformUploader(const Driver& driver) {
  GLint alignment = 0;
  driver.GetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  if (alignment > 0) alignment_ = static_cast<std::size_t>(alignment);
}

std::byte* UniformUploader::stage(Context& context, DrawInputs& inputs, UniformBlock block,
                                  std::size_t size, std::size_t room) {
  const std::size_t offset = (values_.size() + alignment_ - 1) / alignment_ * alignment_;
  values_.resize(offset + room);
  staged_[staged_count_++] = {block, offset, room};
  inputs.stale[block] = false;
  context.statistics.uniform_bytes_uploaded += size;
  ++context.statistics.uniform_block_updates;
  return values_.data() + offset;
}

void UniformUploader::stage(Context& context, DrawInputs& inputs, UniformBlock block,
                            const void* data, std::size_t size) {
  std::memcpy(stage(context, inputs, block, size, size), data, size);
}

void UniformUploader::stage_with_tail(Context& context, DrawInputs& inputs, UniformBlock block,
                                      const void* head, std::size_t head_size, const void* tail,
                                      std::size_t tail_size, std::size_t room) {
  const std::size_t size = head_size + tail_size;
  std::byte* const to = stage(context, inputs, block, size, std::max(room, size));
  if (head_size) std::memcpy(to, head, head_size);
  if (tail_size) std::memcpy(to + head_size, tail, tail_size);
}

void UniformUploader::write_staged(const Driver& driver, StreamBuffer& ring) {
  if (staged_count_ == 0) return;
  const std::size_t at = ring.write(values_.data(), values_.size(), alignment_);
  for (unsigned i = 0; i < staged_count_; ++i)
    driver.BindBufferRange(GL_UNIFORM_BUFFER, staged_[i].block, ring.name(),
                           static_cast<GLintptr>(at + staged_[i].offset),
                           static_cast<GLsizeiptr>(staged_[i].room));
  staged_count_ = 0;
  values_.clear();
}

void UniformUploader::upload(Context& context, DrawInputs& inputs, bool general) {
  const Driver& driver = context.driver->functions;
  StreamBuffer& ring = context.driver->uniform_stream;
  const std::uint64_t round = ring.rounds();
  stage_stale(context, inputs, general);
  write_staged(driver, ring);
  if (ring.rounds() == round) return;
  // The ring began anew: blocks that are not stale are bound to memory that is no longer theirs.
  inputs.stale.fill(true);
  stage_stale(context, inputs, general);
  write_staged(driver, ring);
}

void UniformUploader::stage_stale(Context& context, DrawInputs& inputs, bool general) {
  const auto stage_if = [&](bool read, UniformBlock block, const auto& values) {
    if (read && inputs.stale[block]) stage(context, inputs, block, &values, sizeof values);
  };
  const FragmentKey& fragments = inputs.key.fragments;
  stage_if(true, kTransformBlock, inputs.transform);
  stage_if(context.raster.point.is_attenuated_or_fades(), kPointsBlock, inputs.points);
  stage_if(fragments.has_fog() || fragments.has_alpha_test(), kFragmentsBlock, inputs.fragments);
  stage_if(fragments.clip_planes != 0, kClipPlanesBlock, inputs.clip_planes);
  stage_if(context.raster.polygon.stipple_enabled, kPolygonStippleBlock, inputs.polygon_stipple);
  if (inputs.key.textures.count && inputs.stale[kTexturesBlock])
    stage_with_tail(context, inputs, kTexturesBlock, &inputs.textures, sizeof inputs.textures,
                    inputs.texture_units.data(),
                    inputs.texture_units.size() * sizeof(TextureUnitUniforms), 0);
  if (inputs.key.lit) stage_lighting(context, inputs, general);
}

void UniformUploader::stage_lighting(Context& context, DrawInputs& inputs, bool general) {
  if (general && inputs.stale[kGeneralBlock]) {
    inputs.fill_general(context);
    stage(context, inputs, kGeneralBlock, &inputs.general, sizeof inputs.general);
  }
  // Programs that are not made for this number of lights have arrays of a power of two.
  std::size_t capacity = kGeneralLights;
  while (capacity < inputs.lights.size()) capacity *= 2;
  if (inputs.stale[kLightsBlock] && (general || !inputs.lights.empty()))
    stage_with_tail(context, inputs, kLightsBlock, nullptr, 0, inputs.lights.data(),
                    inputs.lights.size() * sizeof(LightUniforms), capacity * sizeof(LightUniforms));
  for (unsigned face = 0; face < (inputs.key.two_side ? 2u : 1u); ++face) {
    if (!inputs.stale[kFrontBlock + face]) continue;
    const FaceUniforms& uniforms = inputs.faces[face];
    stage_with_tail(context, inputs, static_cast<UniformBlock>(kFrontBlock + face), &uniforms.head,
                    sizeof uniforms.head, uniforms.products.data(),
                    uniforms.products.size() * sizeof(LightProducts),
                    sizeof uniforms.head + capacity * sizeof(LightProducts));
  }
  if (inputs.stale[kPreciseBlock] && inputs.key.quality == Quality::kPrecise)
    stage_with_tail(context, inputs, kPreciseBlock, &inputs.precise, sizeof inputs.precise,
                    inputs.lights_low.data(), inputs.lights_low.size() * sizeof(LightLow), 0);
}

}  // namespace legacy_gl
