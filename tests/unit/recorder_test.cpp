// The recorder of Begin/End and of client arrays, without a driver.
#include <array>
#include <cstddef>

#include "record/array_submit.hpp"
#include "recording_context.hpp"

namespace legacy_gl::test {
namespace {

using Floats = std::vector<float>;

class RecorderTest : public RecordingTest {};

TEST_F(RecorderTest, NeutralPairsJoinOneBatch) {
  primitive(GL_TRIANGLES, 3);
  lglColor3f(1, 0, 0);
  lglNormal3f(0, 1, 0);
  primitive(GL_TRIANGLES, 6, 3);
  lglTexCoord2f(1, 2);
  primitive(GL_TRIANGLE_STRIP, 4, 9);
  primitive(GL_TRIANGLE_STRIP, 4, 13);
  EXPECT_TRUE(renderer.batches.empty());
  ASSERT_EQ(drawn().size(), 1u);
  const DrawnBatch& batch = drawn()[0];
  EXPECT_EQ(batch.vertex_count(), 17u);
  // Independent primitives join one run; each strip is one of its own.
  ASSERT_EQ(batch.runs.size(), 3u);
  EXPECT_EQ(batch.runs[0].count, 9u);
  EXPECT_EQ(batch.runs[1].first, 9u);
  EXPECT_EQ(batch.runs[2].first, 13u);
  EXPECT_EQ(batch.color(2), (Floats{1, 1, 1, 1}));
  EXPECT_EQ(batch.color(3), (Floats{1, 0, 0, 1}));
  EXPECT_EQ(context.statistics.begin_end_merged, 3u);
}

TEST_F(RecorderTest, LayoutIsWhatTheStateReads) {
  primitive(GL_POINTS, 1);
  EXPECT_EQ(drawn().back().layout.fields, kFieldColor);
  lglEnable(GL_LIGHTING);
  primitive(GL_POINTS, 1);
  EXPECT_EQ(drawn().back().layout.fields, kFieldNormal);
  lglEnable(GL_COLOR_MATERIAL);
  primitive(GL_POINTS, 1);
  EXPECT_EQ(drawn().back().layout.fields, kFieldNormal | kFieldColor);
  lglDisable(GL_LIGHTING);
  lglEnable(GL_COLOR_SUM);
  primitive(GL_POINTS, 1);
  EXPECT_EQ(drawn().back().layout.fields, kFieldColor | kFieldSecondaryColor);
  lglPolygonMode(GL_FRONT, GL_LINE);
  primitive(GL_POINTS, 1);
  EXPECT_TRUE(drawn().back().layout.fields & kFieldEdgeFlag);
}

TEST_F(RecorderTest, AStateChangeEndsTheBatch) {
  primitive(GL_TRIANGLES, 3);
  lglShadeModel(GL_FLAT);
  EXPECT_EQ(renderer.batches.size(), 1u);
  primitive(GL_TRIANGLES, 3);
  lglDepthFunc(GL_GREATER);
  EXPECT_EQ(renderer.batches.size(), 2u);
  primitive(GL_TRIANGLES, 3);
  lglTranslatef(1, 0, 0);
  EXPECT_EQ(renderer.batches.size(), 3u);
  lglEnable(GL_BLEND);  // nothing waits
  EXPECT_EQ(renderer.batches.size(), 3u);
}

TEST_F(RecorderTest, MaterialInsideBeginEndWidensTheLayout) {
  lglEnable(GL_LIGHTING);
  lglBegin(GL_TRIANGLES);
  vertices_in_a_row(2);
  const float red[] = {1, 0, 0, 0.5f};
  lglMaterialfv(GL_FRONT, GL_DIFFUSE, red);
  lglNormal3f(0, 1, 0);
  vertices_in_a_row(1, 2);
  lglMaterialf(GL_BACK, GL_SHININESS, 7);
  vertices_in_a_row(3, 3);
  lglEnd();
  const DrawnBatch& batch = drawn().at(0);
  EXPECT_EQ(batch.layout.materials,
            material_bit(kFront, kDiffuse) | material_bit(kBack, kShininess));
  ASSERT_EQ(batch.vertex_count(), 6u);
  for (unsigned i = 0; i < 6; ++i) {
    EXPECT_EQ(batch.position(i), (Floats{static_cast<float>(i), 0, 0}));
    EXPECT_EQ(batch.normal(i), i < 2 ? (Floats{0, 0, 1}) : (Floats{0, 1, 0}));
    EXPECT_EQ(batch.material(i, kFront, kDiffuse),
              i < 2 ? (Floats{0.8f, 0.8f, 0.8f, 1}) : (Floats{1, 0, 0, 0.5f}));
    EXPECT_EQ(batch.material(i, kBack, kShininess), (Floats{i < 3 ? 0.0f : 7.0f}));
  }
}

// From the fourth on: then it pays to try.
TEST_F(RecorderTest, SmallObjectsThatDifferInMaterialsJoin) {
  lglEnable(GL_LIGHTING);
  constexpr int kObjects = 12;
  for (int i = 0; i < kObjects; ++i) {
    const float color[] = {static_cast<float>(i), 0, 0, 1};
    lglMaterialfv(GL_FRONT, GL_EMISSION, color);
    primitive(GL_TRIANGLES, 3, 3 * i);
  }
  ASSERT_LT(drawn().size(), 7u);
  ASSERT_GT(drawn().back().layout.materials & material_bit(kFront, kEmission), 0);
  int object = kObjects;
  const DrawnBatch& last = drawn().back();
  for (std::size_t vertex = last.vertex_count(); vertex > 0; vertex -= 3) {
    --object;
    EXPECT_EQ(last.material(vertex - 1, kFront, kEmission),
              (Floats{static_cast<float>(object), 0, 0}));
    EXPECT_EQ(last.position(vertex - 1)[0], static_cast<float>(3 * object + 2));
  }
}

TEST_F(RecorderTest, WideTextureCoordinates) {
  enable_texture();
  lglBegin(GL_LINES);
  lglTexCoord2f(0.25f, 0.5f);
  vertices_in_a_row(1);
  lglTexCoord4f(1, 2, 3, 4);
  vertices_in_a_row(1, 1);
  lglTexCoord2f(5, 6);
  vertices_in_a_row(2, 2);
  lglEnd();
  const DrawnBatch& batch = drawn().at(0);
  EXPECT_EQ(batch.layout.texcoords, 1);
  EXPECT_EQ(batch.layout.wide_texcoords, 1);
  const unsigned at = batch.offsets.texcoords[0];
  EXPECT_EQ(batch.floats(0, at, 4), (Floats{0.25f, 0.5f, 0, 1}));
  EXPECT_EQ(batch.floats(1, at, 4), (Floats{1, 2, 3, 4}));
  EXPECT_EQ(batch.floats(2, at, 4), (Floats{5, 6, 0, 1}));
  EXPECT_EQ(batch.position(3), (Floats{3, 0, 0}));

  primitive(GL_LINES, 2);
  EXPECT_EQ(drawn().at(1).layout.wide_texcoords, 0);
}

TEST_F(RecorderTest, AVertexW) {
  lglBegin(GL_LINES);
  lglVertex4f(1, 2, 3, 1);
  EXPECT_EQ(context.recorder.offsets().position_size, 3u);
  lglColor4f(1, 0, 0, 1);
  lglVertex4f(4, 5, 6, 2);
  lglVertex3f(7, 8, 9);
  lglVertex4f(1, 1, 1, 0);
  lglEnd();
  const DrawnBatch& batch = drawn().at(0);
  EXPECT_TRUE(batch.layout.fields & kFieldPositionW);
  EXPECT_EQ(batch.position(0), (Floats{1, 2, 3, 1}));
  EXPECT_EQ(batch.position(1), (Floats{4, 5, 6, 2}));
  EXPECT_EQ(batch.position(2), (Floats{7, 8, 9, 1}));
  EXPECT_EQ(batch.position(3), (Floats{1, 1, 1, 0}));
  EXPECT_EQ(batch.color(0), (Floats{1, 1, 1, 1}));
  EXPECT_EQ(batch.color(3), (Floats{1, 0, 0, 1}));
}

// GL 2.1 spec 2.6.1.
TEST_F(RecorderTest, IncompletePrimitivesAreDropped) {
  struct Case {
    GLenum mode;
    int given;
    std::uint32_t kept;
  };
  constexpr Case kCases[] = {
      {GL_POINTS, 1, 1},         {GL_LINES, 3, 2},        {GL_LINES, 1, 0},
      {GL_LINE_STRIP, 1, 0},     {GL_LINE_LOOP, 2, 2},    {GL_TRIANGLES, 5, 3},
      {GL_TRIANGLE_STRIP, 2, 0}, {GL_TRIANGLE_FAN, 3, 3}, {GL_QUADS, 7, 4},
      {GL_QUAD_STRIP, 5, 4},     {GL_QUAD_STRIP, 3, 0},   {GL_POLYGON, 2, 0},
  };
  for (const Case& c : kCases) {
    renderer.batches.clear();
    primitive(c.mode, c.given);
    const std::size_t kept = drawn().empty() ? 0 : drawn()[0].vertex_count();
    EXPECT_EQ(kept, c.kept) << "mode " << c.mode << " of " << c.given;
  }
  // The next primitive begins where the last whole one ended.
  renderer.batches.clear();
  primitive(GL_TRIANGLES, 4);
  primitive(GL_TRIANGLES, 3, 10);
  EXPECT_EQ(drawn().at(0).vertex_count(), 6u);
  EXPECT_EQ(drawn().at(0).position(3)[0], 10);
}

TEST_F(RecorderTest, VerticesOutsideBeginEndAreIgnored) {
  vertices_in_a_row(3);
  lglVertex4f(0, 0, 0, 2);
  EXPECT_TRUE(drawn().empty());
  lglEnd();
  EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
}

// Each part has whole primitives, and together they are all of them in their order.
TEST_F(RecorderTest, LongPrimitivesAreDrawnInParts) {
  for (const auto& [mode, size] : {std::pair{GL_TRIANGLES, 3}, {GL_LINES, 2}, {GL_POINTS, 1}}) {
    renderer.batches.clear();
    constexpr int kVertices = 60000;
    lglBegin(static_cast<GLenum>(mode));
    vertices_in_a_row(kVertices);
    EXPECT_GT(renderer.batches.size(), 2u);
    lglEnd();
    int next = 0;
    for (const DrawnBatch& batch : drawn()) {
      EXPECT_EQ(batch.vertex_count() % static_cast<unsigned>(size), 0u);
      for (std::size_t i = 0; i < batch.vertex_count(); ++i)
        ASSERT_EQ(batch.position(i)[0], static_cast<float>(next++));
    }
    EXPECT_EQ(next, kVertices);
  }
}

TEST_F(RecorderTest, ALongPrimitiveGoesOnInTheLayoutThatItHad) {
  lglEnable(GL_LIGHTING);
  lglBegin(GL_TRIANGLES);
  const float glow[] = {0, 1, 0, 1};
  vertices_in_a_row(1);
  lglMaterialfv(GL_FRONT, GL_EMISSION, glow);
  vertices_in_a_row(29999, 1);
  lglEnd();
  ASSERT_GT(drawn().size(), 1u);
  const DrawnBatch& first = drawn().front();
  EXPECT_EQ(first.material(0, kFront, kEmission), (Floats{0, 0, 0}));
  EXPECT_EQ(first.material(1, kFront, kEmission), (Floats{0, 1, 0}));
  const DrawnBatch& last = drawn().back();
  EXPECT_EQ(last.position(last.vertex_count() - 1)[0], 29999);
}

// A strip is drawn in one piece, however long: the storage grows with it.
TEST_F(RecorderTest, StorageGrows) {
  constexpr int kVertices = 100000;
  lglBegin(GL_TRIANGLE_STRIP);
  vertices_in_a_row(kVertices / 2);
  lglColor4f(0, 1, 0, 1);
  lglVertex4f(kVertices / 2, 0, 0, 2);  // widens what is there
  vertices_in_a_row(kVertices / 2 - 1, kVertices / 2 + 1);
  lglEnd();
  ASSERT_EQ(renderer.batches.size(), 1u);  // large: drawn at glEnd
  const DrawnBatch& batch = renderer.batches[0];
  ASSERT_EQ(batch.vertex_count(), static_cast<std::size_t>(kVertices));
  for (std::size_t i = 0; i < kVertices; ++i) {
    ASSERT_EQ(batch.position(i)[0], static_cast<float>(i));
    ASSERT_EQ(batch.color(i)[0], i < kVertices / 2 ? 1 : 0);
  }
}

TEST_F(RecorderTest, WithoutARendererBatchesAreForgotten) {
  context.renderer = nullptr;
  primitive(GL_TRIANGLES, 3);
  flush_pending(context);
  EXPECT_FALSE(context.recorder.has_pending());
}

constexpr std::array<float, 15> kPositions{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
constexpr std::array<GLubyte, 20> kColors{255, 0, 0, 255, 0, 255, 0,   255, 0, 0,
                                          255, 0, 0, 0,   0, 0,   255, 255, 0, 255};

ArrayView view_of(const void* data, GLenum type, unsigned size, std::size_t stride) {
  return {static_cast<const std::byte*>(data), stride, type, size, 5};
}

ArrayViews positions_and_colors() {
  ArrayViews views;
  views[kVertexArray] = view_of(kPositions.data(), GL_FLOAT, 3, 12);
  views[kColorArray] = view_of(kColors.data(), GL_UNSIGNED_BYTE, 4, 4);
  return views;
}

TEST_F(RecorderTest, ArraysJoinTheBatch) {
  primitive(GL_POINTS, 1);
  const ArrayViews views = positions_and_colors();
  submit_arrays(context, views, GL_POINTS, 1, 2);
  EXPECT_TRUE(renderer.batches.empty());
  const DrawnBatch& batch = drawn().at(0);
  ASSERT_EQ(batch.vertex_count(), 3u);
  EXPECT_EQ(batch.runs.size(), 1u);
  EXPECT_EQ(batch.position(1), (Floats{3, 4, 5}));
  EXPECT_EQ(batch.color(1), (Floats{0, 1, 0, 1}));
  EXPECT_EQ(batch.color(2), (Floats{0, 0, 1, 0}));
}

TEST_F(RecorderTest, WhatNoArrayGivesIsTheCurrentValue) {
  lglColor4f(0.5f, 0, 0, 1);
  ArrayViews views = positions_and_colors();
  views[kColorArray] = {};
  submit_arrays(context, views, GL_LINE_STRIP, 0, 3);
  for (unsigned i = 0; i < 3; ++i) EXPECT_EQ(drawn().at(0).color(i), (Floats{0.5f, 0, 0, 1}));
}

TEST_F(RecorderTest, ArraysEndWhereTheirMemoryDoes) {
  const ArrayViews views = positions_and_colors();
  submit_arrays(context, views, GL_TRIANGLES, 1, 100);
  EXPECT_EQ(drawn().at(0).vertex_count(), 3u);
  submit_arrays(context, views, GL_TRIANGLES, 5, 3);
  submit_arrays(context, views, GL_TRIANGLES, 4, 3);
  EXPECT_EQ(drawn().size(), 1u);
}

TEST_F(RecorderTest, ArraysWithAW) {
  const std::array<double, 8> positions{1, 2, 3, 1, 4, 5, 6, 2};
  ArrayViews views;
  views[kVertexArray] = {reinterpret_cast<const std::byte*>(positions.data()), 32, GL_DOUBLE, 4, 2};
  submit_arrays(context, views, GL_POINTS, 0, 1);
  EXPECT_EQ(drawn().back().offsets.position_size, 3u);  // a w of 1 needs no room
  submit_arrays(context, views, GL_POINTS, 0, 2);
  EXPECT_EQ(drawn().back().position(1), (Floats{4, 5, 6, 2}));
}

TEST_F(RecorderTest, ElementsShareVertices) {
  const std::array<GLushort, 6> elements{2, 3, 4, 4, 3, 2};
  primitive(GL_TRIANGLES, 3);
  submit_elements(context, positions_and_colors(), GL_TRIANGLES,
                  {reinterpret_cast<const std::byte*>(elements.data()), GL_UNSIGNED_SHORT, 6});
  const DrawnBatch& batch = drawn().at(0);
  EXPECT_EQ(batch.vertex_count(), 6u);
  ASSERT_EQ(batch.runs.size(), 2u);
  EXPECT_TRUE(batch.runs[1].indexed);
  EXPECT_EQ(batch.elements, (std::vector<std::uint32_t>{3, 4, 5, 5, 4, 3}));
  EXPECT_EQ(batch.position(3), (Floats{6, 7, 8}));
}

// Past the end of the memory, and few of many: each is read by itself.
TEST_F(RecorderTest, FarElementsAreCopiedOneByOne) {
  const std::array<GLuint, 3> elements{4, 0, 1000000};
  submit_elements(context, positions_and_colors(), GL_TRIANGLES,
                  {reinterpret_cast<const std::byte*>(elements.data()), GL_UNSIGNED_INT, 3});
  const DrawnBatch& batch = drawn().at(0);
  ASSERT_EQ(batch.vertex_count(), 3u);
  EXPECT_TRUE(batch.elements.empty());
  EXPECT_EQ(batch.position(0), (Floats{12, 13, 14}));
  EXPECT_EQ(batch.position(1), (Floats{0, 1, 2}));
  EXPECT_EQ(batch.position(2), (Floats{0, 0, 0}));
}

}  // namespace
}  // namespace legacy_gl::test
