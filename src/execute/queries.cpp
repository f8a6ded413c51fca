#include "execute/queries.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "execute/capabilities.hpp"

namespace legacy_gl {

namespace {

std::vector<Query> sorted_rows() {
  std::vector<Query> rows;
  for (const QueryGroups groups :
       {state_queries(), array_queries(), driver_queries(), initial_value_queries()})
    for (const auto& group : groups) rows.insert(rows.end(), group.begin(), group.end());
  std::sort(rows.begin(), rows.end(),
            [](const Query& a, const Query& b) { return a.name < b.name; });
  return rows;
}

const Query* find_row(GLenum name) {
  static const std::vector<Query> rows = sorted_rows();
  const auto row =
      std::lower_bound(rows.begin(), rows.end(), name,
                       [](const Query& query, GLenum wanted) { return query.name < wanted; });
  return row != rows.end() && row->name == name ? &*row : nullptr;
}

}  // namespace

bool query(Context& context, GLenum name, QueryValues& values) {
  if (const Query* const row = find_row(name)) {
    values.kind = row->kind;
    row->read(context, values);
    return true;
  }
  // Whatever glIsEnabled answers, glGet answers too (GL 2.1 spec 6.1.1).
  bool known = false;
  const bool enabled = capability_enabled(context, name, known);
  values.kind = ValueKind::kBoolean;
  if (known) values.put(enabled ? 1.0 : 0.0);
  return known;
}

GLboolean as_boolean(double value) { return value != 0 ? GL_TRUE : GL_FALSE; }

GLint as_integer(ValueKind kind, double value) {
  constexpr double kLargest = 2147483647.0;
  if (std::isnan(value)) return 0;
  // 1 becomes the largest integer and 0 becomes 0: GL 4.2 spec 2.3.1. Table 4.9 of GL 2.1 has no
  // integer for 0.
  const double integer =
      kind == ValueKind::kNormalised ? std::trunc(value * kLargest) : std::round(value);
  // "the nearest value representable using the requested type" (GL 2.1 spec 6.1.2)
  return static_cast<GLint>(std::clamp(integer, -kLargest - 1, kLargest));
}

}  // namespace legacy_gl
