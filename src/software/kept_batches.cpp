#include "software/kept_batches.hpp"

#include <algorithm>
#include <utility>

#include "driver/vertex_arrays.hpp"
#include "software/recent_entries.hpp"

namespace legacy_gl {

namespace {

bool same_objects(const std::vector<KeptBatches::Part>& a,
                  const std::vector<KeptBatches::Part>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const KeptBatches::Part& p, const KeptBatches::Part& q) { return p.number == q.number; });
}

}  // namespace

KeptBatches::~KeptBatches() {
  for (Batch& batch : batches_) erase(batch);
}

void KeptBatches::erase(Batch& batch) {
  if (!batch.array) return;
  driver_.DeleteVertexArrays(1, &batch.array);
  driver_.DeleteBuffers(1, &batch.vertex_buffer);
  driver_.DeleteBuffers(1, &batch.index_buffer);
  batch.array = batch.vertex_buffer = batch.index_buffer = 0;
}

bool KeptBatches::begin(const Object& object) {
  const auto at = std::find_if(batches_.begin(), batches_.end(), [&](const Batch& batch) {
    return batch.array && batch.failures < kMostFailures &&
           batch.parts.front().number == object.number;
  });
  if (at == batches_.end()) return false;
  followed_ = &*at;
  followed_->last_used = ++clock_;
  at_ = 1;
  return true;
}

const KeptBatches::Object* KeptBatches::expected() const {
  if (!followed_ || at_ == followed_->parts.size()) return nullptr;
  const std::size_t soon = at_ + 2;
  if (soon < followed_->parts.size()) {
    const auto* const ahead = reinterpret_cast<const char*>(followed_->parts[soon].object);
    for (std::size_t byte = 0; byte < sizeof(Object); byte += 64) __builtin_prefetch(ahead + byte);
  }
  return followed_->parts[at_].object;
}

bool KeptBatches::follow(const Object& object) {
  if (!followed_ || at_ == followed_->parts.size() || followed_->parts[at_].number != object.number)
    return false;
  ++at_;
  return true;
}

KeptBatches::Prefix KeptBatches::stop() {
  Batch& batch = *std::exchange(followed_, nullptr);
  if (at_ == batch.parts.size()) batch.failures = 0;
  else if (at_ < batch.parts.size() / 2) ++batch.failures;
  return {batch, batch.parts[at_ - 1].elements_end};
}

void KeptBatches::note(const Recorder& recorder, const Object& object) {
  const auto added =
      static_cast<std::uint32_t>(object.object.vertices.size() / Recorder::kLitStride);
  const std::uint32_t before = recorder.vertex_count() - added;
  if (before != noted_vertices_) return;  // others lie between
  noted_vertices_ += added;
  parts_.push_back(
      {object.number, &object, static_cast<std::uint32_t>(recorder.elements().size())});
}

void KeptBatches::build(Batch& batch, const Recorder& recorder) {
  erase(batch);
  batch.parts = parts_;
  batch.runs = recorder.runs();
  batch.vertex_count = recorder.vertex_count();
  batch.failures = 0;
  const std::vector<std::uint32_t>& elements = recorder.elements();
  batch.vertex_buffer =
      build_buffer(driver_, GL_ARRAY_BUFFER, recorder.data(),
                   std::size_t{batch.vertex_count} * recorder.offsets().stride * sizeof(float));
  batch.index_buffer = build_buffer(driver_, GL_COPY_WRITE_BUFFER, elements.data(),
                                    elements.size() * sizeof(std::uint32_t));
  batch.array =
      build_vertex_array(driver_, recorder.layout(), batch.vertex_buffer, batch.index_buffer);
}

bool KeptBatches::drawn(const Recorder& recorder) {
  if (parts_.size() < kFewestParts || noted_vertices_ != recorder.vertex_count()) return false;
  auto at = std::find_if(batches_.begin(), batches_.end(), [&](const Batch& batch) {
    return batch.parts.front().number == parts_.front().number;
  });
  if (at != batches_.end() && same_objects(at->parts, parts_)) {
    at->last_used = ++clock_;
    build(*at, recorder);
    return true;
  }
  if (at == batches_.end() && batches_.size() < kMost) {
    at = batches_.emplace(at);
  } else if (at == batches_.end()) {
    at = std::min_element(batches_.begin(), batches_.end(),
                          [](const Batch& a, const Batch& b) { return a.last_used < b.last_used; });
  }
  erase(*at);
  at->parts = parts_;
  at->last_used = ++clock_;
  at->failures = 0;
  return false;
}

}  // namespace legacy_gl
