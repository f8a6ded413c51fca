// Which meshes are closed, and which triangles of one may cover a sample.
#include "geometry/surface.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <random>
#include <set>

#include "geometry/object_surface.hpp"
#include "geometry/visible_triangles.hpp"

namespace legacy_gl {
namespace {

using Winding = Surface::Winding;

class MeshBuilder {
 public:
  MeshBuilder() { mesh_->layout.fields = kFieldNormal; }

  void vertex(const glm::vec3& position, const glm::vec3& normal) {
    mesh_->vertices.insert(mesh_->vertices.end(), {position.x, position.y, position.z});
    mesh_->vertices.insert(mesh_->vertices.end(), {normal.x, normal.y, normal.z});
  }
  void run(GLenum mode, std::uint32_t count) {
    mesh_->runs.push_back({mode, mesh_->vertex_count() - count, count, false});
  }
  // In strips, as old programs draw it: the seam and the poles are rounded in different ways.
  void ball(const glm::vec3& center, float radius, int slices, int stacks, float turn = 1) {
    for (int stack = 0; stack < stacks; ++stack) {
      for (int slice = 0; slice <= slices; ++slice)
        for (const int row : {stack + 1, stack}) {
          const float b = std::numbers::pi_v<float> *
                          (static_cast<float>(row) / static_cast<float>(stacks) - 0.5F);
          const float a = turn * 2 * std::numbers::pi_v<float> * static_cast<float>(slice) /
                          static_cast<float>(slices);
          const glm::vec3 n(std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a));
          vertex(center + radius * n, n);
        }
      run(GL_TRIANGLE_STRIP, 2 * static_cast<std::uint32_t>(slices) + 2);
    }
  }
  // Quads, outside counterclockwise.
  void box(const glm::vec3& half, unsigned faces = 6, int turned_face = -1) {
    for (unsigned face = 0; face < faces; ++face) {
      glm::vec3 n(0), v(0);
      n[static_cast<int>(face / 2)] = face % 2 ? -1.0F : 1.0F;
      v[static_cast<int>((face / 2 + 1) % 3)] = 1;
      const glm::vec3 u = glm::cross(v, n) * (static_cast<int>(face) == turned_face ? -1.0F : 1.0F);
      for (const auto& [a, b] :
           {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}})
        vertex(half * (n + a * u + b * v), n);
      run(GL_QUADS, 4);
    }
  }
  const ListMesh& finish() {
    mesh_->finish();
    return *mesh_;
  }
  ListMesh& mesh() { return *mesh_; }

 private:
  std::shared_ptr<ListMesh> mesh_ = std::make_shared<ListMesh>();
};

TEST(Surfaces, ABallOfStripsIsClosedAndSmoothInSpiteOfItsSeam) {
  MeshBuilder builder;
  builder.ball({1, 2, 3}, 2, 24, 12);
  const Surface surface = find_surface(builder.finish());
  EXPECT_EQ(surface.winding, Winding::kClockwise);
  EXPECT_TRUE(surface.smooth);
}

TEST(Surfaces, TheOtherWayRoundItIsWoundTheOtherWay) {
  MeshBuilder builder;
  builder.ball({1, 2, 3}, 2, 24, 12, -1);
  EXPECT_EQ(find_surface(builder.finish()).winding, Winding::kCounterclockwise);
}

TEST(Surfaces, ABoxIsClosedAndHasEdges) {
  MeshBuilder builder;
  builder.box({1, 2, 3});
  const Surface surface = find_surface(builder.finish());
  EXPECT_EQ(surface.winding, Winding::kCounterclockwise);
  EXPECT_FALSE(surface.smooth);
}

TEST(Surfaces, PartsMayLieApartAndInOneAnother) {
  MeshBuilder builder;
  builder.ball({0, 0, 0}, 1, 12, 8);
  builder.ball({5, 0, 0}, 1, 12, 8);
  builder.ball({5, 0, 0}, 0.5F, 12, 8);
  EXPECT_EQ(find_surface(builder.finish()).winding, Winding::kClockwise);
}

