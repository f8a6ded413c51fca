#include "fuzz/minimise.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "fuzz/validity.hpp"

namespace legacy_gl::fuzz {

namespace {

using Clock = std::chrono::steady_clock;
using Index = std::ptrdiff_t;

class Minimiser {
 public:
  Minimiser(Program program, const std::function<bool(const Program&)>& fails, double seconds)
      : program_(std::move(program)),
        fails_(fails),
        end_(Clock::now() +
             std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))) {}

  Program run() {
    bool smaller = true;
    while (smaller && !late()) {
      smaller = remove_chunks();
      smaller |= remove_pairs();
    }
    simplify_numbers();
    return std::move(program_);
  }

 private:
  bool late() const { return Clock::now() > end_; }

  bool try_program(Program candidate) {
    if (late() || !playable(candidate) || !fails_(candidate)) return false;
    program_ = std::move(candidate);
    return true;
  }

  // Delta debugging: halves, quarters … single calls.
  bool remove_chunks() {
    bool smaller = false;
    for (Index size = std::max<Index>(1, std::ssize(program_) / 2); size >= 1; size /= 2) {
      for (Index at = std::ssize(program_) - size; at > -size; at -= size) {
        Program candidate = program_;
        const Index first = std::max<Index>(at, 0);
        const Index last = std::min<Index>(at + size, std::ssize(candidate));
        if (first >= last) continue;
        candidate.erase(candidate.begin() + first, candidate.begin() + last);
        smaller |= try_program(std::move(candidate));
      }
    }
    return smaller;
  }

  // The two calls around a group, which are of no use alone; and the group with them.
  bool remove_pairs() {
    bool smaller = false;
    for (Index at = std::ssize(program_) - 1; at >= 0; --at) {
      if (at >= std::ssize(program_)) continue;
      const Index end = end_of_group(at);
      if (end < 0) continue;
      Program without = program_;
      without.erase(without.begin() + at, without.begin() + end + 1);
      if (try_program(std::move(without))) {
        smaller = true;
        continue;
      }
      Program inside = program_;
      inside.erase(inside.begin() + end);
      inside.erase(inside.begin() + at);
      smaller |= try_program(std::move(inside));
    }
    return smaller;
  }

  Index end_of_group(Index at) const {
    const std::string& opening = program_[static_cast<std::size_t>(at)].name;
    std::string closing;
    if (opening == "Begin") closing = "End";
    if (opening == "NewList") closing = "EndList";
    if (opening.starts_with("Push")) closing = "Pop" + opening.substr(4);
    if (closing.empty()) return -1;
    int depth = 0;
    for (Index i = at; i < std::ssize(program_); ++i) {
      const std::string& here = program_[static_cast<std::size_t>(i)].name;
      depth += here == opening ? 1 : here == closing ? -1 : 0;
      if (depth == 0) return i;
    }
    return -1;
  }

  void simplify_numbers() {
    // Those that may have any value: sizes, strides and factors may not.
    for (std::size_t call = 0; call < program_.size(); ++call)
      for (const char* simple : {"Vertex3", "Vertex2", "Color", "TexCoord", "Translate", "Rect"})
        if (program_[call].name.starts_with(simple) && !program_[call].name.ends_with("Pointer"))
          for (std::size_t i = 0; i < program_[call].arguments.size() && !late(); ++i)
            simplify(call, i);
  }

  void simplify(std::size_t call, std::size_t argument) {
    const Argument& old = program_[call].arguments[argument];
    const bool is_name = old.text.starts_with("GL_");
    if (old.kind != Argument::Kind::number || is_name || old.number == 0 || old.number == 0.5)
      return;
    for (const double value : {0.0, 0.5, std::round(old.number * 10) / 10}) {
      Program candidate = program_;
      candidate[call].arguments[argument] = real(value);
      if (try_program(std::move(candidate))) return;
    }
  }

  Program program_;
  const std::function<bool(const Program&)>& fails_;
  Clock::time_point end_;
};

}  // namespace

Program minimise(Program program, const std::function<bool(const Program&)>& fails,
                 double seconds) {
  return Minimiser(std::move(program), fails, seconds).run();
}

}  // namespace legacy_gl::fuzz
