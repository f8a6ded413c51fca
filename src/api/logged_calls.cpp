// The public entry points: each call is logged where that is asked for (debug/log.hpp), and made
// (plain_names.hpp). The log has functions of its own, so that a call that is not logged has no
// stack frame here.
#include "debug/call_log.hpp"
#include "state/gl_types.hpp"

using namespace legacy_gl::debug;

namespace {

using Kind = Argument::Kind;

// What the log says of a result, beside call_log.hpp's own.
Argument error_code(GLenum value) { return enumerant("ErrorCode", value); }

template <typename Call, typename Text>
auto with_logged_result(Call call, Text text) {
  if constexpr (std::is_void_v<decltype(call())>) {
    call();
  } else {
    const auto result = call();
    log_result(text(result));
    return result;
  }
}

}  // namespace

extern "C" {
// `text` makes the log's words of a result ("nothing" of void is never called).
#define LEGACY_GL_LOGGED_CALL(result, name, parameters, values, text, ...)   \
  result LEGACY_GL_APIENTRY plain_lgl##name parameters;                      \
  [[gnu::cold, gnu::noinline]] static result logged_##name parameters {      \
    log_call("gl" #name, {__VA_ARGS__});                                     \
    return with_logged_result([&] { return plain_lgl##name values; },        \
                              [](auto returned) { return text(returned); }); \
  }                                                                          \
  LEGACY_GL_API result LEGACY_GL_APIENTRY lgl##name parameters {             \
    if (names_calls()) [[unlikely]]                                          \
      return logged_##name values;                                           \
    return plain_lgl##name values;                                           \
  }
#include "api/logged_calls.inc"
#undef LEGACY_GL_LOGGED_CALL
}