TEST(Surfaces, PartsThatAreWoundDifferentlyAreOpen) {
  MeshBuilder builder;
  builder.ball({0, 0, 0}, 1, 12, 8);
  builder.ball({5, 0, 0}, 1, 12, 8, -1);
  EXPECT_EQ(find_surface(builder.finish()).winding, Winding::kOpen);
}

TEST(Surfaces, WithoutOneFaceOrWithOneTurnedABoxIsOpen) {
  MeshBuilder without, turned;
  without.box({1, 2, 3}, 5);
  turned.box({1, 2, 3}, 6, 2);
  EXPECT_EQ(find_surface(without.finish()).winding, Winding::kOpen);
  EXPECT_EQ(find_surface(turned.finish()).winding, Winding::kOpen);
}

TEST(Surfaces, ASheetOfTwoSidesIsOpen) {
  MeshBuilder builder;
  builder.box({1, 1, 0.001F});
  EXPECT_EQ(find_surface(builder.finish()).winding, Winding::kOpen);
}

TEST(Surfaces, LinesAndNumbersThatAreNoneAreOpen) {
  MeshBuilder lines, infinite;
  lines.box({1, 2, 3});
  lines.vertex({0, 0, 0}, {0, 0, 1});
  lines.vertex({1, 0, 0}, {0, 0, 1});
  lines.run(GL_LINES, 2);
  infinite.box({1, 2, std::numeric_limits<float>::infinity()});
  EXPECT_EQ(find_surface(lines.finish()).winding, Winding::kOpen);
  EXPECT_EQ(find_surface(infinite.finish()).winding, Winding::kOpen);
  EXPECT_EQ(find_surface(ListMesh()).winding, Winding::kOpen);
}

TEST(Surfaces, NormalsThatDifferAtOnePlaceAreNotSmooth) {
  MeshBuilder builder;
  builder.ball({0, 0, 0}, 1, 12, 8);
  builder.mesh().vertices[6 * 40 + 3] += 0.1F;
  const Surface surface = find_surface(builder.finish());
  EXPECT_EQ(surface.winding, Winding::kClockwise);
  EXPECT_FALSE(surface.smooth);
}

TEST(ObjectSurfaces, ABoxHasEightPlacesAndTheEdgesOfItsTriangles) {
  MeshBuilder builder;
  builder.box({1, 2, 3});
  const ObjectSurface surface = find_object_surface(builder.finish());
  EXPECT_EQ(surface.winding, Winding::kCounterclockwise);
  EXPECT_EQ(surface.places.size(), 8u);
  EXPECT_EQ(surface.place_of_vertex.size(), 24u);
  EXPECT_EQ(surface.triangles.size(), 12u);
  EXPECT_EQ(surface.edges.size(), 18u);
  EXPECT_FLOAT_EQ(surface.thickness, 1.0F / 6);  // half of the smallest edge in the largest
}

TEST(ObjectSurfaces, TrianglesBetweenPlacesThatCountAsOneHaveNoEdges) {
  MeshBuilder builder;
  builder.ball({0, 0, 0}, 1, 8, 6);
  const ObjectSurface surface = find_object_surface(builder.finish());
  EXPECT_EQ(surface.winding, Winding::kClockwise);
  EXPECT_EQ(surface.triangles.size(), 96u);
  EXPECT_EQ(surface.edges.size(), (96u - 16u) * 3 / 2);  // 16 have no area at the poles
}

TEST(ObjectSurfaces, OfAnOpenMeshTheTrianglesAreKnown) {
  MeshBuilder builder;
  builder.box({1, 2, 3}, 5);
  const ObjectSurface surface = find_object_surface(builder.finish());
  EXPECT_EQ(surface.winding, Winding::kOpen);
  EXPECT_EQ(surface.triangles.size(), 10u);
  EXPECT_TRUE(surface.edges.empty());
}

