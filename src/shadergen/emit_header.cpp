#include "shadergen/emit.hpp"

namespace legacy_gl {

void emit_header(Writer& w, const ProgramKey& key, Dialect dialect, const char* stage) {
  w.line(dialect == Dialect::kEs300 ? "#version 300 es" : "#version 330 core");
  w.line(std::string("// ") + stage + ": " + describe(key));
  if (dialect == Dialect::kEs300) {
    w.line("precision highp float;");
    w.line("precision highp int;");
  }
  w.blank();
}

}  // namespace legacy_gl
