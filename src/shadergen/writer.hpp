#pragma once
#include <string>

namespace legacy_gl {

/// GLSL text that grows line by line, indented as a person would.
class Writer {
 public:
  void line(const std::string& text) {
    if (!text.empty()) text_.append(2 * depth_, ' ');
    text_ += text;
    text_ += '\n';
  }
  void blank() { text_ += '\n'; }
  void raw(const std::string& text) { text_ += text; }
  void open(const std::string& text) {
    line(text);
    ++depth_;
  }
  void close(const std::string& text = "}") {
    --depth_;
    line(text);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  unsigned depth_ = 0;
};

}  // namespace legacy_gl
