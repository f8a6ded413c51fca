// Which way a draw takes: every rule of choose_path, without a driver.
#include "submit/choose_path.hpp"

#include <gtest/gtest.h>

namespace legacy_gl {
namespace {

using Source = DrawRequest::Source;

DrawRequest batch() { return {.source = Source::kBatch, .has_polygons = true}; }
DrawRequest mesh() { return {.source = Source::kMesh, .has_polygons = true}; }
DrawRequest arrays() { return {.source = Source::kArrays, .has_polygons = true}; }

TEST(ChoosePath, ABatchIsDrawnAsItIs) { EXPECT_EQ(choose_path(batch(), {}), DrawPath::kBatch); }

TEST(ChoosePath, PolygonsThatBecomeLinesAreExpanded) {
  EXPECT_EQ(choose_path(batch(), {.unfilled = true}), DrawPath::kExpanded);
  DrawRequest lines{.source = Source::kBatch, .has_lines = true};
  EXPECT_EQ(choose_path(lines, {.unfilled = true}), DrawPath::kBatch);
  EXPECT_EQ(choose_path(lines, {.replaces_lines = true}), DrawPath::kExpanded);
  EXPECT_EQ(choose_path(batch(), {.replaces_lines = true}), DrawPath::kBatch);
}

TEST(ChoosePath, SelectionAndFeedbackDrawNothing) {
  EXPECT_EQ(choose_path(batch(), {.renders = false}), DrawPath::kCpuPipeline);
  EXPECT_EQ(choose_path(mesh(), {.renders = false}), DrawPath::kRecorder);
  DrawRequest direct = arrays();
  direct.fetched_by_driver = true;
  EXPECT_EQ(choose_path(direct, {.renders = false}), DrawPath::kRecorder);
}

TEST(ChoosePath, AMeshIsDrawnFromItsBuffers) {
  EXPECT_EQ(choose_path(mesh(), {}), DrawPath::kMesh);
  EXPECT_EQ(choose_path(mesh(), {.unfilled = true}), DrawPath::kRecorder);
  PathState without;
  without.paths.list_meshes = false;
  EXPECT_EQ(choose_path(mesh(), without), DrawPath::kRecorder);
}

TEST(ChoosePath, TinyNormalsGoThroughTheRecorderUnderNormalize) {
  DrawRequest tiny = mesh();
  tiny.has_tiny_normals = true;
  EXPECT_EQ(choose_path(tiny, {}), DrawPath::kMesh);
  EXPECT_EQ(choose_path(tiny, {.normalizes = true}), DrawPath::kRecorder);
}

TEST(ChoosePath, ArraysInBuffersAreDrawnFromThere) {
  DrawRequest direct = arrays();
  direct.fetched_by_driver = direct.many_and_dense = true;
  EXPECT_EQ(choose_path(direct, {}), DrawPath::kArraysDirect);
  EXPECT_EQ(choose_path(direct, {.unfilled = true}), DrawPath::kRecorder);
  PathState without;
  without.paths.arrays_direct = false;
  EXPECT_EQ(choose_path(direct, without), DrawPath::kArraysStreamed);
}

TEST(ChoosePath, ManyArrayVerticesAreStreamedAndFewRecorded) {
  EXPECT_EQ(choose_path(arrays(), {}), DrawPath::kRecorder);
  DrawRequest many = arrays();
  many.many_and_dense = true;
  EXPECT_EQ(choose_path(many, {}), DrawPath::kArraysStreamed);
  many.plain_quads = true;
  EXPECT_EQ(choose_path(many, {}), DrawPath::kRecorder);
  many.plain_quads = false;
  many.has_tiny_normals = true;
  EXPECT_EQ(choose_path(many, {.normalizes = true}), DrawPath::kRecorder);
  PathState without;
  without.paths.arrays_streamed = false;
  EXPECT_EQ(choose_path(arrays(), without), DrawPath::kRecorder);
}

TEST(OptionalPaths, AreTurnedOffByName) {
  std::string unknown;
  for (const OptionalPathInfo& info : optional_path_table()) {
    const OptionalPaths paths = without_paths(info.name, unknown);
    for (const OptionalPathInfo& other : optional_path_table())
      EXPECT_EQ(paths.*other.value, other.value != info.value) << info.name << ' ' << other.name;
  }
  EXPECT_FALSE(without_paths("all", unknown).list_meshes);
  EXPECT_EQ(unknown, "");
  EXPECT_TRUE(without_paths("mesh,,lists", unknown).list_meshes);
  EXPECT_EQ(unknown, "mesh, lists");
}

}  // namespace
}  // namespace legacy_gl
