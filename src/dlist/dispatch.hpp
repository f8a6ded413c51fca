#pragma once
// Every command that a display list can hold passes here: it is executed, recorded, or both.
#include <new>
#include <tuple>
#include <type_traits>

#include "context/context.hpp"
#include "dlist/list_state.hpp"

namespace legacy_gl {

/// The same while calls are executed at once; nullptr while a list is being compiled, or where
/// calls are told (debug/log.hpp). One test of it is all that a call passes on its way.
extern constinit thread_local Context* direct_context;

/// Brings direct_context up to date: after a list is begun or ended, and while one is played.
void update_direct_context();

template <auto Execute, typename... Args>
void play(Context& context, const void* payload) {
  std::apply([&context](const Args&... args) { Execute(context, args...); },
             *static_cast<const std::tuple<Args...>*>(payload));
}

/// In a handler: raises GL_OUT_OF_MEMORY. What was under way may have ended anywhere, so that what
/// is recorded and not drawn, and all that can be derived again, is forgotten.
void recover_from_exception(Context& context) noexcept;

/// Calls `action`. No exception leaves the library: what it throws, for lack of memory, becomes
/// GL_OUT_OF_MEMORY (GL 2.1 spec 2.5). Costs nothing where nothing is thrown.
template <typename Action>
[[gnu::always_inline]] inline auto guarded(Context& context, Action action) -> decltype(action()) {
  try {
    return action();
  } catch (...) {
    recover_from_exception(context);
  }
  if constexpr (!std::is_void_v<decltype(action())>) return {};
}

/// For entry points that do more than one dispatch: calls `action(context)`.
template <typename Action>
void with_context(Action action) {
  Context* const context = current_context;
  if (!context) return report_no_context();
  guarded(*context, [&] { action(*context); });
}

template <auto Execute, typename... Args>
[[gnu::noinline]] void record(const Args&... args) {
  Context* const context = current_context;
  if (!context) return report_no_context();
  guarded(*context, [&] {
    if (!context->list_modes.compiling) return Execute(*context, args...);  // its call is told
    using Payload = std::tuple<Args...>;
    if (!context->lists.failed) {
      void* const payload = context->lists.append(&play<Execute, Args...>, sizeof(Payload));
      new (payload) Payload(args...);
    }
    if (context->list_modes.mode != GL_COMPILE) Execute(*context, args...);
  });
}

/// Records Execute(args...) in the list being compiled; executes it unless the mode is GL_COMPILE.
/// The arguments are values: a command that takes a pointer copies what it points to first (GL 2.1
/// spec 5.4).
template <auto Execute, typename... Args>
inline void dispatch(const Args&... args) {
  static_assert((std::is_trivially_copyable_v<Args> && ...));
  if (Context* const context = direct_context) [[likely]]
    return guarded(*context, [&] { Execute(*context, args...); });
  record<Execute>(args...);
}

/// For commands that no list holds: executes at once.
template <auto Execute, typename... Args>
inline auto execute_now(Args... args) -> decltype(Execute(*current_context, args...)) {
  using Result = decltype(Execute(*current_context, args...));
  Context* const context = current_context;
  if (!context) [[unlikely]] {
    report_no_context();
    if constexpr (!std::is_void_v<Result>) return Result{};
    else return;
  }
  return guarded(*context, [&] { return Execute(*context, args...); });
}

}  // namespace legacy_gl
