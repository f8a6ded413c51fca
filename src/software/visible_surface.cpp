// Large meshes over a driver that draws on the CPU: only the triangles that may be seen.
#include "software/hidden_winding.hpp"
#include "software/software_fast_path.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

/// The draw at which a mesh is looked at: what is drawn once or twice does not pay for it.
constexpr unsigned kLooksAtDraw = 3;

}  // namespace

/// How the surface is seen, if some of its triangles need not be drawn.
std::optional<SurfaceView> SoftwareFastPath::surface_view(Context& context, const ListMesh& mesh,
                                                          const Surface& surface) {
  Submission& submission = *context.submission;
  if (surface.winding == Surface::Winding::kOpen || !shows_nearest_alone(context)) return {};
  const FramebufferFacts& framebuffer = framebuffer_facts(context);
  if (framebuffer.multisampled) return {};
  SurfaceView view;
  view.to_clip = submission.inputs.transform.modelview_projection;
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

bool SoftwareFastPath::draw_visible(Context& context, const ListMesh& mesh,
                                    MeshBuffers::Entry& buffers) {
  const Driver& driver = context.driver->functions;
  Submission& submission = *context.submission;
  if (!skips_hidden_triangles(context) || mesh.vertex_count() < kWorthwhileSurface) return false;
  if (buffers.draws < kLooksAtDraw && (++buffers.draws == kLooksAtDraw || mesh.surface)) {
    buffers.draws = kLooksAtDraw;
    auto surface = mesh.surface ? mesh.surface : std::make_shared<Surface>(find_surface(mesh));
    if (surface->winding != Surface::Winding::kOpen) {
      buffers.surface = std::make_unique<CachedVisibleTriangles>();
      buffers.surface->surface = std::move(surface);
    }
  }
  if (!buffers.surface) return false;
  CachedVisibleTriangles& kept = *buffers.surface;
  const std::optional<SurfaceView> view = surface_view(context, mesh, *kept.surface);
  if (!view) return false;
  if (!use_program(context, GL_TRIANGLES, mesh.vertex_count())) return true;
  if (view != kept.view) {
    submission.indices.clear();
    visible_triangles_.append(*kept.surface, *view, submission.indices);
    if (!kept.array) {
      driver.GenBuffers(1, &kept.index_buffer);
      kept.array =
          build_vertex_array(driver, mesh.layout, buffers.vertex_buffer, kept.index_buffer);
      context.driver->bound_array = kept.array;
    }
    const std::size_t size = submission.indices.size() * sizeof(std::uint32_t);
    driver.BindBuffer(GL_COPY_WRITE_BUFFER, kept.index_buffer);
    driver.BufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(size),
                      submission.indices.data(), GL_DYNAMIC_DRAW);
    kept.index_count = static_cast<GLsizei>(submission.indices.size());
    kept.view = view;
    context.statistics.index_bytes_uploaded += size;
  }
  context.driver->bind_vertex_array(kept.array);
  if (kept.index_count)
    driver.DrawElements(GL_TRIANGLES, kept.index_count, GL_UNSIGNED_INT, nullptr);
  ++context.statistics.draws;
  context.statistics.triangles_unseen +=
      (kept.surface->corners.size() - static_cast<std::size_t>(kept.index_count)) / 3;
  return true;
}

}  // namespace legacy_gl
