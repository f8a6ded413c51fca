#pragma once
// The driver's functions. The driver's own headers are included by src/driver alone.
#include "state/gl_types.hpp"  // first: the driver's header has fewer enums under the same version macros

#include <GL/glcorearb.h>

#include <string>

#include "driver/driver_traits.hpp"
#include "shadergen/program_key.hpp"

namespace legacy_gl {

// Needed of every driver: what GL 3.3 core and GLES 3.0 have in common.
#define LEGACY_GL_DRIVER_FUNCTIONS(X)                                         \
  X(ActiveTexture, ACTIVETEXTURE)                                             \
  X(AttachShader, ATTACHSHADER)                                               \
  X(BeginQuery, BEGINQUERY)                                                   \
  X(BindBuffer, BINDBUFFER)                                                   \
  X(BindBufferBase, BINDBUFFERBASE)                                           \
  X(BindBufferRange, BINDBUFFERRANGE)                                         \
  X(BindFramebuffer, BINDFRAMEBUFFER)                                         \
  X(BindSampler, BINDSAMPLER)                                                 \
  X(BindTexture, BINDTEXTURE)                                                 \
  X(BindVertexArray, BINDVERTEXARRAY)                                         \
  X(BlendColor, BLENDCOLOR)                                                   \
  X(BlendEquation, BLENDEQUATION)                                             \
  X(BlendFuncSeparate, BLENDFUNCSEPARATE)                                     \
  X(BufferData, BUFFERDATA)                                                   \
  X(BufferSubData, BUFFERSUBDATA)                                             \
  X(Clear, CLEAR)                                                             \
  X(ClearColor, CLEARCOLOR)                                                   \
  X(ClearStencil, CLEARSTENCIL)                                               \
  X(ClientWaitSync, CLIENTWAITSYNC)                                           \
  X(ColorMask, COLORMASK)                                                     \
  X(CompileShader, COMPILESHADER)                                             \
  X(CompressedTexImage2D, COMPRESSEDTEXIMAGE2D)                               \
  X(CompressedTexSubImage2D, COMPRESSEDTEXSUBIMAGE2D)                         \
  X(CopyTexSubImage2D, COPYTEXSUBIMAGE2D)                                     \
  X(CopyTexSubImage3D, COPYTEXSUBIMAGE3D)                                     \
  X(CreateProgram, CREATEPROGRAM)                                             \
  X(CreateShader, CREATESHADER)                                               \
  X(CullFace, CULLFACE)                                                       \
  X(DeleteBuffers, DELETEBUFFERS)                                             \
  X(DeleteFramebuffers, DELETEFRAMEBUFFERS)                                   \
  X(DeleteProgram, DELETEPROGRAM)                                             \
  X(DeleteQueries, DELETEQUERIES)                                             \
  X(DeleteShader, DELETESHADER)                                               \
  X(DeleteSync, DELETESYNC)                                                   \
  X(DeleteTextures, DELETETEXTURES)                                           \
  X(DeleteVertexArrays, DELETEVERTEXARRAYS)                                   \
  X(DepthFunc, DEPTHFUNC)                                                     \
  X(DepthMask, DEPTHMASK)                                                     \
  X(Disable, DISABLE)                                                         \
  X(DrawArrays, DRAWARRAYS)                                                   \
  X(DrawElements, DRAWELEMENTS)                                               \
  X(Enable, ENABLE)                                                           \
  X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY)                         \
  X(EndQuery, ENDQUERY)                                                       \
  X(FenceSync, FENCESYNC)                                                     \
  X(Finish, FINISH)                                                           \
  X(Flush, FLUSH)                                                             \
  X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D)                               \
  X(FramebufferTextureLayer, FRAMEBUFFERTEXTURELAYER)                         \
  X(FrontFace, FRONTFACE)                                                     \
  X(GenBuffers, GENBUFFERS)                                                   \
  X(GenFramebuffers, GENFRAMEBUFFERS)                                         \
  X(GenQueries, GENQUERIES)                                                   \
  X(GenTextures, GENTEXTURES)                                                 \
  X(GenVertexArrays, GENVERTEXARRAYS)                                         \
  X(GenerateMipmap, GENERATEMIPMAP)                                           \
  X(GetError, GETERROR)                                                       \
  X(GetFloatv, GETFLOATV)                                                     \
  X(GetFramebufferAttachmentParameteriv, GETFRAMEBUFFERATTACHMENTPARAMETERIV) \
  X(GetIntegerv, GETINTEGERV)                                                 \
  X(GetProgramInfoLog, GETPROGRAMINFOLOG)                                     \
  X(GetProgramiv, GETPROGRAMIV)                                               \
  X(GetQueryObjectuiv, GETQUERYOBJECTUIV)                                     \
  X(GetQueryiv, GETQUERYIV)                                                   \
  X(GetShaderInfoLog, GETSHADERINFOLOG)                                       \
  X(GetShaderiv, GETSHADERIV)                                                 \
  X(GetString, GETSTRING)                                                     \
  X(GetStringi, GETSTRINGI)                                                   \
  X(GetUniformBlockIndex, GETUNIFORMBLOCKINDEX)                               \
  X(GetUniformLocation, GETUNIFORMLOCATION)                                   \
  X(LineWidth, LINEWIDTH)                                                     \
  X(LinkProgram, LINKPROGRAM)                                                 \
  X(MapBufferRange, MAPBUFFERRANGE)                                           \
  X(PixelStorei, PIXELSTOREI)                                                 \
  X(PolygonOffset, POLYGONOFFSET)                                             \
  X(ReadBuffer, READBUFFER)                                                   \
  X(ReadPixels, READPIXELS)                                                   \
  X(SampleCoverage, SAMPLECOVERAGE)                                           \
  X(Scissor, SCISSOR)                                                         \
  X(ShaderSource, SHADERSOURCE)                                               \
  X(StencilFunc, STENCILFUNC)                                                 \
  X(StencilMask, STENCILMASK)                                                 \
  X(StencilOp, STENCILOP)                                                     \
  X(TexImage2D, TEXIMAGE2D)                                                   \
  X(TexImage3D, TEXIMAGE3D)                                                   \
  X(TexParameterf, TEXPARAMETERF)                                             \
  X(TexParameterfv, TEXPARAMETERFV)                                           \
  X(TexParameteri, TEXPARAMETERI)                                             \
  X(TexSubImage2D, TEXSUBIMAGE2D)                                             \
  X(TexSubImage3D, TEXSUBIMAGE3D)                                             \
  X(Uniform1i, UNIFORM1I)                                                     \
  X(UniformBlockBinding, UNIFORMBLOCKBINDING)                                 \
  X(UnmapBuffer, UNMAPBUFFER)                                                 \
  X(UseProgram, USEPROGRAM)                                                   \
  X(VertexAttrib4fv, VERTEXATTRIB4FV)                                         \
  X(VertexAttribPointer, VERTEXATTRIBPOINTER)                                 \
  X(Viewport, VIEWPORT)

