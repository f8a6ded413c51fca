// Large meshes over a driver that draws on the CPU: only the triangles that may be seen.
#include "execute/framebuffer.hpp"
#include "software/hidden_sides.hpp"
#include "submit/backend.hpp"

namespace legacy_gl {

namespace {

/// The draw at which a mesh is looked at: what is drawn once or twice does not pay for it.
constexpr unsigned kLooksAtDraw = 3;

}  // namespace

const FramebufferFacts& Backend::framebuffer_facts(const Context& context) {
  if (!framebuffer_facts_) {
    GLint samples = 0, sample_buffers = 0;
    driver.GetIntegerv(GL_SAMPLES, &samples);
    driver.GetIntegerv(GL_SAMPLE_BUFFERS, &sample_buffers);
    framebuffer_facts_ = {framebuffer_bits(context, FramebufferChannel::kDepth), samples > 1,
                          sample_buffers > 0};
  }
  return *framebuffer_facts_;
}

/// How the surface is seen, if some of its triangles need not be drawn.
std::optional<SurfaceView> Backend::surface_view(Context& context, const ListMesh& mesh,
                                                 const Surface& surface) {
  if (surface.winding == Surface::Winding::kOpen || !shows_nearest_alone(context)) return {};
  const FramebufferFacts& framebuffer = framebuffer_facts(context);
  if (framebuffer.multisampled) return {};
  SurfaceView view;
  view.to_clip = derived_.transform.modelview_projection;
  view.viewport = context.raster.viewport;
  const Surface::Winding hidden =
      hidden_winding(surface.winding, {mesh.lowest, mesh.highest}, view.to_clip, view.viewport,
                     framebuffer.depth_bits);
  if (hidden == Surface::Winding::kOpen) return {};
  view.drops_clockwise = hidden == Surface::Winding::kClockwise;
  view.drops_counterclockwise = !view.drops_clockwise;
  view.keeps_outline = true;
  return view;
}

bool Backend::draw_surface(Context& context, const ListMesh& mesh, MeshBuffers::Entry& buffers) {
  if (!skips_unseen(context) || mesh.vertex_count() < kWorthwhileSurface) return false;
  if (buffers.draws < kLooksAtDraw && (++buffers.draws == kLooksAtDraw || mesh.surface)) {
    buffers.draws = kLooksAtDraw;
    auto surface = mesh.surface ? mesh.surface : std::make_shared<Surface>(find_surface(mesh));
    if (surface->winding != Surface::Winding::kOpen) {
      buffers.surface = std::make_unique<KeptSurface>();
      buffers.surface->surface = std::move(surface);
    }
  }
  if (!buffers.surface) return false;
  KeptSurface& kept = *buffers.surface;
  const std::optional<SurfaceView> view = surface_view(context, mesh, *kept.surface);
  if (!view) return false;
  if (!use_program(context, GL_TRIANGLES, mesh.vertex_count())) return true;
  if (view != kept.view) {
    index_scratch_.clear();
    seen_triangles_.append(*kept.surface, *view, index_scratch_);
    if (!kept.array) {
      driver.GenBuffers(1, &kept.index_buffer);
      kept.array =
          build_vertex_array(driver, mesh.layout, buffers.vertex_buffer, kept.index_buffer);
      bound_array_ = kept.array;
    }
    const std::size_t size = index_scratch_.size() * sizeof(std::uint32_t);
    driver.BindBuffer(GL_COPY_WRITE_BUFFER, kept.index_buffer);
    driver.BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(size), index_scratch_.data(),
                      GL_DYNAMIC_DRAW);
    kept.index_count = static_cast<GLsizei>(index_scratch_.size());
    kept.view = view;
    context.statistics.index_bytes_uploaded += size;
  }
  bind_vertex_array(kept.array);
  if (kept.index_count)
    driver.DrawElements(GL_TRIANGLES, kept.index_count, GL_UNSIGNED_INT, nullptr);
  ++context.statistics.draws;
  context.statistics.triangles_unseen +=
      (kept.surface->corners.size() - static_cast<std::size_t>(kept.index_count)) / 3;
  return true;
}

}  // namespace legacy_gl
