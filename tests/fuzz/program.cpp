#include "fuzz/program.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "fuzz/entry_points.hpp"

namespace legacy_gl::fuzz {

namespace {

using Bytes = std::vector<std::byte>;

template <typename T>
void append(Bytes& bytes, double value) {
  const T element = static_cast<T>(value);
  const auto* first = reinterpret_cast<const std::byte*>(&element);
  bytes.insert(bytes.end(), first, first + sizeof element);
}

template <typename T>
void read(std::vector<double>& values, const Bytes& bytes) {
  for (std::size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
    T element;
    std::memcpy(&element, bytes.data() + at, sizeof element);
    values.push_back(static_cast<double>(element));
  }
}

struct Element {
  std::string_view name;
  std::size_t size;
  void (*append)(Bytes&, double);
  void (*read)(std::vector<double>&, const Bytes&);
};

template <typename T>
constexpr Element element_type(std::string_view name) {
  return {name, sizeof(T), append<T>, read<T>};
}

constexpr std::array elements = {
    element_type<std::int8_t>("GLbyte"),    element_type<std::uint8_t>("GLubyte"),
    element_type<std::int16_t>("GLshort"),  element_type<std::uint16_t>("GLushort"),
    element_type<std::int32_t>("GLint"),    element_type<std::uint32_t>("GLuint"),
    element_type<float>("GLfloat"),         element_type<double>("GLdouble"),
    element_type<std::uint8_t>("GLboolean")};

const Element& find_element(std::string_view name) {
  const auto* found = std::find_if(elements.begin(), elements.end(),
                                   [&](const Element& element) { return element.name == name; });
  if (found == elements.end()) throw std::runtime_error("no such type: " + std::string(name));
  return *found;
}

std::string number_text(double value) {
  std::array<char, 40> text{};
  // Shortest text that reads back as the same float: values are floats or whole numbers.
  const bool whole = value == static_cast<double>(static_cast<long long>(value));
  const auto result =
      whole ? std::to_chars(text.data(), text.data() + text.size(), static_cast<long long>(value))
            : std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(value));
  return {text.data(), result.ptr};
}

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

double parse_number(std::string_view text) {
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size())
    throw std::runtime_error("not a number: " + std::string(text));
  return value;
}

// Splits at commas outside brackets.
std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '{' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == '}' || text[i] == ']') --depth;
    if (text[i] != ',' || depth != 0) continue;
    parts.push_back(trim(text.substr(start, i - start)));
    start = i + 1;
  }
  if (!trim(text.substr(start)).empty()) parts.push_back(trim(text.substr(start)));
  return parts;
}

// (GLfloat[]){1, 2} is an input, (GLfloat[16]){0} an output.
Argument parse_array(std::string_view text) {
  const auto bracket = text.find('[');
  const auto end_of_size = text.find(']');
  const auto brace = text.find('{');
  if (bracket == std::string_view::npos || brace == std::string_view::npos)
    throw std::runtime_error("not an array: " + std::string(text));
  const std::string_view element = text.substr(1, bracket - 1);
  const std::string_view size = text.substr(bracket + 1, end_of_size - bracket - 1);
  if (!size.empty()) return output(element, static_cast<std::size_t>(parse_number(size)));
  std::vector<double> values;
  for (const std::string_view value : split(text.substr(brace + 1, text.size() - brace - 2)))
    values.push_back(parse_number(value));
  return input(element, values);
}

Argument parse_argument(std::string_view text) {
  if (text.starts_with("(void*)"))
    return address(static_cast<long long>(parse_number(text.substr(7))));
  if (text.starts_with("(")) return parse_array(text);
  if (text.starts_with("GL_")) return name(text);
  const double value = parse_number(text);
  return {Argument::Kind::number, std::string(text), value, {}, {}};
}

}  // namespace

Argument name(std::string_view names) {
  return {Argument::Kind::number, std::string(names), value_of_name(names), {}, {}};
}