// Desktop only, or GLES only: nullptr where the driver has none.
#define LEGACY_GL_OPTIONAL_DRIVER_FUNCTIONS(X)            \
  X(BeginTransformFeedback, BEGINTRANSFORMFEEDBACK)       \
  X(BindProgramPipeline, BINDPROGRAMPIPELINE)             \
  X(ClearDepth, CLEARDEPTH)                               \
  X(ClearDepthf, CLEARDEPTHF)                             \
  X(DeleteProgramPipelines, DELETEPROGRAMPIPELINES)       \
  X(DepthRange, DEPTHRANGE)                               \
  X(DepthRangef, DEPTHRANGEF)                             \
  X(DrawBuffer, DRAWBUFFER)                               \
  X(DrawBuffers, DRAWBUFFERS)                             \
  X(DrawElementsBaseVertex, DRAWELEMENTSBASEVERTEX)       \
  X(EndTransformFeedback, ENDTRANSFORMFEEDBACK)           \
  X(GenProgramPipelines, GENPROGRAMPIPELINES)             \
  X(GetBufferSubData, GETBUFFERSUBDATA)                   \
  X(GetCompressedTexImage, GETCOMPRESSEDTEXIMAGE)         \
  X(GetProgramBinary, GETPROGRAMBINARY)                   \
  X(GetTexImage, GETTEXIMAGE)                             \
  X(GetTexLevelParameteriv, GETTEXLEVELPARAMETERIV)       \
  X(LogicOp, LOGICOP)                                     \
  X(MultiDrawArrays, MULTIDRAWARRAYS)                     \
  X(ObjectLabel, OBJECTLABEL)                             \
  X(PointSize, POINTSIZE)                                 \
  X(PopDebugGroup, POPDEBUGGROUP)                         \
  X(ProgramBinary, PROGRAMBINARY)                         \
  X(ProgramParameteri, PROGRAMPARAMETERI)                 \
  X(PushDebugGroup, PUSHDEBUGGROUP)                       \
  X(TransformFeedbackVaryings, TRANSFORMFEEDBACKVARYINGS) \
  X(UseProgramStages, USEPROGRAMSTAGES)

struct Driver {
#define LEGACY_GL_DECLARE(name, NAME) PFNGL##NAME##PROC name = nullptr;
  LEGACY_GL_DRIVER_FUNCTIONS(LEGACY_GL_DECLARE)
  LEGACY_GL_OPTIONAL_DRIVER_FUNCTIONS(LEGACY_GL_DECLARE)
#undef LEGACY_GL_DECLARE

  Dialect dialect = Dialect::kCore330;
  int major = 0, minor = 0;
  DriverTraits traits;  ///< of find_driver_traits
  bool is_es() const { return dialect == Dialect::kEs300; }
};

using Loader = void (*(*)(const char*))();

enum class DriverStatus { kOk, kNoContext, kTooOld, kMissingFunction };

/// What the driver has reported so far is forgotten, errors of the program's own calls too.
/// Bounded: a driver whose context is lost may answer errors for ever.
void forget_errors(const Driver& driver);

bool has_extension(const Driver& driver, const char* name);

/// Fills the table. `detail` gets the version or the function that is at fault.
DriverStatus load_driver(Driver& driver, Loader loader, std::string& detail);

}  // namespace legacy_gl
