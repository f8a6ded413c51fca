// Errors (GL 2.1 spec 2.5): the code of each, and that nothing else changes.
#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "gl/error_cases.hpp"
#include "gl/state_snapshot.hpp"
#include "support/contexts.hpp"
#include "support/shared_context.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 8;

std::string hex(GLenum code) {
  std::ostringstream text;
  text << "0x" << std::hex << std::setw(4) << std::setfill('0') << code;
  return text.str();
}

// Made once: starting Mesa costs more than a hundred cases. Each test asks for OpenGL's initial
// state.
CoreContext& ours() {
  static auto& context = make_shared_context<CoreContext>(kSize, kSize);
  context.recreate();
  return context;
}
MesaContext& mesa() {
  static auto& context = make_shared_context<MesaContext>(kSize, kSize);
  context.recreate();
  return context;
}

template <typename Case>
std::string test_name(const testing::TestParamInfo<Case>& test) {
  return test.param.entry_point + ("_" + std::to_string(test.index));
}

}  // namespace

void PrintTo(const ErrorCase& error, std::ostream* out) { *out << error.text; }
void PrintTo(const ValidCall& call, std::ostream* out) { *out << call.text; }

class Errors : public testing::TestWithParam<ErrorCase> {};
class MesasErrors : public testing::TestWithParam<ErrorCase> {};

TEST_P(Errors, HasItsCodeAndChangesNothing) {
  const GlFunctions& gl = ours().gl;
  GetParam().setup(gl);
  ASSERT_EQ(hex(gl.GetError()), hex(GL_NO_ERROR)) << "of the setup";
  const StateSnapshot before = take_snapshot(gl);
  GetParam().call(gl);
  EXPECT_EQ(hex(gl.GetError()), hex(GetParam().code)) << GetParam().text;
  EXPECT_EQ(difference(before, take_snapshot(gl)), "") << GetParam().text;
}

TEST_P(MesasErrors, AreTheSame) {
  const GlFunctions& gl = mesa().gl;
  GetParam().setup(gl);
  ASSERT_EQ(hex(gl.GetError()), hex(GL_NO_ERROR)) << "of the setup";
  GetParam().call(gl);
  if (GetParam().mesa_differs == nullptr)
    EXPECT_EQ(hex(gl.GetError()), hex(GetParam().code)) << GetParam().text;
  else
    EXPECT_NE(hex(gl.GetError()), hex(GetParam().code))
        << "no longer so: " << GetParam().mesa_differs;
}

// GL 2.1 spec 5.4: an error of a command in a list is raised when the list is executed.
TEST_P(Errors, InAListComesWhenItIsCalled) {
  if (!GetParam().in_lists) return;
  const GlFunctions& gl = ours().gl;
  GetParam().setup(gl);
  const StateSnapshot before = take_snapshot(gl);
  gl.NewList(7, GL_COMPILE);
  GetParam().call(gl);
  gl.EndList();
  EXPECT_EQ(hex(gl.GetError()), hex(GL_NO_ERROR)) << "while " << GetParam().text << " is compiled";
  gl.CallList(7);
  EXPECT_EQ(hex(gl.GetError()), hex(GetParam().code)) << GetParam().text;
  EXPECT_EQ(difference(before, take_snapshot(gl)), "") << GetParam().text;
}

// What no list holds is executed at once, errors and all.
TEST_P(Errors, WhatNoListHoldsComesAtOnce) {
  const std::string name = GetParam().entry_point;
  if (GetParam().in_lists || name == "glNewList" || name == "glEndList") return;
  const GlFunctions& gl = ours().gl;
  GetParam().setup(gl);
  gl.NewList(7, GL_COMPILE);
  GetParam().call(gl);
  EXPECT_EQ(hex(gl.GetError()), hex(GetParam().code)) << GetParam().text;
  gl.EndList();
  gl.CallList(7);
  EXPECT_EQ(hex(gl.GetError()), hex(GL_NO_ERROR)) << "of the empty list";
}

TEST_P(Errors, InsideBeginEndTooWhereTheCallIsAllowed) {
  if (!GetParam().inside_begin_end || GetParam().entry_point == std::string("glEnd")) return;
  const GlFunctions& gl = ours().gl;
  GetParam().setup(gl);
  const StateSnapshot before = take_snapshot(gl);
  gl.Begin(GL_POINTS);
  GetParam().call(gl);
  gl.End();
  EXPECT_EQ(hex(gl.GetError()), hex(GetParam().code)) << GetParam().text;
  EXPECT_EQ(difference(before, take_snapshot(gl)), "") << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(EntryPoint, Errors, testing::ValuesIn(error_cases()),
                         test_name<ErrorCase>);
INSTANTIATE_TEST_SUITE_P(EntryPoint, MesasErrors, testing::ValuesIn(error_cases()),
                         test_name<ErrorCase>);

class InsideBeginEnd : public testing::TestWithParam<ValidCall> {};

TEST_P(InsideBeginEnd, IsRefusedAndChangesNothing) {
  const GlFunctions& gl = ours().gl;
  GetParam().setup(gl);
  const StateSnapshot before = take_snapshot(gl);
  gl.Begin(GL_POINTS);
  GetParam().call(gl);
  gl.End();
  EXPECT_EQ(hex(gl.GetError()), hex(GL_INVALID_OPERATION)) << GetParam().text;
  EXPECT_EQ(difference(before, take_snapshot(gl)), "") << GetParam().text;
}

TEST_P(InsideBeginEnd, IsRightOutside) {
  const GlFunctions& gl = ours().gl;
  GetParam().setup(gl);
  GetParam().call(gl);
  EXPECT_EQ(hex(gl.GetError()), hex(GL_NO_ERROR)) << GetParam().text;
}

TEST_P(InsideBeginEnd, IsRefusedByMesaToo) {
  const GlFunctions& gl = mesa().gl;
  GetParam().setup(gl);
  gl.Begin(GL_POINTS);
  GetParam().call(gl);
  gl.End();
  EXPECT_EQ(hex(gl.GetError()), hex(GL_INVALID_OPERATION)) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(EntryPoint, InsideBeginEnd, testing::ValuesIn(calls_inside_begin_end()),
                         test_name<ValidCall>);

}  // namespace legacy_gl::test
