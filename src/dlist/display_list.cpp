#include "dlist/display_list.hpp"

#include <cstring>

namespace legacy_gl {

namespace {

struct Command {
  PlayFunction play;
  std::uint64_t payload_words;
};
constexpr std::size_t kHeaderWords = sizeof(Command) / sizeof(std::uint64_t);

}  // namespace

void* DisplayList::append(PlayFunction play, std::size_t size) {
  const std::size_t payload_words = (size + 7) / 8;
  const std::size_t at = words_.size();
  words_.resize(at + kHeaderWords + payload_words);
  const Command command{play, payload_words};
  std::memcpy(&words_[at], &command, sizeof command);
  return words_.data() + at + kHeaderWords;
}

void DisplayList::execute(legacy_gl_context& context) const {
  for (std::size_t at = 0; at < words_.size();) {
    Command command;
    std::memcpy(&command, &words_[at], sizeof command);
    at += kHeaderWords;
    command.play(context, words_.data() + at);
    at += command.payload_words;
  }
}

}  // namespace legacy_gl
