#include "fuzz/known.hpp"

namespace legacy_gl::fuzz {

namespace {

struct Deviation {
  const char* row;
  bool (*concerns)(const Program&, const Mode&);
};

bool enables(const Program& program, const char* capability) {
  return mentions(program, capability, "Enable");
}

constexpr Deviation deviations[] = {
    {"D3: OpenGL ES has no smooth lines",
     [](const Program& program, const Mode& mode) {
       return mode.dialect == Dialect::es && enables(program, "GL_LINE_SMOOTH");
     }},
    {"D4: OpenGL ES has no logical operations",
     [](const Program& program, const Mode& mode) {
       return mode.dialect == Dialect::es &&
              (calls(program, "LogicOp") || enables(program, "GL_COLOR_LOGIC_OP"));
     }},
    {"D15: OpenGL ES discards fragments instead of clipping",
     [](const Program& program, const Mode& mode) {
       return mode.dialect == Dialect::es &&
              (enables(program, "GL_CLIP_PLANE0") || enables(program, "GL_CLIP_PLANE1"));
     }},
};

struct Fault {
  const char* name;
  bool (*explains)(const Program&, const Mode&, const Difference&);
};

// An entry goes when its fault is mended, and its program enters corpus/.
constexpr Fault faults[] = {
    // Quads by glDrawArrays from a buffer object that clipping cuts take the other diagonal.
    {"R1",
     [](const Program& program, const Mode&, const Difference& difference) {
       return difference.kind == "picture" && mentions(program, "GL_QUADS", "DrawArrays") &&
              calls(program, "BufferData");
     }},
    // Stippled outlines begin their pattern at different edges.
    {"F3",
     [](const Program& program, const Mode&, const Difference& difference) {
       return difference.kind == "picture" && enables(program, "GL_LINE_STIPPLE") &&
              mentions(program, "GL_LINE", "PolygonMode");
     }},
};

}  // namespace

const char* deviation(const Program& program, const Mode& mode) {
  for (const Deviation& row : deviations)
    if (row.concerns(program, mode)) return row.row;
  return nullptr;
}

const char* known_fault(const Program& program, const Mode& mode, const Difference& difference) {
  for (const Fault& fault : faults)
    if (fault.explains(program, mode, difference)) return fault.name;
  return nullptr;
}

}  // namespace legacy_gl::fuzz
