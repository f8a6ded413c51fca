#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

struct legacy_gl_context;

namespace legacy_gl {

struct ListMesh;

using PlayFunction = void (*)(legacy_gl_context&, const void* payload);

/// Commands one after the other: the function that plays one, the size of what it is given, and
/// that.
class DisplayList {
 public:
  struct Command {
    PlayFunction play;
    const void* payload;
    std::size_t next;  ///< where the command after it is
  };

  /// Room for a command's payload, 8-byte aligned. The address holds until the next append.
  void* append(PlayFunction play, std::size_t size);
  /// Lives as long as the list: what a payload points to.
  void keep(std::shared_ptr<const void> object) { kept_.push_back(std::move(object)); }
  void append_mesh(std::shared_ptr<ListMesh> mesh);
  /// The list is complete.
  void finish();
  void execute(legacy_gl_context& context) const;

  std::size_t size() const { return words_.size(); }
  Command at(std::size_t position) const;
  /// The command at `position`, whole, at the end again.
  void append_copy(std::size_t position);
  /// Takes out the commands from `begin` up to `end`.
  void erase(std::size_t begin, std::size_t end) {
    const auto at = [this](std::size_t i) {
      return words_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    words_.erase(at(begin), at(end));
  }

 private:
  std::vector<std::uint64_t> words_;
  std::vector<std::shared_ptr<const void>> kept_;
  std::vector<std::shared_ptr<ListMesh>> meshes_;
};

}  // namespace legacy_gl
