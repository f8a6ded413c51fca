// Display lists without a driver: what is recorded and played, and what becomes a mesh.
#include <array>

#include "recording_context.hpp"

namespace legacy_gl::test {
namespace {

using Floats = std::vector<float>;
using Indices = std::vector<std::uint32_t>;

class DisplayListTest : public RecordingTest {
 protected:
  template <typename Commands>
  void compile(GLuint name, Commands commands) {
    lglNewList(name, GL_COMPILE);
    commands();
    lglEndList();
    ASSERT_EQ(take_error(), GLenum{GL_NO_ERROR});
  }
  /// What glCallList hands to the renderer.
  void call(GLuint name) {
    renderer.batches.clear();
    renderer.meshes.clear();
    lglCallList(name);
    flush_pending(context);
  }
};

/// A vertex with all that makes it itself.
void corner(float x, float y) {
  lglNormal3f(0, 0, 1);
  lglVertex3f(x, y, 0);
}

void square() {
  lglBegin(GL_TRIANGLES);
  corner(0, 0), corner(1, 0), corner(1, 1);
  corner(0, 0), corner(1, 1), corner(0, 1);
  lglEnd();
}

Floats vertex_of(const ListMesh& mesh, std::size_t i) {
  const unsigned stride = offsets_of(mesh.layout).stride;
  const auto begin = mesh.vertices.begin() + static_cast<std::ptrdiff_t>(i * stride);
  return {begin, begin + stride};
}

TEST_F(DisplayListTest, CompilingChangesNothing) {
  compile(1, [] {
    lglShadeModel(GL_FLAT);
    lglColor3f(1, 0, 0);
    lglEnable(GL_FOG);
    primitive(GL_TRIANGLES, 3);
  });
  EXPECT_EQ(context.lighting.shade_model, GLenum{GL_SMOOTH});
  EXPECT_EQ(context.current.color, glm::vec4(1));
  EXPECT_FALSE(context.fog.enabled);
  EXPECT_FALSE(context.recorder.has_pending());
  call(1);
  EXPECT_EQ(context.lighting.shade_model, GLenum{GL_FLAT});
  EXPECT_EQ(context.current.color, glm::vec4(1, 0, 0, 1));
  EXPECT_TRUE(context.fog.enabled);
}

TEST_F(DisplayListTest, CompileAndExecuteDoesBoth) {
  lglNewList(1, GL_COMPILE_AND_EXECUTE);
  lglColor3f(0, 1, 0);
  square();
  EXPECT_EQ(context.current.color, glm::vec4(0, 1, 0, 1));
  EXPECT_TRUE(context.recorder.has_pending());
  lglEndList();
  EXPECT_EQ(drawn().at(0).vertex_count(), 6u);
  lglColor3f(0, 0, 0);
  call(1);
  ASSERT_EQ(renderer.meshes.size(), 1u);
  EXPECT_EQ(context.current.color, glm::vec4(0, 1, 0, 1));
}

// GL 2.1 spec 5.4: an error of a command belongs to the call of the list.
TEST_F(DisplayListTest, ErrorsComeWithTheCall) {
  compile(1, [] {
    lglShadeModel(GL_TRIANGLES);
    lglShadeModel(GL_FLAT);
  });
  call(1);
  EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
  EXPECT_EQ(context.lighting.shade_model, GLenum{GL_FLAT});
}

TEST_F(DisplayListTest, ListsAreBegunAndEndedInTheirOrder) {
  lglEndList();
  EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
  lglNewList(0, GL_COMPILE);
  EXPECT_EQ(take_error(), GLenum{GL_INVALID_VALUE});
  lglNewList(1, GL_FLAT);
  EXPECT_EQ(take_error(), GLenum{GL_INVALID_ENUM});
  lglNewList(1, GL_COMPILE);
  lglNewList(2, GL_COMPILE);
  EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
  EXPECT_FALSE(lglIsList(1));  // not before glEndList
  lglEndList();
  EXPECT_TRUE(lglIsList(1));
}

TEST_F(DisplayListTest, ListsCallLists) {
  compile(1, [] { lglColor3f(1, 0, 0); });
  compile(2, [] {
    lglCallList(1);
    lglFogf(GL_FOG_DENSITY, 0.5f);
  });
  call(2);
  EXPECT_EQ(context.current.color, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(context.fog.density, 0.5f);
  compile(1, [] { lglColor3f(0, 0, 1); });  // list 2 names it
  call(2);
  EXPECT_EQ(context.current.color, glm::vec4(0, 0, 1, 1));
  lglDeleteLists(1, 1);
  lglColor3f(1, 1, 1);
  call(2);
  EXPECT_EQ(context.current.color, glm::vec4(1));
}

TEST_F(DisplayListTest, ACallIsRecordedAsACall) {
  compile(1, [] { lglColor3f(1, 0, 0); });
  lglNewList(2, GL_COMPILE_AND_EXECUTE);
  lglCallList(1);
  lglEndList();
  EXPECT_EQ(context.current.color, glm::vec4(1, 0, 0, 1));
  compile(1, [] { lglColor3f(0, 1, 0); });
  call(2);
  EXPECT_EQ(context.current.color, glm::vec4(0, 1, 0, 1));
}

TEST_F(DisplayListTest, NestingEnds) {
  compile(1, [] {
    lglTranslatef(1, 0, 0);
    lglCallList(1);
  });
  call(1);
  EXPECT_EQ(context.list_modes.nesting, 0u);
  EXPECT_EQ(context.transform.modelview.top().single[3][0], float{ListModes::kMaxNesting});
}

TEST_F(DisplayListTest, CallListsAddsTheBase) {
  for (GLuint name : {11u, 12u, 267u})
    compile(name, [name] { lglTranslatef(static_cast<float>(name), 0, 0); });
  lglListBase(10);
  const GLubyte names[] = {1, 2, 1, 1};
  lglCallLists(2, GL_UNSIGNED_BYTE, names);
  EXPECT_EQ(context.transform.modelview.top().single[3][0], 23);
  lglCallLists(1, GL_2_BYTES, names + 2);
  EXPECT_EQ(context.transform.modelview.top().single[3][0], 290);
}

TEST_F(DisplayListTest, EqualVerticesAreShared) {
  compile(1, square);
  call(1);
  EXPECT_TRUE(renderer.batches.empty());
  ASSERT_EQ(renderer.meshes.size(), 1u);
  const ListMesh& mesh = *renderer.meshes[0];
  EXPECT_EQ(mesh.layout.fields, kFieldNormal);
  EXPECT_EQ(mesh.vertex_count(), 4u);
  EXPECT_EQ(mesh.welded, 2u);
  EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(vertex_of(mesh, 3), (Floats{0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(mesh.highest, glm::vec3(1, 1, 0));
  EXPECT_TRUE(mesh.unit_normals);
}

TEST_F(DisplayListTest, VerticesThatDifferInAnAttributeAreNot) {
  compile(1, [] {
    lglBegin(GL_TRIANGLES);
    for (float z : {1.0f, -1.0f}) {
      lglNormal3f(0, 0, z);
      vertices_in_a_row(3);
    }
    lglEnd();
  });
  call(1);
  EXPECT_EQ(renderer.meshes.at(0)->vertex_count(), 6u);
}

TEST_F(DisplayListTest, PairsJoinOneMesh) {
  compile(1, [] {
    square();
    lglNormal3f(0, 0, 1);  // between pairs attributes may be set
    square();
    lglBegin(GL_QUADS);
    corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1);
    lglEnd();
  });
  call(1);
  ASSERT_EQ(renderer.meshes.size(), 1u);
  const ListMesh& mesh = *renderer.meshes[0];
  EXPECT_EQ(mesh.vertex_count(), 4u);
  ASSERT_EQ(mesh.draws.size(), 1u);  // quads are triangles to the driver
  EXPECT_EQ(mesh.draws[0].mode, GLenum{GL_TRIANGLES});
  EXPECT_EQ(mesh.draws[0].count, 18u);
  ASSERT_EQ(mesh.runs.size(), 3u);  // and stay quads where they are drawn as lines
  EXPECT_EQ(mesh.runs[2].mode, GLenum{GL_QUADS});
}

TEST_F(DisplayListTest, StripsKeepTheirOrder) {
  compile(1, [] {
    lglColor3f(1, 1, 1);
    for (int strip = 0; strip < 2; ++strip) {
      lglBegin(GL_TRIANGLE_STRIP);
      vertices_in_a_row(4);
      lglEnd();
    }
  });
  call(1);
  const ListMesh& mesh = *renderer.meshes.at(0);
  EXPECT_EQ(mesh.vertex_count(), 8u);
  EXPECT_EQ(mesh.firsts, (std::vector<GLint>{0, 4}));
  EXPECT_EQ(mesh.counts, (std::vector<GLsizei>{4, 4}));
  ASSERT_EQ(mesh.draws.size(), 1u);
  EXPECT_FALSE(mesh.draws[0].indexed);
}

TEST_F(DisplayListTest, AChangeOfStateBeginsAnotherMesh) {
  compile(1, [] {
    square();
    lglEnable(GL_BLEND);
    square();
  });
  call(1);
  EXPECT_EQ(renderer.meshes.size(), 2u);
  EXPECT_TRUE(context.raster.color_buffer.blend_enabled);
}

TEST_F(DisplayListTest, AttributesOfAMeshStayCurrent) {
  compile(1, [] {
    lglBegin(GL_LINES);
    lglColor3f(1, 0, 0);
    lglTexCoord2f(1, 2);
    vertices_in_a_row(1);
    lglColor3f(0, 1, 0);
    vertices_in_a_row(1, 1);
    lglTexCoord2f(3, 4);
    lglEnd();
  });
  call(1);
  EXPECT_EQ(renderer.meshes.size(), 1u);
  EXPECT_EQ(context.current.color, glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(context.current.texture_coordinates[0], glm::vec4(3, 4, 0, 1));
}

TEST_F(DisplayListTest, IncompletePrimitivesAddNothing) {
  compile(1, [] {
    lglColor3f(1, 1, 1);
    lglBegin(GL_TRIANGLES);
    vertices_in_a_row(5);
    lglEnd();
  });
  call(1);
  EXPECT_EQ(renderer.meshes.at(0)->vertex_count(), 3u);
}

// The value that no command of the list has set is the one of the call.
TEST_F(DisplayListTest, AttributesThatTheListDoesNotSetAreTheCalls) {
  compile(1, square);
  lglColor3f(0, 1, 0);
  call(1);
  EXPECT_EQ(renderer.colors_of_meshes.at(0), glm::vec4(0, 1, 0, 1));
  EXPECT_FALSE(renderer.meshes.at(0)->layout.fields & kFieldColor);
}

/// What a mesh cannot hold, each between glBegin and glEnd.
struct Unweldable {
  const char* name;
  void (*commands)();
};
void PrintTo(const Unweldable& unweldable, std::ostream* out) { *out << unweldable.name; }
class UnweldableTest : public RecordingTest, public testing::WithParamInterface<Unweldable> {};

TEST_P(UnweldableTest, StaysAsCommands) {
  const auto pair = [] {
    lglBegin(GL_LINES);
    vertices_in_a_row(1);
    GetParam().commands();
    vertices_in_a_row(1, 1);
    lglEnd();
  };
  lglEnable(GL_LIGHTING);
  lglEnable(GL_COLOR_MATERIAL);
  enable_texture();
  lglNewList(1, GL_COMPILE);
  pair();
  lglEndList();
  lglCallList(1);
  flush_pending(context);
  EXPECT_TRUE(renderer.meshes.empty());
  const DrawnBatch played = renderer.batches.at(0);

  // It is what the commands draw at once.
  context.current = {};
  context.lighting.materials = {};
  renderer.batches.clear();
  pair();
  flush_pending(context);
  EXPECT_EQ(renderer.batches.at(0).layout, played.layout);
  EXPECT_EQ(renderer.batches.at(0).vertices, played.vertices);
  EXPECT_EQ(played.position(played.vertex_count() - 1)[0], 1);
}

constexpr std::array<float, 4> kGlow{1, 0, 0, 1};
const Unweldable kUnweldables[] = {
    {"ColorAfterTheFirstVertex", [] { lglColor3f(1, 0, 0); }},
    {"NormalAfterTheFirstVertex", [] { lglNormal3f(1, 0, 0); }},
    {"WideTexcoordAfterTheFirstVertex", [] { lglTexCoord4f(1, 2, 3, 4); }},
    {"Material", [] { lglMaterialfv(GL_FRONT, GL_EMISSION, kGlow.data()); }},
    {"EdgeFlag", [] { lglEdgeFlag(GL_FALSE); }},
    {"VertexW", [] { lglVertex4f(5, 6, 7, 2), lglVertex4f(1, 2, 3, 0.5f); }},
    {"CallOfAList", [] { lglCallList(77); }},
};
INSTANTIATE_TEST_SUITE_P(Commands, UnweldableTest, testing::ValuesIn(kUnweldables),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST_F(DisplayListTest, AfterWhatStaysAsCommandsAnotherMeshBegins) {
  compile(1, [] {
    square();
    lglBegin(GL_LINES);
    lglVertex4f(0, 0, 0, 2);
    lglVertex4f(1, 0, 0, 2);
    lglEnd();
    square();
  });
  call(1);
  EXPECT_EQ(renderer.meshes.size(), 2u);
  ASSERT_EQ(renderer.batches.size(), 1u);
  EXPECT_EQ(renderer.batches[0].position(0), (Floats{0, 0, 0, 2}));
}

TEST_F(DisplayListTest, APrimitiveMayLieInTwoLists) {
  compile(1, [] { lglBegin(GL_LINES); });
  compile(2, [] {
    vertices_in_a_row(2);
    lglEnd();
  });
  lglCallList(1);
  EXPECT_TRUE(context.recorder.inside_begin_end());
  lglCallList(2);
  EXPECT_EQ(drawn().at(0).vertex_count(), 2u);
}

TEST_F(DisplayListTest, AMeshInsideBeginEndIsAnError) {
  compile(1, square);
  lglBegin(GL_LINES);
  lglCallList(1);
  EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
  EXPECT_TRUE(renderer.meshes.empty());
}

// GL 2.1 spec 5.4: arrays are read when the list is compiled.
TEST_F(DisplayListTest, ArraysAreCopied) {
  std::array<float, 9> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  lglVertexPointer(3, GL_FLOAT, 0, positions.data());
  lglEnableClientState(GL_VERTEX_ARRAY);
  compile(1, [] { lglDrawArrays(GL_TRIANGLES, 0, 3); });
  const std::array<GLubyte, 3> elements{2, 1, 0};
  compile(2, [&] { lglDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, elements.data()); });
  positions.fill(9);
  call(1);
  EXPECT_EQ(renderer.batches.at(0).position(1), (Floats{1, 0, 0}));
  call(2);
  EXPECT_EQ(renderer.batches.at(0).position(1), (Floats{1, 0, 0}));
  EXPECT_EQ(renderer.batches.at(0).elements, (Indices{2, 1, 0}));
}

TEST_F(DisplayListTest, LongArraysBecomeAMesh) {
  std::vector<float> positions(300);
  for (std::size_t i = 0; i < 300; ++i) positions[i] = static_cast<float>(i);
  lglVertexPointer(3, GL_FLOAT, 0, positions.data());
  lglEnableClientState(GL_VERTEX_ARRAY);
  compile(1, [] { lglDrawArrays(GL_QUADS, 0, 100); });
  call(1);
  const ListMesh& mesh = *renderer.meshes.at(0);
  EXPECT_EQ(mesh.vertices, positions);
  EXPECT_EQ(mesh.indices.size(), 150u);
  EXPECT_EQ(mesh.runs.at(0).mode, GLenum{GL_QUADS});
}

TEST(ListNames, GenerateFindsRowsOfUnusedNames) {
  ListNames names;
  const auto list = std::make_shared<const DisplayList>();
  EXPECT_EQ(names.generate(3, list), 1u);
  names.store(6, list);
  EXPECT_EQ(names.generate(3, list), 7u);
  EXPECT_EQ(names.generate(2, list), 4u);
  names.erase(2, 3);
  EXPECT_TRUE(names.contains(1));
  EXPECT_FALSE(names.contains(4));
  EXPECT_TRUE(names.contains(5));
  names.store(0xffffffffu, list);
  names.erase(1, 0xfffffffeu);
  EXPECT_EQ(names.generate(2, list), 1u);
  EXPECT_EQ(names.generate(0xffffffffu, list), 0u);
}

}  // namespace
}  // namespace legacy_gl::test
