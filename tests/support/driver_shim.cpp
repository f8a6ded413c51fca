#include "support/driver_shim.hpp"

#include <string>
#include <type_traits>
#include <unordered_map>

#include "driver/driver.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

thread_local DriverObserver* observer = nullptr;

template <typename T>
std::uint64_t bits(T value) {
  std::uint64_t result = 0;
  std::memcpy(&result, &value, sizeof value);
  return result;
}

template <typename Tag, typename Function>
struct Shim;

template <typename Tag, typename Result, typename... Arguments>
struct Shim<Tag, Result (*)(Arguments...)> {
  static Result call(Arguments... arguments) {
    static const auto real =
        reinterpret_cast<Result (*)(Arguments...)>(CoreContext::driver_proc(Tag::kName));
    DriverObserver* const told = observer;
    if (!told) return real(arguments...);
    const DriverCall call{Tag::kName, {bits(arguments)...}};
    if (!told->before(call)) {
      if constexpr (std::is_integral_v<Result>) return static_cast<Result>(told->answer(call));
      else return Result();
    }
    if constexpr (std::is_void_v<Result>) {
      real(arguments...);
      told->after(call);
    } else {
      const Result result = real(arguments...);
      told->after(call);
      return result;
    }
  }
};

using Table = std::unordered_map<std::string, legacy_gl_proc>;

#define LEGACY_GL_TEST_TAG(name, NAME)               \
  struct Tag##name {                                 \
    static constexpr const char* kName = "gl" #name; \
  };
LEGACY_GL_DRIVER_FUNCTIONS(LEGACY_GL_TEST_TAG)
LEGACY_GL_OPTIONAL_DRIVER_FUNCTIONS(LEGACY_GL_TEST_TAG)
#undef LEGACY_GL_TEST_TAG

Table make_table() {
  Table table;
#define LEGACY_GL_TEST_SHIM(name, NAME) \
  table["gl" #name] = reinterpret_cast<legacy_gl_proc>(&Shim<Tag##name, PFNGL##NAME##PROC>::call);
  LEGACY_GL_DRIVER_FUNCTIONS(LEGACY_GL_TEST_SHIM)
  LEGACY_GL_OPTIONAL_DRIVER_FUNCTIONS(LEGACY_GL_TEST_SHIM)
#undef LEGACY_GL_TEST_SHIM
  return table;
}

}  // namespace

legacy_gl_proc shimmed_proc(const char* name) {
  static const Table table = make_table();
  const legacy_gl_proc real = CoreContext::driver_proc(name);
  const auto at = table.find(name);
  return real && at != table.end() ? at->second : real;
}

DriverObserver::DriverObserver() { observer = this; }
DriverObserver::~DriverObserver() { observer = nullptr; }

}  // namespace legacy_gl::test
