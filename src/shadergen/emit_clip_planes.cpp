#include "shadergen/emit.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

template <typename Visit>
void for_each_plane(const FragmentKey& key, Visit visit) {
  for (unsigned plane = 0; plane < kMaxClipDistances; ++plane)
    if (key.clip_planes & 1u << plane) visit(std::to_string(plane));
}

}  // namespace

void emit_clip_block(Writer& w, const FragmentKey& key) {
  if (key.clip_planes) w.raw(kClipPlanesBlockText);
}

/// OpenGL ES has no clip distances: fragments behind a plane are discarded.
void emit_clip_varyings(Writer& w, const FragmentKey& key, Dialect dialect,
                        const std::string& direction) {
  if (dialect == Dialect::kCore330) return;
  for_each_plane(key, [&](const std::string& plane) {
    w.line(direction + " float clip_distance_" + plane + ";");
  });
}

/// GL 2.1 spec 2.12: the half-space of a plane is where its distance is not negative.
void emit_clip_distances(Writer& w, const FragmentKey& key, Dialect dialect) {
  for_each_plane(key, [&](const std::string& plane) {
    const std::string target =
        dialect == Dialect::kCore330 ? "gl_ClipDistance[" + plane + "]" : "clip_distance_" + plane;
    w.line(target + " = dot(clip_planes[" + plane + "], gl_Position);");
  });
}

void emit_clip_discard(Writer& w, const FragmentKey& key, Dialect dialect) {
  if (dialect == Dialect::kCore330) return;
  for_each_plane(key, [&](const std::string& plane) {
    w.line("if (clip_distance_" + plane + " < 0.0) discard;");
  });
}

}  // namespace legacy_gl
