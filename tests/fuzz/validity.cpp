#include "fuzz/validity.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace legacy_gl::fuzz {

namespace {

using Array = std::string;  // the name of its client state

Array array_of_pointer(const std::string& call) {
  if (call == "VertexPointer") return "GL_VERTEX_ARRAY";
  if (call == "ColorPointer") return "GL_COLOR_ARRAY";
  if (call == "NormalPointer") return "GL_NORMAL_ARRAY";
  if (call == "TexCoordPointer") return "GL_TEXTURE_COORD_ARRAY";
  if (call == "FogCoordPointer") return "GL_FOG_COORDINATE_ARRAY";
  if (call == "SecondaryColorPointer") return "GL_SECONDARY_COLOR_ARRAY";
  return {};
}

class Checker {
 public:
  bool accepts(const Call& call) {
    const std::string& name = call.name;
    if (name == "PushClientAttrib") saved_.push_back(client_);
    if (name == "PopClientAttrib" && !pop()) return false;
    if (name == "BindBuffer") bind(call);
    if (name == "BufferData") bytes_[bound_[call.arguments[0].text]] = call.arguments[1].number;
    if (name == "EnableClientState") client_.enabled[call.arguments[0].text] = true;
    if (name == "DisableClientState") client_.enabled[call.arguments[0].text] = false;
    if (name == "InterleavedArrays")
      client_.pointer["GL_VERTEX_ARRAY"] = client_.pointer["GL_NORMAL_ARRAY"] = true;
    if (const Array array = array_of_pointer(name); !array.empty()) {
      client_.pointer[array] = reads(call.arguments.back(), "GL_ARRAY_BUFFER");
    }
    if (name == "DrawElements" || name == "DrawRangeElements")
      if (!reads(call.arguments.back(), "GL_ELEMENT_ARRAY_BUFFER")) return false;
    const bool draws =
        name.starts_with("Draw") || name == "MultiDrawArrays" || name == "ArrayElement";
    return !draws || arrays_are_there();
  }

 private:
  struct Client {
    std::map<Array, bool> enabled;
    std::map<Array, bool> pointer;
  };

  bool pop() {
    if (saved_.empty()) return false;
    client_ = saved_.back();
    saved_.pop_back();
    return true;
  }

  void bind(const Call& call) {
    bound_[call.arguments[0].text] = static_cast<int>(call.arguments[1].number);
  }

  // Arrays of the program while no buffer is bound, offsets while one with data is.
  bool reads(const Argument& pointer, const std::string& target) {
    const int buffer = bound_[target];
    return pointer.kind == Argument::Kind::address ? buffer != 0 && bytes_[buffer] > 0
                                                   : buffer == 0;
  }

  bool arrays_are_there() {
    for (const auto& [array, enabled] : client_.enabled)
      if (enabled && !client_.pointer[array]) return false;
    return true;
  }

  Client client_;
  std::vector<Client> saved_;
  std::map<std::string, int> bound_;
  std::map<int, double> bytes_;
};

bool balanced(const Program& program) {
  bool begin = false;
  bool list = false;
  for (const Call& call : program) {
    if (call.name == "Begin" || call.name == "NewList") {
      bool& open = call.name == "Begin" ? begin : list;
      if (open || begin) return false;
      open = true;
    } else if (call.name == "End" || call.name == "EndList") {
      bool& open = call.name == "End" ? begin : list;
      if (!open || (begin && call.name == "EndList")) return false;
      open = false;
    }
  }
  return !begin && !list;
}

struct Corner {
  double x;
  double y;
  float z;
};

Corner corner(const Call& call) {
  std::vector<double> values;
  for (const Argument& argument : call.arguments)
    if (argument.kind == Argument::Kind::number) values.push_back(argument.number);
    else values = numbers(argument.element, argument.bytes);
  // In the precision of the coarsest, since calls of several types make a polygon.
  const auto depth = static_cast<float>(values.size() > 2 ? values[2] : 0);
  return {values[0], values[1], depth};
}

// Plane, and turning one way at each corner.
bool is_convex(const std::vector<Corner>& polygon) {
  int left = 0;
  int right = 0;
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % count];
    const Corner& c = polygon[(i + 2) % count];
    const double turn = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    if (a.z != b.z || turn == 0) return false;
    ++(turn > 0 ? left : right);
  }
  return left == 0 || right == 0;
}

