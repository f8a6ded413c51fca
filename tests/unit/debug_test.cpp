// What LEGACY_GL_DEBUG writes, as text.
#include <gtest/gtest.h>

#include "debug/call_log.hpp"
#include "debug/enum_names.hpp"
#include "state/gl_types.hpp"

namespace legacy_gl::debug {
namespace {

using Kind = Argument::Kind;

TEST(EnumNames, DependOnTheGroup) {
  EXPECT_EQ(enum_text("PrimitiveType", 4), "GL_TRIANGLES");
  EXPECT_EQ(enum_text("BlendingFactor", 1), "GL_ONE");
  EXPECT_EQ(enum_text("ErrorCode", GL_NO_ERROR), "GL_NO_ERROR");
  EXPECT_EQ(enum_text("LightName", GL_LIGHT7), "GL_LIGHT7");
}

TEST(EnumNames, OfTheVersionThatThisLibraryHas) {
  EXPECT_EQ(enum_text("BlendEquationModeEXT", GL_FUNC_ADD), "GL_FUNC_ADD");
  EXPECT_EQ(enum_text("TextureUnit", GL_TEXTURE1), "GL_TEXTURE1");
}

TEST(EnumNames, OfAWrongGroupAreStillNamed) {
  EXPECT_EQ(enum_text("PrimitiveType", GL_LIGHTING), "GL_LIGHTING");
  EXPECT_EQ(enum_text("PrimitiveType", 0xABCDE), "0xABCDE");
  EXPECT_EQ(enum_text("PrimitiveType", 0x77), "0x0077");
}

TEST(Bitfields, NameTheirBits) {
  EXPECT_EQ(bitfield_text("ClearBufferMask", GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT),
            "GL_DEPTH_BUFFER_BIT|GL_COLOR_BUFFER_BIT");
  EXPECT_EQ(bitfield_text("AttribMask", GL_ALL_ATTRIB_BITS), "GL_ALL_ATTRIB_BITS");
  EXPECT_EQ(bitfield_text("ClearBufferMask", 0x80000000u), "0x80000000");
  EXPECT_EQ(bitfield_text("ClearBufferMask", 0), "0");
}

TEST(Calls, HaveTheirValues) {
  const GLfloat red[] = {1, 0, 0.25f, 1};
  EXPECT_EQ(call_text("glMaterialfv",
                      {enumerant("MaterialFace", GL_FRONT),
                       enumerant("MaterialParameter", GL_AMBIENT_AND_DIFFUSE),
                       array(Kind::kFloats, red, values_of_name(GL_AMBIENT_AND_DIFFUSE))}),
            "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, {1, 0, 0.25, 1})");
  EXPECT_EQ(call_text("glDepthMask", {boolean(GL_FALSE)}), "glDepthMask(GL_FALSE)");
  EXPECT_EQ(call_text("glVertex3f", {number(1.5f), number(-2.0f), number(0.0f)}),
            "glVertex3f(1.5, -2, 0)");
  EXPECT_EQ(call_text("glFlush", {}), "glFlush()");
}

TEST(Calls, TellParametersAsEnumAndAsNumber) {
  EXPECT_EQ(call_text("f", {parameter(GLint{GL_LINEAR})}), "f(9729 (GL_LINEAR))");
  EXPECT_EQ(call_text("f", {parameter(180.0f)}), "f(180)");
  EXPECT_EQ(call_text("f", {enumerant_or_number("InternalFormat", 3)}), "f(3)");
  EXPECT_EQ(call_text("f", {enumerant_or_number("InternalFormat", GL_RGB)}), "f(GL_RGB)");
}

TEST(Calls, ReadNoMoreThanIsThere) {
  EXPECT_EQ(call_text("f", {array(Kind::kFloats, nullptr, 4)}), "f(NULL)");
  const GLuint names[20] = {1, 2};
  EXPECT_EQ(call_text("f", {array(Kind::kUnsignedInts, names, 2)}), "f({1, 2})");
  EXPECT_NE(call_text("f", {array(Kind::kUnsignedInts, names, 20)}).find(", …}"),
            std::string::npos);
  // Of a name that no call knows nothing is read: the address is told.
  EXPECT_EQ(values_of_name(0xABCD), 0);
  EXPECT_EQ(call_text("f", {array(Kind::kFloats, names, 0)}).find("{"), std::string::npos);
  EXPECT_EQ(call_text("f", {array(Kind::kFloats, names, -1)}).find("{"), std::string::npos);
}

TEST(Categories, AreWords) {
  std::string_view unknown;
  EXPECT_EQ(parse_categories("calls,glsl", unknown), kCalls | kGlsl);
  EXPECT_EQ(unknown, "");
  EXPECT_EQ(parse_categories("", unknown), 0u);
  EXPECT_EQ(parse_categories("errors,shaders,state", unknown), kErrors | kState);
  EXPECT_EQ(unknown, "shaders");
}

}  // namespace
}  // namespace legacy_gl::debug
