#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

struct legacy_gl_context;

namespace legacy_gl {

using PlayFunction = void (*)(legacy_gl_context&, const void* payload);

/// Commands one after the other: the function that plays one, the size of what it is given, and that.
class DisplayList {
 public:
  /// Room for a command's payload, 8-byte aligned. The address holds until the next append.
  void* append(PlayFunction play, std::size_t size);
  void execute(legacy_gl_context& context) const;
  bool empty() const { return words_.empty(); }

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace legacy_gl
