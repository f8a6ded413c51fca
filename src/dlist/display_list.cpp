#include "dlist/display_list.hpp"

#include <cstring>
#include <new>

#include "geometry/list_mesh.hpp"
#include "record/record_mesh.hpp"

namespace legacy_gl {

namespace {

struct Header {
  PlayFunction play;
  std::uint64_t payload_words;
};
constexpr std::size_t kHeaderWords = sizeof(Header) / sizeof(std::uint64_t);

void play_mesh(legacy_gl_context& context, const void* payload) {
  draw_mesh(context, **static_cast<const ListMesh* const*>(payload));
}

}  // namespace

void* DisplayList::append(PlayFunction play, std::size_t size) {
  const std::size_t payload_words = (size + 7) / 8;
  const std::size_t at = words_.size();
  words_.resize(at + kHeaderWords + payload_words);
  const Header header{play, payload_words};
  std::memcpy(&words_[at], &header, sizeof header);
  return words_.data() + at + kHeaderWords;
}

void DisplayList::finish() {
  for (const auto& mesh : meshes_) mesh->finish();
}

void DisplayList::append_mesh(std::shared_ptr<ListMesh> mesh) {
  static_assert(sizeof(void*) <= sizeof(std::uint64_t));
  meshes_.push_back(std::move(mesh));
  new (append(&play_mesh, sizeof(std::uint64_t))) const ListMesh*(meshes_.back().get());
}

DisplayList::Command DisplayList::at(std::size_t position) const {
  Header header;
  std::memcpy(&header, &words_[position], sizeof header);
  const std::size_t payload = position + kHeaderWords;
  return {header.play, words_.data() + payload, payload + header.payload_words};
}

void DisplayList::append_copy(std::size_t position) {
  const std::size_t count = at(position).next - position;
  const std::size_t end = words_.size();
  words_.resize(end + count);
  std::memcpy(&words_[end], &words_[position], count * sizeof(std::uint64_t));
}

void DisplayList::execute(legacy_gl_context& context) const {
  for (std::size_t position = 0; position < words_.size();) {
    const Command command = at(position);
    command.play(context, command.payload);
    position = command.next;
  }
}

}  // namespace legacy_gl
