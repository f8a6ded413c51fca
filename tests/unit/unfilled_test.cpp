// GL 2.1 spec 3.5.4: which edges and vertices of which polygons become lines and points, in which
// order.
#include "geometry/unfilled.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace legacy_gl {

namespace {

using Indices = std::vector<std::uint32_t>;

constexpr std::uint8_t kFields = kFieldColor | kFieldEdgeFlag;

// A batch of vertices on a circle, counter-clockwise, whose red is the vertex's number.
class Unfilled : public testing::Test {
 protected:
  Unfilled() { state_.viewport.box = {0, 0, 100, 100}; }

  void add_run(GLenum mode, const std::vector<bool>& edge_flags) {
    const auto first = static_cast<std::uint32_t>(vertices_.size() / stride_);
    const std::size_t count = edge_flags.size();
    for (std::size_t i = 0; i < count; ++i) {
      const float angle = glm::radians(360.0F) * static_cast<float>(i) / static_cast<float>(count);
      const float number = static_cast<float>(vertices_.size() / stride_);
      vertices_.insert(vertices_.end(), {std::cos(angle), std::sin(angle), 0});
      vertices_.insert(vertices_.end(), {number, 0, 0, 1});
      vertices_.push_back(edge_flags[i] ? 1 : 0);
    }
    runs_.push_back({mode, first, static_cast<std::uint32_t>(count)});
  }
  void add_run(GLenum mode, std::size_t count) { add_run(mode, std::vector<bool>(count, true)); }

  const ExpandedBatch& expand() {
    const VertexBatch batch{{kFields, 0},
                            vertices_.data(),
                            static_cast<std::uint32_t>(vertices_.size() / stride_),
                            runs_,
                            elements_};
    expand_unfilled(batch, state_, expanded_);
    return expanded_;
  }
  // The batch's vertices that lie where the expanded batch's do.
  Indices vertex_numbers() const {
    Indices numbers;
    for (const std::uint32_t index : expanded_.indices) {
      std::uint32_t number = 0;
      while (vertices_.at(number * stride_) != expanded_float(index, 0) ||
             vertices_.at(number * stride_ + 1) != expanded_float(index, 1))
        ++number;
      numbers.push_back(number);
    }
    return numbers;
  }
  float expanded_float(std::uint32_t index, unsigned offset) const {
    return expanded_.vertices[index * offsets_of(expanded_.layout).stride + offset];
  }
  void set_modes(GLenum front, GLenum back) {
    state_.polygon.front_mode = front;
    state_.polygon.back_mode = back;
  }

