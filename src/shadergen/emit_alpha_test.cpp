#include "shadergen/emit.hpp"

namespace legacy_gl {

namespace {

const char* comparison(AlphaFunction function) {
  switch (function) {
    case AlphaFunction::kLess: return "<";
    case AlphaFunction::kEqual: return "==";
    case AlphaFunction::kLessOrEqual: return "<=";
    case AlphaFunction::kGreater: return ">";
    case AlphaFunction::kNotEqual: return "!=";
    case AlphaFunction::kGreaterOrEqual: return ">=";
    case AlphaFunction::kAlways:
    case AlphaFunction::kNever: break;
  }
  return "";
}

}  // namespace

/// GL 2.1 spec 4.1.4.
void emit_alpha_test(Writer& w, const FragmentKey& key, FragmentColors& colors) {
  if (!key.has_alpha_test()) return;
  if (key.alpha == AlphaFunction::kNever) return w.line("discard;");
  colors.make_variable(w);
  w.line(std::string("if (!(color.a ") + comparison(key.alpha) + " fog_parameters.w)) discard;");
}

}  // namespace legacy_gl