// A vertex in window coordinates, by double.
struct Window {
  double x, y, w;
};

// Every triangle that covers the middle of a pixel is found, however vertices are rounded to the
// grid of 1/256 of a pixel.
TEST(VisibleTriangles, AreAllThatCoverASample) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(-1, 1);
  for (const float size : {0.002F, 0.01F, 0.05F, 0.4F}) {
    Surface surface;
    for (std::uint32_t t = 0; t < 4000; ++t) {
      const glm::vec3 center(any(random), any(random), any(random));
      for (std::uint32_t k = 0; k < 3; ++k) {
        surface.places.emplace_back(center +
                                    size * glm::vec3(any(random), any(random), any(random)));
        surface.corners.push_back({3 * t + k, 3 * t + k});
      }
    }
    SurfaceView view;
    view.viewport.box = {3, -5, 200, 150};
    view.to_clip = glm::perspective(0.6F, 1.2F, 1.0F, 10.0F) *
                   glm::translate(glm::mat4(1.0F), glm::vec3(0, 0, -4));
    std::vector<std::uint32_t> indices;
    VisibleTriangles().append(surface, view, indices);
    std::set<std::uint32_t> seen;
    for (std::size_t i = 0; i < indices.size(); i += 3) seen.insert(indices[i] / 3);

    std::size_t covering = 0;
    for (std::uint32_t t = 0; t < 4000; ++t) {
      std::array<Window, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec4 clip = glm::dmat4(view.to_clip) * glm::dvec4(surface.places[3 * t + k], 1);
        const auto snap = [](double value) { return std::round(value * 256) / 256; };
        corners[k] = {snap((clip.x / clip.w + 1) * 100 + 3), snap((clip.y / clip.w + 1) * 75 - 5),
                      clip.w};
      }
      const auto inside = [&](double x, double y) {
        double least = 1e9, most = -1e9;
        for (std::size_t k = 0; k < 3; ++k) {
          const Window &a = corners[k], &b = corners[(k + 1) % 3];
          const double side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
          least = std::min(least, side);
          most = std::max(most, side);
        }
        return least >= 0 || most <= 0;
      };
      bool covers = false;
      for (int y = -5; y < 145 && !covers; ++y)
        for (int x = 3; x < 203 && !covers; ++x) covers = inside(x + 0.5, y + 0.5);
      covering += covers;
      EXPECT_TRUE(!covers || seen.contains(t)) << "triangle " << t << " of size " << size;
    }
    EXPECT_GT(covering, 0u);
    EXPECT_LT(seen.size(), 2 * covering + 400) << "size " << size;
  }
}

TEST(VisibleTriangles, DropOneSideAndKeepTheOutline) {
  MeshBuilder builder;
  builder.ball({0, 0, 0}, 1, 48, 24);
  const Surface surface = find_surface(builder.finish());
  SurfaceView view;
  view.viewport.box = {0, 0, 1000, 1000};
  view.to_clip = glm::perspective(0.6F, 1.0F, 1.0F, 10.0F) *
                 glm::translate(glm::mat4(1.0F), glm::vec3(0, 0, -4));
  const auto count = [&] {
    std::vector<std::uint32_t> indices;
    VisibleTriangles().append(surface, view, indices);
    return indices.size() / 3;
  };
  const std::size_t all = count();
  view.drops_clockwise = true;
  const std::size_t one_side = count();
  view.drops_clockwise = false;
  view.drops_counterclockwise = true;
  const std::size_t other_side = count();
  EXPECT_GE(one_side + other_side, all);
  EXPECT_LT(one_side + other_side, all + 100);  // edge-on: either
  view.keeps_outline = true;
  EXPECT_GT(count(), other_side + 48);
  EXPECT_LT(count(), other_side + all / 4);
}

}  // namespace
}  // namespace legacy_gl
