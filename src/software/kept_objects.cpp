#include "software/kept_objects.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "submit/backend.hpp"

namespace legacy_gl {

namespace {

/// Bit for bit: what is rounded in another way, and -0 in place of 0, is something else.
template <typename T>
bool same_bits(const T& a, const T& b) {
  const void *const first = &a, *const second = &b;
  return std::memcmp(first, second, sizeof(T)) == 0;
}
static_assert(sizeof(Matrix) == 16 * (sizeof(float) + sizeof(double)));
static_assert(sizeof(Materials) == 40 * sizeof(float));
static_assert(sizeof(MatrixOperation) == 5 * sizeof(float));

bool same_bits(std::span<const MatrixOperation> a, std::span<const MatrixOperation> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

class Hash {
 public:
  template <typename T>
  void add(const T& value) {
    constexpr std::size_t kWord = 4;
    static_assert(sizeof(T) % kWord == 0);
    std::array<std::uint32_t, sizeof(T) / kWord> words;
    std::memcpy(words.data(), &value, sizeof(T));
    for (const std::uint32_t word : words) {
      // Two chains, so that neither waits for each product.
      std::swap(even_, odd_);
      even_ = (even_ ^ word) * kFactor;
      even_ ^= even_ >> 32;
    }
  }
  std::uint64_t value() const { return (even_ ^ odd_ * 3) * kFactor; }

 private:
  static constexpr std::uint64_t kFactor = 0x9e3779b97f4a7c15u;
  std::uint64_t even_ = 1, odd_ = 2;
};

/// Of what differs between most objects.
std::uint64_t hash_of(const KeptObjects::Key& key) {
  Hash hash;
  hash.add(reinterpret_cast<std::uintptr_t>(&key.mesh));
  hash.add(key.surroundings);
  hash.add(key.modelview.base.single);
  for (const MatrixOperation& operation : key.modelview.operations) hash.add(operation);
  hash.add(key.materials[kFront].diffuse);
  return hash.value();
}

/// Bits that are raised where more than the matrix and the material may have changed.
constexpr std::uint32_t kOfAll = ~std::uint32_t{kDirtyTransform | kDirtyMaterial};

/// What changes under the other two bits.
bool same_view(const ObjectSurroundings& s, const Context& context) {
  return s.light_model == context.lighting.model &&
         s.normalize == context.transform.normalize_enabled &&
         s.rescale_normal == context.transform.rescale_normal_enabled &&
         s.query_active == (context.backend->queries().active() != 0) &&
         same_bits(s.projection, context.transform.projection.top().single);
}

bool same_rest(const ObjectSurroundings& s, const Context& context,
               const FramebufferFacts& framebuffer) {
  return s.framebuffer == framebuffer && s.lights == context.lighting.lights &&
         s.shade_model == context.lighting.shade_model &&
         s.clip_planes == (context.transform.clip.enabled != 0) && s.raster == context.raster;
}

ObjectSurroundings surroundings_of(const Context& context, const FramebufferFacts& framebuffer) {
  return {.lights = context.lighting.lights,
          .light_model = context.lighting.model,
          .shade_model = context.lighting.shade_model,
          .normalize = context.transform.normalize_enabled,
          .rescale_normal = context.transform.rescale_normal_enabled,
          .clip_planes = context.transform.clip.enabled != 0,
          .query_active = context.backend->queries().active() != 0,
          .projection = context.transform.projection.top().single,
          .raster = context.raster,
          .framebuffer = framebuffer};
}

}  // namespace

std::uint32_t SurroundingsNumbers::number_of(const Context& context,
                                             const FramebufferFacts& framebuffer,
                                             std::uint32_t changed) {
  if (!entries_.empty() && !(changed & kOfAll) &&
      same_view(entries_[current_].surroundings, context))
    return entries_[current_].number;
  const auto at = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return same_view(entry.surroundings, context) &&
           same_rest(entry.surroundings, context, framebuffer);
  });
  current_ = static_cast<std::size_t>(at - entries_.begin());
  if (at != entries_.end()) return at->number;
  if (entries_.size() == kMost)
    current_ = static_cast<std::size_t>(
        std::min_element(entries_.begin(), entries_.end(),
                         [](const Entry& a, const Entry& b) { return a.number < b.number; }) -
        entries_.begin());
  else entries_.emplace_back();
  entries_[current_] = {++last_number_, surroundings_of(context, framebuffer)};
  return last_number_;
}

bool KeptObjects::Entry::equals(const Key& key) const {
  return number && surroundings == key.surroundings &&
         same_bits(modelview_base, key.modelview.base) &&
         same_bits({operations.data(), operation_count}, key.modelview.operations) &&
         same_bits(materials, key.materials) && address == &key.mesh && !mesh.expired();
}

void KeptObjects::Entry::set_key(const Key& key) {
  address = &key.mesh;
  mesh = key.mesh.weak_from_this();
  surroundings = key.surroundings;
  modelview_base = key.modelview.base;
  operation_count = key.modelview.operations.size();
  std::copy(key.modelview.operations.begin(), key.modelview.operations.end(), operations.begin());
  materials = key.materials;
}

const KeptObjects::Entry* KeptObjects::find(const Key& key, const Entry* expected) {
  if (expected && expected->equals(key)) return expected;
  wanted_ = nullptr;
  if (pause_) {
    --pause_;
    return nullptr;
  }
  if (slots_.empty()) slots_.resize(kSlotsOfAHash << kHashBits);
  const std::uint64_t hash = hash_of(key);
  const auto first =
      slots_.begin() + static_cast<std::ptrdiff_t>((hash >> (64 - kHashBits)) * kSlotsOfAHash);
  const auto end = first + kSlotsOfAHash;
  auto slot = std::find_if(first, end, [=](const Slot& s) { return s.hash == hash; });
  const bool met = slot != end;
  if (!met) {
    slot = std::min_element(first, end,
                            [](const Slot& a, const Slot& b) { return a.last_used < b.last_used; });
    slot->hash = hash;
  }
  slot->last_used = ++clock_;
  missed_ = met ? 0 : missed_ + 1;
  if (missed_ == kMissedInVain) {
    missed_ = 0;
    pause_ = kPause;
  }
  if (met && slot->entry && slot->entry->equals(key)) return slot->entry.get();
  if (!met) return nullptr;
  if (!slot->entry) slot->entry = std::make_unique<Entry>();
  wanted_ = slot->entry.get();
  wanted_->number = 0;
  wanted_->set_key(key);
  return nullptr;
}

void KeptObjects::keep(const Facts& facts, std::span<const float> vertices,
                       std::span<const std::uint32_t> elements, std::uint32_t base) {
  floats_ -= wanted_->floats();
  wanted_->number = ++last_number_;
  Object& object = wanted_->object;
  object.facts = facts;
  object.vertices.assign(vertices.begin(), vertices.end());
  object.elements.clear();
  for (const std::uint32_t element : elements)
    object.elements.push_back(static_cast<std::uint16_t>(element - base));
  floats_ += wanted_->floats();
  if (floats_ > kMostFloats) make_room();
}

/// All but the last are given up: those that still come return.
void KeptObjects::make_room() {
  for (Slot& slot : slots_)
    if (slot.entry && slot.entry.get() != wanted_) *slot.entry = Entry{};
  floats_ = wanted_->floats();
}

}  // namespace legacy_gl