Argument integer(long long value) {
  return {Argument::Kind::number,
          number_text(static_cast<double>(value)),
          static_cast<double>(value),
          {},
          {}};
}

Argument real(double value) {
  return {Argument::Kind::number, number_text(value), parse_number(number_text(value)), {}, {}};
}

Argument address(long long offset) {
  return {Argument::Kind::address,
          "(void*)" + std::to_string(offset),
          static_cast<double>(offset),
          {},
          {}};
}

Argument input(std::string_view element, const std::vector<double>& values) {
  const Element& type = find_element(element);
  Argument result{Argument::Kind::input, {}, 0, std::string(element), {}};
  std::string text;
  for (const double value : values) {
    const std::string one = number_text(value);
    type.append(result.bytes, parse_number(one));
    text += (text.empty() ? "" : ", ") + one;
  }
  result.text = "(" + result.element + "[]){" + text + "}";
  return result;
}

Argument output(std::string_view element, std::size_t count) {
  const Element& type = find_element(element);
  return {Argument::Kind::output,
          "(" + std::string(element) + "[" + std::to_string(count) + "]){0}", 0,
          std::string(element), Bytes(count * type.size)};
}

std::vector<double> numbers(std::string_view element, const std::vector<std::byte>& bytes) {
  std::vector<double> values;
  find_element(element).read(values, bytes);
  return values;
}

double value_of_name(std::string_view names) {
  std::uint32_t value = 0;
  while (!names.empty()) {
    const auto end = std::min(names.find('|'), names.size());
    value |= gl_name_value(trim(names.substr(0, end)));
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return static_cast<double>(value);
}

std::string Call::text() const {
  std::string result = "gl" + name + "(";
  for (const Argument& argument : arguments)
    result += (&argument == &arguments.front() ? "" : ", ") + argument.text;
  return result + ");";
}

std::string print_c(const Program& program, std::string_view comment) {
  std::string result;
  while (!comment.empty()) {
    const auto end = std::min(comment.find('\n'), comment.size());
    result += "// " + std::string(comment.substr(0, end)) + "\n";
    comment.remove_prefix(std::min(end + 1, comment.size()));
  }
  result += "#define GL_GLEXT_PROTOTYPES\n#include <GL/gl.h>\n#include <GL/glext.h>\n\n";
  result += "void program(void) {\n";
  for (const Call& call : program) result += "  " + call.text() + "\n";
  return result + "}\n";
}

Program parse_c(std::string_view text) {
  constexpr std::string_view opening = "void program(void) {";
  const auto body = text.find(opening);
  if (body == std::string_view::npos) throw std::runtime_error("no void program(void)");
  text.remove_prefix(body + opening.size());
  Program program;
  for (auto end = text.find(';'); end != std::string_view::npos; end = text.find(';')) {
    const std::string_view statement = trim(text.substr(0, end));
    text.remove_prefix(end + 1);
    const auto bracket = statement.find('(');
    if (!statement.starts_with("gl") || bracket == std::string_view::npos)
      throw std::runtime_error("not a call: " + std::string(statement));
    Call call{std::string(statement.substr(2, bracket - 2)), {}};
    for (const std::string_view part :
         split(statement.substr(bracket + 1, statement.size() - bracket - 2)))
      call.arguments.push_back(parse_argument(part));
    program.push_back(std::move(call));
  }
  return program;
}

bool calls(const Program& program, std::string_view name) {
  return std::any_of(program.begin(), program.end(),
                     [&](const Call& call) { return call.name == name; });
}

bool mentions(const Program& program, std::string_view argument, std::string_view name) {
  return std::any_of(program.begin(), program.end(), [&](const Call& call) {
    return (name.empty() || call.name == name) &&
           std::any_of(call.arguments.begin(), call.arguments.end(),
                       [&](const Argument& a) { return a.text == argument; });
  });
}

}  // namespace legacy_gl::fuzz
