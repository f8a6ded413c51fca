#include "conformance/render_pair.hpp"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace legacy_gl::test {

namespace {

using PairKey = std::tuple<Dialect, int, PixelFormat>;
using MesaKey = std::pair<int, PixelFormat>;

std::map<PairKey, RenderPair> pairs;
std::map<MesaKey, std::unique_ptr<RenderContext>> mesa_contexts;

// Before main returns: Mesa's own destructors of static objects run in an unknown order after it.
class DestroyContexts final : public testing::Environment {
 public:
  void TearDown() override {
    pairs.clear();
    mesa_contexts.clear();
  }
};

[[maybe_unused]] const testing::Environment* const environment =
    testing::AddGlobalTestEnvironment(new DestroyContexts);

}  // namespace

const char* dialect_name(Dialect dialect) {
  return dialect == Dialect::core_330 ? "core_330" : "es_300";
}

std::unique_ptr<RenderContext> make_context(Dialect dialect, int size, PixelFormat format) {
  if (dialect == Dialect::core_330) return std::make_unique<CoreContext>(size, size, format);
  return std::make_unique<GlesContext>(size, size, format);
}

RenderPair& render_pair(Dialect dialect, int size, PixelFormat format) {
  RenderPair& pair = pairs[{dialect, size, format}];
  if (!pair.ours) {
    // The GLES context draws into a framebuffer object, so its reference does.
    pair.mesa = std::make_unique<MesaContext>(
        size, size, format,
        dialect == Dialect::es_300 ? Target::framebuffer_object : Target::window);
    pair.ours = make_context(dialect, size, format);
  }
  return pair;
}

RenderContext& mesa_context(int size, PixelFormat format) {
  auto& context = mesa_contexts[{size, format}];
  if (!context) context = std::make_unique<MesaContext>(size, size, format);
  return *context;
}

}  // namespace legacy_gl::test
