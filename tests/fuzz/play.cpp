#include "fuzz/play.hpp"

#include <list>

#include "fuzz/contexts.hpp"
#include "fuzz/entry_points.hpp"

namespace legacy_gl::fuzz {

namespace {

class Player {
 public:
  Player(test::RenderContext& context, Recording& recording)
      : context_(context), recording_(recording) {}

  void play_frame(const Program& program, int frame) {
    frame_ = frame;
    for (const Call& call : program) make(call);
    make({"RenderMode", {name("GL_RENDER")}});
    take_errors();
    recording_.pictures.push_back(read_picture());
  }

 private:
  void make(const Call& call) {
    Result& result = results_.emplace_back();
    invoke(context_.gl, call, result);
    const bool keeps_output = call.name == "FeedbackBuffer" || call.name == "SelectBuffer";
    if (call.name == "FeedbackBuffer") feedback_ = &result.outputs.back();
    if (call.name == "SelectBuffer") selection_ = &result.outputs.back();
    if (call.name == "RenderMode") record_hits(result.value);
    if (result.returned) record(call.name, {}, {result.value});
    if (!keeps_output) {
      for (const Output& output : result.outputs)
        record(call.name, output.element, numbers(output.element, output.bytes));
      results_.pop_back();
    }
  }

  void record(const std::string& call, const std::string& element, std::vector<double> values) {
    recording_.answers.push_back({frame_, call, element, std::move(values)});
  }

  // What glRenderMode leaves in the buffer of the mode that ends. After an overflow it is
  // undefined.
  void record_hits(double count) {
    const Output* ended = mode_ == GL_FEEDBACK ? feedback_
                          : mode_ == GL_SELECT ? selection_
                                               : nullptr;
    if (ended != nullptr && count > 0)
      record(mode_ == GL_FEEDBACK ? "feedback" : "selection", ended->element,
             numbers(ended->element, ended->bytes));
    GLint now = 0;
    context_.gl.GetIntegerv(GL_RENDER_MODE, &now);
    mode_ = static_cast<GLenum>(now);
  }

  void take_errors() {
    for (GLenum error = context_.gl.GetError(); error != GL_NO_ERROR;
         error = context_.gl.GetError())
      record("GetError at the end", {}, {static_cast<double>(error)});
  }

  // Contexts that draw into a framebuffer object read it by glReadPixels.
  test::Image read_picture() {
    const GlFunctions& gl = context_.gl;
    gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    gl.PushAttrib(GL_PIXEL_MODE_BIT);
    for (const int name : {GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_ROW_LENGTH,
                           GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST})
      gl.PixelStorei(static_cast<GLenum>(name), 0);
    for (const int name : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE})
      gl.PixelTransferf(static_cast<GLenum>(name), 1);
    for (const int name : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_MAP_COLOR})
      gl.PixelTransferf(static_cast<GLenum>(name), 0);
    test::Image picture = context_.read();
    gl.PopAttrib();
    gl.PopClientAttrib();
    while (gl.GetError() != GL_NO_ERROR) continue;
    return picture;
  }

  test::RenderContext& context_;
  Recording& recording_;
  int frame_ = 0;
  GLenum mode_ = GL_RENDER;
  std::list<Result> results_;
  const Output* feedback_ = nullptr;
  const Output* selection_ = nullptr;
};

}  // namespace

Recording play(test::RenderContext& context, const Program& program, int frames) {
  Recording recording;
  take_diagnostics();
  Player player(context, recording);
  for (int frame = 0; frame < frames; ++frame) player.play_frame(program, frame);
  recording.diagnostics = take_diagnostics();
  return recording;
}

}  // namespace legacy_gl::fuzz
