#include "fuzz/judge.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <memory>
#include <stdexcept>

namespace legacy_gl::fuzz {

namespace {

std::map<Dialect, std::unique_ptr<test::RenderContext>> mesa_contexts;

// The same object, with a context that is made anew for each program.
test::RenderContext& mesa_context(Dialect dialect) {
  auto& context = mesa_contexts[dialect];
  if (context) context->recreate();
  else context = make_mesa(dialect);
  return *context;
}

// Programs take milliseconds; compiling their shaders a few hundred, under a sanitizer seconds.
constexpr unsigned longest_program_seconds = 60;

}  // namespace

void close_contexts() { mesa_contexts.clear(); }

std::optional<Difference> Judge::difference(const Mode& mode) {
  auto found = mesa_.find(mode.dialect);
  if (found == mesa_.end())
    found = mesa_.emplace(mode.dialect, play(mesa_context(mode.dialect), program_, frames_)).first;
  const auto context = make_ours(mode);
  return compare(program_, play(*context, program_, frames_), found->second);
}

std::optional<Difference> difference_in_child(const Program& program, const Mode& mode) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    alarm(longest_program_seconds);
    _exit(Judge(program).difference(mode) ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    return Difference{WTERMSIG(status) == SIGALRM ? "hang" : "crash",
                      "signal " + std::to_string(WTERMSIG(status))};
  // A sanitizer ends the process with another status than those above.
  if (WEXITSTATUS(status) > 1)
    return Difference{"crash", "status " + std::to_string(WEXITSTATUS(status))};
  if (WEXITSTATUS(status) == 1) return Difference{"difference", ""};
  return std::nullopt;
}

}  // namespace legacy_gl::fuzz
