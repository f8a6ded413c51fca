// Which way a draw takes: every rule of choose_path, without a driver.
#include "submit/choose_path.hpp"

#include <gtest/gtest.h>

#include <string>

namespace legacy_gl {
namespace {

using Source = DrawRequest::Source;

DrawRequest batch() { return {.source = Source::kBatch, .has_polygons = true}; }
DrawRequest mesh() { return {.source = Source::kMesh, .has_polygons = true}; }
DrawRequest arrays() { return {.source = Source::kArrays, .has_polygons = true}; }
DrawPath path_of(const DrawRequest& request, const PathState& state) {
  return choose_path(request, state).path;
}

TEST(ChoosePath, ABatchIsDrawnAsItIs) { EXPECT_EQ(path_of(batch(), {}), DrawPath::kBatch); }

TEST(ChoosePath, PolygonsThatBecomeLinesAreExpanded) {
  EXPECT_EQ(path_of(batch(), {.unfilled = true}), DrawPath::kExpanded);
  DrawRequest lines{.source = Source::kBatch, .has_lines = true};
  EXPECT_EQ(path_of(lines, {.unfilled = true}), DrawPath::kBatch);
  EXPECT_EQ(path_of(lines, {.replaces_lines = true}), DrawPath::kExpanded);
  EXPECT_EQ(path_of(batch(), {.replaces_lines = true}), DrawPath::kBatch);
}

TEST(ChoosePath, SelectionAndFeedbackDrawNothing) {
  EXPECT_EQ(path_of(batch(), {.renders = false}), DrawPath::kCpuPipeline);
  EXPECT_EQ(path_of(mesh(), {.renders = false}), DrawPath::kRecorder);
  DrawRequest direct = arrays();
  direct.fetched_by_driver = true;
  EXPECT_EQ(path_of(direct, {.renders = false}), DrawPath::kRecorder);
}

TEST(ChoosePath, AMeshIsDrawnFromItsBuffers) {
  EXPECT_EQ(path_of(mesh(), {}), DrawPath::kMesh);
  EXPECT_EQ(path_of(mesh(), {.unfilled = true}), DrawPath::kRecorder);
  PathState without;
  without.paths.list_meshes = false;
  EXPECT_EQ(path_of(mesh(), without), DrawPath::kRecorder);
}

TEST(ChoosePath, TinyNormalsGoThroughTheRecorderUnderNormalize) {
  DrawRequest tiny = mesh();
  tiny.has_tiny_normals = true;
  EXPECT_EQ(path_of(tiny, {}), DrawPath::kMesh);
  EXPECT_EQ(path_of(tiny, {.normalizes = true}), DrawPath::kRecorder);
}

TEST(ChoosePath, ArraysInBuffersAreDrawnFromThere) {
  DrawRequest direct = arrays();
  direct.fetched_by_driver = direct.many_and_dense = true;
  EXPECT_EQ(path_of(direct, {}), DrawPath::kArraysDirect);
  EXPECT_EQ(path_of(direct, {.unfilled = true}), DrawPath::kRecorder);
  PathState without;
  without.paths.arrays_direct = false;
  EXPECT_EQ(path_of(direct, without), DrawPath::kArraysStreamed);
}

TEST(ChoosePath, ManyArrayVerticesAreStreamedAndFewRecorded) {
  EXPECT_EQ(path_of(arrays(), {}), DrawPath::kRecorder);
  DrawRequest many = arrays();
  many.many_and_dense = true;
  EXPECT_EQ(path_of(many, {}), DrawPath::kArraysStreamed);
  many.plain_quads = true;
  EXPECT_EQ(path_of(many, {}), DrawPath::kRecorder);
  many.plain_quads = false;
  many.has_tiny_normals = true;
  EXPECT_EQ(path_of(many, {.normalizes = true}), DrawPath::kRecorder);
  PathState without;
  without.paths.arrays_streamed = false;
  EXPECT_EQ(path_of(arrays(), without), DrawPath::kRecorder);
}

TEST(ChoosePath, SaysWhichRuleHasChosen) {
  DrawRequest request = arrays();
  const auto rule = [&request](const PathState& state) {
    return std::string(choose_path(request, state).rule);
  };
  EXPECT_NE(rule({.renders = false}).find("glRenderMode"), std::string::npos);
  EXPECT_NE(rule({.unfilled = true}).find("glPolygonMode"), std::string::npos);
  EXPECT_NE(rule({}).find("few"), std::string::npos);
  request.many_and_dense = true;
  EXPECT_NE(rule({}).find("many"), std::string::npos);
  PathState without;
  without.paths.arrays_streamed = false;
  EXPECT_NE(rule(without).find("arrays_streamed"), std::string::npos);
  request = mesh();
  without.paths.list_meshes = false;
  EXPECT_NE(rule(without).find("list_meshes"), std::string::npos);
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
