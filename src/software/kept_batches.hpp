#pragma once
#include <cstdint>
#include <vector>

#include "driver/driver.hpp"
#include "record/recorder.hpp"
#include "software/kept_objects.hpp"

namespace legacy_gl {

/// Lit batches of kept objects that were drawn twice, in the driver: when the objects come again in
/// the same order nothing of them is recorded. A batch is followed object by object, since it is
/// not known before its end whether the rest will come; what came of it is drawn from its buffers.
class KeptBatches {
 public:
  using Object = KeptObjects::Entry;

  struct Part {
    std::uint64_t number;        ///< the object's
    const Object* object;        ///< which is another one if it has another number
    std::uint32_t elements_end;  ///< of the batch's elements, behind the object's
  };
  struct Batch {
    std::vector<Part> parts;
    std::vector<PrimitiveRun> runs;
    std::uint32_t vertex_count = 0;
    GLuint vertex_buffer = 0, index_buffer = 0, array = 0;  ///< 0: not built
    std::uint64_t last_used = 0;
    unsigned failures = 0;  ///< times in a row that it did not come whole
  };

  explicit KeptBatches(const Driver& driver) : driver_(driver) {}
  ~KeptBatches();
  KeptBatches(const KeptBatches&) = delete;
  KeptBatches& operator=(const KeptBatches&) = delete;

  /// A batch begins with the object. True when it is one to follow.
  bool begin(const Object& object);
  bool is_followed() const { return followed_ != nullptr; }
  /// The object that comes next if all is as it was; nullptr when nobody knows.
  const Object* expected() const;
  /// False when another object was to come: then stop() says what is to be drawn.
  bool follow(const Object& object);
  struct Prefix {
    const Batch& batch;
    std::uint32_t elements_end;
  };
  Prefix stop();

  /// The object was recorded as the batch's last.
  void note(const Recorder& recorder, const Object& object);
  /// The recorder's batch is being drawn. True when it was built: an array of its own is bound.
  bool drawn(const Recorder& recorder);
  /// Another batch begins.
  void forget_noted() {
    parts_.clear();
    noted_vertices_ = 0;
  }

 private:
  static constexpr std::size_t kMost = 64;
  static constexpr std::size_t kFewestParts = 8;

  void build(Batch& batch, const Recorder& recorder);
  void erase(Batch& batch);

  const Driver& driver_;
  std::vector<Batch> batches_;
  Batch* followed_ = nullptr;
  std::size_t at_ = 0;       ///< parts of it that came
  std::vector<Part> parts_;  ///< of the batch that is recorded, while all of them are kept objects
  std::uint32_t noted_vertices_ = 0;
  std::uint64_t clock_ = 0;
};

}  // namespace legacy_gl