  const std::size_t stride_ = offsets_of({kFields, 0}).stride;
  std::vector<float> vertices_;
  std::vector<PrimitiveRun> runs_;
  Indices elements_;
  UnfilledState state_;
  ExpandedBatch expanded_;
};

struct UnfilledPrimitives : Unfilled {
  void expect(GLenum mode, std::size_t count, const Indices& lines, const Indices& points) {
    vertices_.clear();
    runs_.clear();
    add_run(mode, count);
    set_modes(GL_LINE, GL_LINE);
    expand();
    EXPECT_EQ(expanded_.indices, lines) << "lines of mode " << mode;
    EXPECT_EQ(expanded_.groups,
              (std::vector<PrimitiveGroup>{
                  {GL_LINES, false, 0, static_cast<std::uint32_t>(lines.size())}}));
    set_modes(GL_POINT, GL_POINT);
    expand();
    EXPECT_EQ(expanded_.indices, points) << "points of mode " << mode;
    EXPECT_FALSE(expanded_.own_vertices);
  }
};

TEST_F(UnfilledPrimitives, DrawEachBoundaryEdgeAndVertex) {
  expect(GL_TRIANGLES, 3, {2, 0, 0, 1, 1, 2}, {0, 1, 2});
  expect(GL_TRIANGLE_STRIP, 4, {2, 0, 0, 1, 1, 2, 3, 2, 2, 1, 1, 3}, {0, 1, 2, 2, 1, 3});
  expect(GL_TRIANGLE_FAN, 4, {2, 0, 0, 1, 1, 2, 3, 0, 0, 2, 2, 3}, {0, 1, 2, 0, 2, 3});
  // No diagonals.
  expect(GL_QUADS, 4, {3, 0, 0, 1, 1, 2, 2, 3}, {0, 3, 1, 2});
  expect(GL_QUAD_STRIP, 4, {3, 2, 2, 0, 0, 1, 1, 3}, {2, 3, 0, 1});
  expect(GL_POLYGON, 5, {0, 1, 1, 2, 2, 3, 3, 4, 4, 0}, {1, 0, 2, 3, 4});
}

TEST_F(Unfilled, EdgeFlagsBelongToTheEdgeThatTheirVertexBegins) {
  set_modes(GL_LINE, GL_LINE);
  add_run(GL_POLYGON, {true, false, true, true, false});
  EXPECT_EQ(expand().indices, (Indices{0, 1, 2, 3, 3, 4}));
  runs_.clear();
  add_run(GL_TRIANGLES, {false, true, true});
  EXPECT_EQ(expand().indices, (Indices{7, 5, 6, 7}));
  runs_.clear();
  add_run(GL_QUADS, {true, true, false, true});
  EXPECT_EQ(expand().indices, (Indices{11, 8, 8, 9, 9, 10}));
}

TEST_F(Unfilled, EdgeFlagsChooseTheVerticesDrawnAsPoints) {
  set_modes(GL_POINT, GL_POINT);
  add_run(GL_QUADS, {true, false, false, true});
  EXPECT_EQ(expand().indices, (Indices{0, 3}));
}

TEST_F(Unfilled, EdgeFlagsAreIgnoredInStripsAndFans) {
  set_modes(GL_LINE, GL_LINE);
  for (const GLenum mode :
       {GLenum{GL_TRIANGLE_STRIP}, GLenum{GL_TRIANGLE_FAN}, GLenum{GL_QUAD_STRIP}}) {
    runs_.clear();
    add_run(mode, std::vector<bool>(4, true));
    const std::size_t count = expand().indices.size();
    runs_.clear();
    add_run(mode, std::vector<bool>(4, false));
    EXPECT_EQ(expand().indices.size(), count) << mode;
  }
}

TEST_F(Unfilled, ElementsNameTheVertices) {
  set_modes(GL_LINE, GL_LINE);
  add_run(GL_POINTS, 9);
  elements_ = {0, 8, 6, 7};
  runs_ = {{GL_TRIANGLES, 1, 3, true}};
  EXPECT_EQ(expand().indices, (Indices{7, 8, 8, 6, 6, 7}));
}

TEST_F(Unfilled, LinesAndPointsStayAsTheyAreAndInTheirPlace) {
  set_modes(GL_LINE, GL_LINE);
  add_run(GL_LINE_STRIP, 3);
  add_run(GL_LINE_STRIP, 2);
  add_run(GL_TRIANGLES, 3);
  add_run(GL_LINES, 2);
  add_run(GL_POINTS, 1);
  expand();
  EXPECT_EQ(expanded_.groups, (std::vector<PrimitiveGroup>{{GL_LINE_STRIP, false, 0, 3},
                                                           {GL_LINE_STRIP, false, 3, 2},
                                                           {GL_LINES, false, 5, 8},
                                                           {GL_POINTS, false, 13, 1}}));
}

TEST_F(Unfilled, EachFaceHasItsModeAndTheOrderIsKept) {
  set_modes(GL_LINE, GL_FILL);
  add_run(GL_TRIANGLES, 3);
  add_run(GL_POINTS, 3);
  elements_ = {0, 1, 2, 0, 2, 1, 2, 1, 0, 0, 1, 2};
  runs_ = {{GL_TRIANGLES, 0, 12, true}};
  expand();
  const std::vector<PrimitiveGroup> groups{
      {GL_LINES, false, 0, 6}, {GL_TRIANGLES, false, 6, 6}, {GL_LINES, false, 12, 6}};
  EXPECT_EQ(expanded_.groups, groups);

  state_.polygon.front_face = GL_CW;
  set_modes(GL_FILL, GL_LINE);
  expand();
  EXPECT_EQ(expanded_.groups, groups);
}

TEST_F(Unfilled, CulledFacesAreNotDrawn) {
  set_modes(GL_LINE, GL_POINT);
  add_run(GL_TRIANGLES, 3);
  state_.polygon.cull_enabled = true;
  state_.polygon.cull_face = GL_BACK;
  EXPECT_EQ(expand().groups.size(), 1U);
  state_.polygon.cull_face = GL_FRONT;
  EXPECT_TRUE(expand().groups.empty());
  state_.polygon.front_face = GL_CW;
  ASSERT_EQ(expand().groups.size(), 1U);
  EXPECT_EQ(expanded_.groups[0].mode, GLenum{GL_POINTS});
  state_.polygon.cull_face = GL_FRONT_AND_BACK;
  EXPECT_TRUE(expand().groups.empty());
}

TEST_F(Unfilled, FacingIsThatOfTheVisiblePartWhereAVertexIsBehindTheEye) {
  set_modes(GL_LINE, GL_POINT);
  // Counter-clockwise on the floor y = -1, seen from above by an eye at the origin; one corner
  // behind it.
  state_.modelview_projection = glm::frustum(-1.0F, 1.0F, -1.0F, 1.0F, 1.0F, 100.0F);
  for (const glm::vec3 p : {glm::vec3(-5, -1, -9), glm::vec3(0, -1, 5), glm::vec3(5, -1, -9)}) {
    vertices_.insert(vertices_.end(), {p.x, p.y, p.z, 0, 0, 0, 1, 1});
  }
  runs_ = {{GL_TRIANGLES, 0, 3}};
  ASSERT_EQ(expand().groups.size(), 1U);
  EXPECT_EQ(expanded_.groups[0].mode, GLenum{GL_LINES});
}

TEST_F(Unfilled, BackFacesHaveTheirOwnGroupsOnlyWhenTheyHaveTheirOwnColours) {
  set_modes(GL_LINE, GL_LINE);
  add_run(GL_TRIANGLES, 3);
  elements_ = {0, 1, 2, 0, 2, 1};
  runs_ = {{GL_TRIANGLES, 0, 6, true}};
  EXPECT_EQ(expand().groups.size(), 1U);
  state_.two_side = true;
  EXPECT_EQ(expand().groups,
            (std::vector<PrimitiveGroup>{{GL_LINES, false, 0, 6}, {GL_LINES, true, 6, 6}}));
}

TEST_F(Unfilled, WithoutAreaATriangleIsABackFaceOfTheFrontColour) {
  set_modes(GL_LINE, GL_POINT);
  state_.two_side = true;
  add_run(GL_TRIANGLES, 3);
  // Far less than the window shows.
  for (unsigned k = 0; k < 3; ++k) vertices_[stride_ + k] = vertices_[k] + (k == 1 ? 1e-8F : 0);
  EXPECT_EQ(expand().groups, (std::vector<PrimitiveGroup>{{GL_POINTS, false, 0, 3}}));
  state_.polygon.cull_enabled = true;
  EXPECT_TRUE(expand().groups.empty());
}

TEST_F(Unfilled, FlatShadingGivesAllCornersTheProvokingVertex) {
  struct Case {
    GLenum mode;
    float provoking;
  };
  state_.flat = state_.lighting_position = true;
  set_modes(GL_LINE, GL_LINE);
  for (const Case& c :
       {Case{GL_TRIANGLES, 2}, Case{GL_QUADS, 3}, Case{GL_QUAD_STRIP, 3}, Case{GL_POLYGON, 0}}) {
    vertices_.clear();
    runs_.clear();
    add_run(c.mode, c.mode == GL_TRIANGLES ? 3 : 4);
    expand();
    ASSERT_TRUE(expanded_.own_vertices);
    const Indices numbers = vertex_numbers();
    const VertexOffsets offsets = offsets_of(expanded_.layout);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::uint32_t index = expanded_.indices[i];
      EXPECT_EQ(expanded_float(index, offsets.color), c.provoking) << "mode " << c.mode;
      const auto provoking = static_cast<std::size_t>(c.provoking);
      for (unsigned k = 0; k < 3; ++k)
        EXPECT_EQ(expanded_float(index, offsets.lighting_position + k),
                  vertices_[provoking * stride_ + k]);
    }
    // The positions stay those of the corners.
    if (c.mode == GL_QUADS) {
      EXPECT_EQ(numbers, (Indices{3, 0, 0, 1, 1, 2, 2, 3}));
    }
  }
  EXPECT_EQ(expanded_.layout.fields & kFieldEdgeFlag, 0);
}

