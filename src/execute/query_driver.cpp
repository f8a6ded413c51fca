// What glGet answers from the driver: its limits, and the bits of the framebuffer (GL 2.1 spec
// tables 6.31 to 6.33).
#include "driver/driver_objects.hpp"
#include "execute/framebuffer.hpp"
#include "execute/queries.hpp"
#include "texture/compressed_format.hpp"

namespace legacy_gl {

namespace {

using enum ValueKind;

constexpr GLenum kDrawFramebufferBinding = 0x8CA6, kReadFramebufferBinding = 0x8CAA,
                 kRenderbufferBinding = 0x8CA7, kMaxRenderbufferSize = 0x84E8,
                 kMaxColorAttachments = 0x8CDF, kMaxSamples = 0x8D57, kMaxDrawBuffers = 0x8824;

template <GLenum Name, unsigned Count = 1>
void driver_integers(Context& c, QueryValues& v) {
  std::array<GLint, Count> values{};
  c.driver->functions.GetIntegerv(Name, values.data());
  v.put(values);
}

template <GLenum Name, unsigned Count = 1>
void driver_floats(Context& c, QueryValues& v) {
  std::array<GLfloat, Count> values{};
  c.driver->functions.GetFloatv(Name, values.data());
  v.put(values);
}

/// OpenGL ES has no smooth points and lines: the aliased range, in steps of one.
template <GLenum DesktopName, GLenum EsName>
void size_range(Context& c, QueryValues& v) {
  if (c.driver->functions.is_es()) driver_floats<EsName, 2>(c, v);
  else driver_floats<DesktopName, 2>(c, v);
}
template <GLenum DesktopName>
void size_granularity(Context& c, QueryValues& v) {
  if (c.driver->functions.is_es()) v.put(1);
  else driver_floats<DesktopName>(c, v);
}

template <FramebufferChannel Channel>
void bits(Context& c, QueryValues& v) {
  v.put(framebuffer_bits(c, Channel));
}

constexpr Query kLimits[] = {
    {GL_MAX_TEXTURE_SIZE, kInteger, driver_integers<GL_MAX_TEXTURE_SIZE>},
    {GL_MAX_3D_TEXTURE_SIZE, kInteger, driver_integers<GL_MAX_3D_TEXTURE_SIZE>},
    {GL_MAX_CUBE_MAP_TEXTURE_SIZE, kInteger, driver_integers<GL_MAX_CUBE_MAP_TEXTURE_SIZE>},
    {GL_MAX_TEXTURE_LOD_BIAS, kFloat, driver_floats<GL_MAX_TEXTURE_LOD_BIAS>},
    {GL_MAX_VIEWPORT_DIMS, kInteger, driver_integers<GL_MAX_VIEWPORT_DIMS, 2>},
    {GL_MAX_ELEMENTS_VERTICES, kInteger, driver_integers<GL_MAX_ELEMENTS_VERTICES>},
    {GL_MAX_ELEMENTS_INDICES, kInteger, driver_integers<GL_MAX_ELEMENTS_INDICES>},
    {GL_SUBPIXEL_BITS, kInteger, driver_integers<GL_SUBPIXEL_BITS>},
    {GL_POINT_SIZE_RANGE, kFloat, size_range<GL_POINT_SIZE_RANGE, GL_ALIASED_POINT_SIZE_RANGE>},
    {GL_POINT_SIZE_GRANULARITY, kFloat, size_granularity<GL_POINT_SIZE_GRANULARITY>},
    {GL_ALIASED_POINT_SIZE_RANGE, kFloat,
     size_range<GL_POINT_SIZE_RANGE, GL_ALIASED_POINT_SIZE_RANGE>},
    {GL_LINE_WIDTH_RANGE, kFloat, size_range<GL_LINE_WIDTH_RANGE, GL_ALIASED_LINE_WIDTH_RANGE>},
    {GL_LINE_WIDTH_GRANULARITY, kFloat, size_granularity<GL_LINE_WIDTH_GRANULARITY>},
    {GL_ALIASED_LINE_WIDTH_RANGE, kFloat, driver_floats<GL_ALIASED_LINE_WIDTH_RANGE, 2>},
};

void accumulation_bits(Context& c, QueryValues& v) {
  v.put(has_accumulation_buffer(c) ? kAccumulationBits : 0);
}

/// Those for general use, as EXT_texture_compression_s3tc says.
constexpr GLenum kCompressedFormats[] = {kRgbDxt1, kRgbaDxt3, kRgbaDxt5};
constexpr Query kCompression[] = {
    {GL_NUM_COMPRESSED_TEXTURE_FORMATS, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.driver->textures.offers_s3tc() ? 3 : 0); }},
    {GL_COMPRESSED_TEXTURE_FORMATS, kInteger,
     [](Context& c, QueryValues& v) {
       if (!c.driver->textures.offers_s3tc()) return;
       for (const GLenum format : kCompressedFormats) v.put(format);
     }},
};

/// Framebuffer objects are the driver's (legacy_gl/framebuffer_objects.h).
constexpr Query kFramebufferObjects[] = {
    {kDrawFramebufferBinding, kInteger, driver_integers<kDrawFramebufferBinding>},
    {kReadFramebufferBinding, kInteger, driver_integers<kReadFramebufferBinding>},
    {kRenderbufferBinding, kInteger, driver_integers<kRenderbufferBinding>},
    {kMaxRenderbufferSize, kInteger, driver_integers<kMaxRenderbufferSize>},
    {kMaxColorAttachments, kInteger, driver_integers<kMaxColorAttachments>},
    {kMaxSamples, kInteger, driver_integers<kMaxSamples>},
    {kMaxDrawBuffers, kInteger, driver_integers<kMaxDrawBuffers>},
};

constexpr Query kFramebuffer[] = {
    {GL_ACCUM_RED_BITS, kInteger, accumulation_bits},
    {GL_ACCUM_GREEN_BITS, kInteger, accumulation_bits},
    {GL_ACCUM_BLUE_BITS, kInteger, accumulation_bits},
    {GL_ACCUM_ALPHA_BITS, kInteger, accumulation_bits},
    {GL_ACCUM_CLEAR_VALUE, kNormalised,
     [](Context& c, QueryValues& v) { v.put(c.accumulation.clear_value); }},
    {GL_RED_BITS, kInteger, bits<FramebufferChannel::kRed>},
    {GL_GREEN_BITS, kInteger, bits<FramebufferChannel::kGreen>},
    {GL_BLUE_BITS, kInteger, bits<FramebufferChannel::kBlue>},
    {GL_ALPHA_BITS, kInteger, bits<FramebufferChannel::kAlpha>},
    {GL_DEPTH_BITS, kInteger, bits<FramebufferChannel::kDepth>},
    {GL_STENCIL_BITS, kInteger, bits<FramebufferChannel::kStencil>},
    {GL_SAMPLE_BUFFERS, kInteger, driver_integers<GL_SAMPLE_BUFFERS>},
    {GL_SAMPLES, kInteger, driver_integers<GL_SAMPLES>},
    {GL_DOUBLEBUFFER, kBoolean, [](Context& c, QueryValues& v) { v.put(is_double_buffered(c)); }},
    {GL_STEREO, kBoolean, [](Context& c, QueryValues& v) { v.put(is_stereo(c)); }},
};

}  // namespace

QueryGroups driver_queries() {
  static constexpr std::span<const Query> kGroups[] = {kLimits, kCompression, kFramebuffer,
                                                       kFramebufferObjects};
  return kGroups;
}

}  // namespace legacy_gl
