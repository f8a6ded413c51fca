#include "software/repeated_batches.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "geometry/surface.hpp"
#include "software/hidden_sides.hpp"

namespace legacy_gl {

namespace {

/// So many vertices at each end of a part tell it from others.
constexpr std::uint32_t kTellingVertices = 32;

/// Closed surfaces alone are kept: the vertices hold what the state reads, and all are polygons.
bool is_worthwhile(const Context& context) {
  const Recorder& recorder = context.recorder;
  const VertexLayout& layout = recorder.layout();
  constexpr unsigned kKept = kFieldNormal | kFieldColor | kFieldSecondaryColor | kFieldFogCoord;
  if (recorder.vertex_count() < kWorthwhileSurface || layout.fields & ~kKept) return false;
  if (layout != Recorder::relevant_layout(context) || !shows_nearest_alone(context)) return false;
  const std::vector<PrimitiveRun>& runs = recorder.runs();
  return std::all_of(runs.begin(), runs.end(), [](const PrimitiveRun& run) {
    // How quads are split depends on the view.
    return !run.indexed && !run.apart && run.mode >= GL_TRIANGLES && run.mode != GL_QUADS;
  });
}

std::uint64_t hash_of(const Recorder& recorder) {
  const std::size_t bytes = recorder.offsets().stride * sizeof(float);
  const std::uint32_t count = recorder.vertex_count();
  const auto* const data = reinterpret_cast<const char*>(recorder.data());
  const std::hash<std::string_view> hash;
  return hash({data, kTellingVertices * bytes}) * 31 +
         hash({data + (count - kTellingVertices) * bytes, kTellingVertices * bytes}) + count +
         recorder.runs().front().mode * 31u;
}

}  // namespace

RepeatedBatches::Phase RepeatedBatches::begin(const Context& context) {
  if (!is_worthwhile(context)) return Phase::kNone;
  Entry fresh;
  fresh.hash = hash_of(context.recorder);
  entry_ =
      &entries_.find_or_add([&](const Entry& entry) { return entry.hash == fresh.hash; }, fresh);
  if (entry_->failures >= kMostFailures) {
    entry_->mesh.reset();
    return Phase::kIgnoring;
  }
  vertices_ = 0;
  runs_ = 0;
  if (entry_->mesh) return Phase::kComparing;
  if (++entry_->seen < kCopiesWhenMet) return Phase::kIgnoring;
  copied_ = std::make_shared<ListMesh>();
  copied_->layout = context.recorder.layout();
  return Phase::kCopying;
}

RepeatedBatches::Answer RepeatedBatches::compare(const Context& context, bool last) {
  const Recorder& recorder = context.recorder;
  const ListMesh& mesh = *entry_->mesh;
  const std::uint32_t count = recorder.vertex_count(), rest = mesh.vertex_count() - vertices_;
  const std::vector<PrimitiveRun>& runs = recorder.runs();
  const std::size_t stride = recorder.offsets().stride;
  const auto same_run = [this](const PrimitiveRun& run, const PrimitiveRun& kept) {
    return run.mode == kept.mode && run.first + vertices_ == kept.first &&
           run.count == kept.count && !run.indexed && !run.apart;
  };
  const bool same = mesh.layout == recorder.layout() && (last ? count == rest : count <= rest) &&
                    runs.size() <= mesh.runs.size() - runs_ &&
                    std::equal(runs.begin(), runs.end(),
                               mesh.runs.begin() + static_cast<std::ptrdiff_t>(runs_), same_run) &&
                    std::memcmp(recorder.data(), mesh.vertices.data() + vertices_ * stride,
                                count * stride * sizeof(float)) == 0;
  if (!same) {
    ++entry_->failures;
    return Answer::kDifferent;
  }
  vertices_ += count;
  runs_ += runs.size();
  if (last) entry_->failures = 0;
  return last ? Answer::kComplete : Answer::kHeld;
}

void RepeatedBatches::copy(const Context& context, bool last) {
  const Recorder& recorder = context.recorder;
  const std::size_t floats = recorder.vertex_count() * std::size_t{recorder.offsets().stride};
  if (copied_->layout != recorder.layout() ||
      copied_->vertices.size() + floats > RecentEntries<Entry>::kMostFloats) {
    ++entry_->failures;
    phase_ = Phase::kIgnoring;
    return;
  }
  const std::uint32_t base = copied_->vertex_count();
  copied_->vertices.insert(copied_->vertices.end(), recorder.data(), recorder.data() + floats);
  for (PrimitiveRun run : recorder.runs()) {
    run.first += base;
    copied_->runs.push_back(run);
  }
  if (!last) return;
  copied_->finish();
  auto surface = std::make_shared<Surface>(find_surface(*copied_));
  if (surface->winding == Surface::Winding::kOpen) {
    entry_->failures = kMostFailures;
    return;
  }
  copied_->surface = std::move(surface);
  copied_->draw_runs();
  entry_->mesh = std::move(copied_);
  entries_.make_room();
}

RepeatedBatches::Answer RepeatedBatches::take(const Context& context, bool last) {
  if (phase_ == Phase::kNone) phase_ = begin(context);
  Answer answer = Answer::kDraw;
  if (phase_ == Phase::kComparing) answer = compare(context, last);
  else if (phase_ == Phase::kCopying) copy(context, last);
  if (answer == Answer::kDifferent) phase_ = Phase::kIgnoring;
  if (last) {
    phase_ = Phase::kNone;
    copied_.reset();
  }
  return answer;
}

}  // namespace legacy_gl
