// A program of OpenGL calls as data. Its text is C: it compiles, and parse_c() reads it again.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace legacy_gl::fuzz {

struct Argument {
  enum class Kind {
    number,   // a number or a name, e.g. 0.5, GL_LIGHT0, GL_CURRENT_BIT | GL_FOG_BIT
    address,  // an offset into a buffer object
    input,    // an array that the call reads, or that client arrays keep reading
    output    // an array that the call writes
  };
  Kind kind = Kind::number;
  std::string text;  // as C writes it
  double number = 0;
  std::string element;           // the type of an array's elements, e.g. GLfloat
  std::vector<std::byte> bytes;  // of an array; zeroes for an output
};

Argument name(std::string_view names);
Argument integer(long long value);
Argument real(double value);
Argument address(long long offset);
Argument input(std::string_view element, const std::vector<double>& values);
Argument output(std::string_view element, std::size_t count);

// The elements of an array, whatever their type.
std::vector<double> numbers(std::string_view element, const std::vector<std::byte>& bytes);

struct Call {
  std::string name;
  std::vector<Argument> arguments;

  std::string text() const;
};

using Program = std::vector<Call>;

// The value of a name such as GL_LIGHT0, or of several joined by "|". Throws std::runtime_error.
double value_of_name(std::string_view names);

// Lines of `comment` come first, each behind "//".
std::string print_c(const Program& program, std::string_view comment);
// Throws std::runtime_error for what print_c() does not write.
Program parse_c(std::string_view text);

bool calls(const Program& program, std::string_view name);
// Whether a call of that name (any when empty) has an argument with that text.
bool mentions(const Program& program, std::string_view argument, std::string_view name = {});

}  // namespace legacy_gl::fuzz
