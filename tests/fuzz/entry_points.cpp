#include "fuzz/entry_points.hpp"

#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace legacy_gl::fuzz {

namespace {

template <typename T>
T as(const Call& call, const Argument& argument, Result& result) {
  using Kind = Argument::Kind;
  if constexpr (!std::is_pointer_v<T>) {
    if (argument.kind != Kind::number)
      throw std::runtime_error("a number belongs here: " + call.text());
    return static_cast<T>(argument.number);
  } else if constexpr (std::is_const_v<std::remove_pointer_t<T>>) {
    if (argument.kind == Kind::address)
      return reinterpret_cast<T>(static_cast<std::intptr_t>(argument.number));
    if (argument.kind != Kind::input)
      throw std::runtime_error("an array belongs here: " + call.text());
    return reinterpret_cast<T>(argument.bytes.data());
  } else {
    if (argument.kind != Kind::output)
      throw std::runtime_error("an output belongs here: " + call.text());
    result.outputs.push_back({argument.element, argument.bytes});
    return reinterpret_cast<T>(result.outputs.back().bytes.data());
  }
}

template <auto member>
struct Invoker;

template <typename R, typename... P, R (LEGACY_GL_APIENTRY* GlFunctions::*member)(P...)>
struct Invoker<member> {
  static void invoke(const GlFunctions& gl, const Call& call, Result& result) {
    if (call.arguments.size() != sizeof...(P))
      throw std::runtime_error("wrong number of arguments: " + call.text());
    with_indices(gl, call, result, std::index_sequence_for<P...>());
  }

 private:
  template <std::size_t... i>
  static void with_indices(const GlFunctions& gl, const Call& call, Result& result,
                           std::index_sequence<i...>) {
    // The driver keeps the addresses of outputs.
    result.outputs.reserve(sizeof...(P));
    if constexpr (std::is_void_v<R>) {
      (gl.*member)(as<P>(call, call.arguments[i], result)...);
    } else {
      result.value = static_cast<double>((gl.*member)(as<P>(call, call.arguments[i], result)...));
      result.returned = true;
    }
  }
};

using Invoke = void (*)(const GlFunctions&, const Call&, Result&);

template <auto member>
constexpr Invoke entry = Invoker<member>::invoke;

const std::map<std::string_view, Invoke> entry_points = {
#include "entry_points.inc"
};

const std::map<std::string_view, std::uint32_t> gl_names = {
#include "gl_names.inc"
};

}  // namespace

void invoke(const GlFunctions& gl, const Call& call, Result& result) {
  const auto found = entry_points.find(call.name);
  if (found == entry_points.end()) throw std::runtime_error("no such call: gl" + call.name);
  found->second(gl, call, result);
}

std::uint32_t gl_name_value(std::string_view name) {
  const auto found = gl_names.find(name);
  if (found == gl_names.end()) throw std::runtime_error("no such name: " + std::string(name));
  return found->second;
}

}  // namespace legacy_gl::fuzz