struct UnfilledOffset : Unfilled {
  void SetUp() override {
    set_modes(GL_LINE, GL_LINE);
    state_.polygon.offset_line_enabled = true;
    state_.viewport.box = {0, 0, 200, 100};
    state_.depth_resolution = 1.0 / 1024;
    add_run(GL_TRIANGLES, 3);
  }
  // Of the first vertex, in window depth.
  double offset() {
    expand();
    return static_cast<double>(
               expanded_float(expanded_.indices[0], offsets_of(expanded_.layout).depth_offset)) *
           (state_.viewport.depth_far - state_.viewport.depth_near) / 2;
  }
};

TEST_F(UnfilledOffset, UnitsAreDepthSteps) {
  state_.polygon.offset_units = -3;
  EXPECT_DOUBLE_EQ(offset(), -3.0 / 1024);
  state_.viewport.depth_near = 0.5;
  EXPECT_DOUBLE_EQ(offset(), -3.0 / 1024);
}

TEST_F(UnfilledOffset, FactorScalesTheLargerSlope) {
  state_.polygon.offset_factor = 2;
  EXPECT_EQ(offset(), 0);
  // z = x / 4 and z = y / 4 in normalised device coordinates: in window depth per pixel.
  for (std::size_t i = 0; i < 3; ++i) vertices_[i * stride_ + 2] = vertices_[i * stride_] / 4;
  EXPECT_NEAR(offset(), 2 * 0.125 / 100, 1e-7);
  for (std::size_t i = 0; i < 3; ++i) vertices_[i * stride_ + 2] = vertices_[i * stride_ + 1] / 4;
  EXPECT_NEAR(offset(), 2 * 0.125 / 50, 1e-7);
}

TEST_F(UnfilledOffset, DepthStaysInTheDepthRange) {
  state_.polygon.offset_units = 1024;
  EXPECT_DOUBLE_EQ(offset(), 0.5);  // from the middle to the far end
}

TEST_F(UnfilledOffset, ConcernsItsOwnModeAlone) {
  state_.polygon.offset_units = -3;
  set_modes(GL_POINT, GL_POINT);
  EXPECT_EQ(expand().layout.fields & kFieldDepthOffset, 0);
}

}  // namespace

}  // namespace legacy_gl
