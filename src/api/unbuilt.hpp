#pragma once

namespace legacy_gl {

/// An entry point that is declared and not built: one diagnostic that names it, and
/// GL_INVALID_OPERATION.
void report_unbuilt(const char* name);

}  // namespace legacy_gl