bool polygons_are_convex(const std::string& mode, const std::vector<Corner>& corners) {
  const bool strip = mode == "GL_QUAD_STRIP";
  if (mode == "GL_POLYGON") return corners.size() < 3 || is_convex(corners);
  for (std::size_t i = 0; i + 4 <= corners.size(); i += strip ? 2 : 4) {
    const std::size_t third = strip ? i + 3 : i + 2;
    const std::size_t fourth = strip ? i + 2 : i + 3;
    if (!is_convex({corners[i], corners[i + 1], corners[third], corners[fourth]})) return false;
  }
  return true;
}

bool makes_vertex(const std::string& call) {
  return (call.starts_with("Vertex") && !call.ends_with("Pointer")) || call == "ArrayElement" ||
         call.starts_with("EvalCoord") || call.starts_with("EvalPoint");
}

// Mesa joins vertices that are left over to what comes next.
bool complete(const std::string& mode, int vertices) {
  if (mode == "GL_LINES") return vertices > 0 && vertices % 2 == 0;
  if (mode == "GL_TRIANGLES") return vertices > 0 && vertices % 3 == 0;
  if (mode == "GL_QUADS") return vertices > 0 && vertices % 4 == 0;
  if (mode == "GL_QUAD_STRIP") return vertices > 2 && vertices % 2 == 0;
  if (mode == "GL_POINTS") return vertices > 0;
  return vertices >= (mode == "GL_LINE_STRIP" ? 2 : 3);
}

// Others are undefined (2.6.1). Those of arrays are made convex, and stay as they are.
bool primitives_are_defined(const Program& program) {
  std::string mode;
  std::vector<Corner> corners;
  int vertices = 0;
  for (const Call& call : program) {
    vertices += makes_vertex(call.name) ? 1 : 0;
    if (call.name == "Begin") {
      mode = call.arguments[0].text;
      corners.clear();
      vertices = 0;
    } else if (call.name.starts_with("Vertex") && !call.name.ends_with("Pointer")) {
      corners.push_back(corner(call));
    } else if (call.name == "End" && !complete(mode, vertices)) {
      return false;
    } else if (call.name == "End" && (mode.starts_with("GL_QUAD") || mode == "GL_POLYGON")) {
      if (!polygons_are_convex(mode, corners)) return false;
    }
  }
  return true;
}

// What the call gives to a vertex; empty when nothing.
std::string attribute(const Call& call) {
  for (const char* name : {"Color", "SecondaryColor", "Normal", "TexCoord", "FogCoord", "EdgeFlag"})
    if (call.name.starts_with(name) && !call.name.ends_with("Pointer")) return call.name;
  if (call.name.starts_with("MultiTexCoord")) return call.name + call.arguments[0].text;
  if (call.name.starts_with("Material"))
    return call.name + call.arguments[0].text + call.arguments[1].text;
  return {};
}

// Mesa splits primitives where an attribute comes mid-way.
bool attributes_come_first(const Program& program) {
  std::vector<std::string> known;
  bool begun = false;
  bool vertex = false;
  int components = 0;
  for (const Call& call : program) {
    if (call.name == "Begin" || call.name == "End") {
      begun = call.name == "Begin";
      vertex = false;
      known.clear();
    }
    // So where positions get more components.
    if (call.name.starts_with("Vertex") && !call.name.ends_with("Pointer")) {
      const int now = call.name[6] - '0';
      if (vertex && now > components) return false;
      components = vertex ? components : now;
    }
    vertex = vertex || makes_vertex(call.name);
    const std::string name = attribute(call);
    if (!begun || name.empty()) continue;
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    if (vertex) return false;
    known.push_back(name);
  }
  return true;
}

// M12: Mesa heeds edge flags in strips and fans.
bool edges_of_strips_are_seen(const Program& program) {
  bool flag = true;
  for (const Call& call : program) {
    if (call.name == "EdgeFlag") flag = call.arguments[0].number != 0;
    if (call.name != "Begin" || flag) continue;
    const std::string& mode = call.arguments[0].text;
    if (mode != "GL_TRIANGLES" && mode != "GL_QUADS" && mode != "GL_POLYGON") return false;
  }
  return flag;
}

}  // namespace

bool playable(const Program& program) {
  if (!balanced(program) || !primitives_are_defined(program)) return false;
  if (!attributes_come_first(program) || !edges_of_strips_are_seen(program)) return false;
  Checker checker;
  // Frames follow one another.
  for (int frame = 0; frame < 2; ++frame)
    for (const Call& call : program)
      if (!checker.accepts(call)) return false;
  return true;
}

}  // namespace legacy_gl::fuzz
