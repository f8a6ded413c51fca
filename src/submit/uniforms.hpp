#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "context/context.hpp"
#include "driver/driver.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

class DrawInputs;
class StreamBuffer;

/// Brings the uniform blocks that changed into the driver's memory. All that go up together share
/// one mapping of the ring.
class UniformUploader {
 public:
  explicit UniformUploader(const Driver& driver);

  /// `general`: the program in use reads the general block.
  void upload(Context& context, DrawInputs& inputs, bool general);

  /// What was on its way stays stale.
  void forget_staged() {
    staged_count_ = 0;
    values_.clear();
  }

 private:
  /// A block's values on their way. It is bound with room for `room` bytes, as programs with longer
  /// arrays ask for.
  struct Staged {
    UniformBlock block;
    std::size_t offset, room;
  };
  void stage_stale(Context& context, DrawInputs& inputs, bool general);
  void stage_lighting(Context& context, DrawInputs& inputs, bool general);
  std::byte* stage(Context& context, DrawInputs& inputs, UniformBlock block, std::size_t size,
                   std::size_t room);
  void stage(Context& context, DrawInputs& inputs, UniformBlock block, const void* data,
             std::size_t size);
  void stage_with_tail(Context& context, DrawInputs& inputs, UniformBlock block, const void* head,
                       std::size_t head_size, const void* tail, std::size_t tail_size,
                       std::size_t room);
  void write_staged(const Driver& driver, StreamBuffer& ring);

  std::size_t alignment_ = 256;
  std::vector<std::byte> values_;
  std::array<Staged, kUniformBlockCount> staged_{};
  unsigned staged_count_ = 0;
};

}  // namespace legacy_gl
