#include "driver/driver.hpp"

#include <cstdio>
#include <cstring>

namespace legacy_gl {

namespace {

template <typename Function>
bool load(Function& function, Loader loader, const char* name) {
  function = reinterpret_cast<Function>(loader(name));
  return function != nullptr;
}

/// "OpenGL ES 3.0 Mesa ..." or "3.3 (Core Profile) Mesa ...".
void parse_version(Driver& driver, const char* version) {
  static constexpr char kEsPrefix[] = "OpenGL ES ";
  if (std::strncmp(version, kEsPrefix, sizeof kEsPrefix - 1) == 0) {
    driver.dialect = Dialect::kEs300;
    version += sizeof kEsPrefix - 1;
  }
  if (std::sscanf(version, "%d.%d", &driver.major, &driver.minor) != 2)
    driver.major = driver.minor = 0;
}

void load_optional(Driver& driver, Loader loader) {
  // A loader may hand out stubs for what the driver's dialect does not have: ask for the dialect's
  // own alone.
  const auto optional = [&](auto& function, const char* name, bool in_dialect) {
    if (in_dialect) load(function, loader, name);
  };
  const bool es = driver.is_es();
  optional(driver.ClearDepth, "glClearDepth", !es);
  optional(driver.ClearDepthf, "glClearDepthf", es);
  optional(driver.DepthRange, "glDepthRange", !es);
  optional(driver.DepthRangef, "glDepthRangef", es);
  optional(driver.DrawBuffer, "glDrawBuffer", !es);
  optional(driver.DrawBuffers, "glDrawBuffers", true);
  optional(driver.DrawElementsBaseVertex, "glDrawElementsBaseVertex", !es);
  optional(driver.LogicOp, "glLogicOp", !es);
  optional(driver.MultiDrawArrays, "glMultiDrawArrays", !es);
  optional(driver.GetBufferSubData, "glGetBufferSubData", !es);
  optional(driver.GetCompressedTexImage, "glGetCompressedTexImage", !es);
  optional(driver.GetTexImage, "glGetTexImage", !es);
  optional(driver.GetTexLevelParameteriv, "glGetTexLevelParameteriv", !es);
  optional(driver.PointSize, "glPointSize", !es);
  const bool binaries = es || driver.major * 10 + driver.minor >= 41 ||
                        has_extension(driver, "GL_ARB_get_program_binary");
  optional(driver.GetProgramBinary, "glGetProgramBinary", binaries);
  optional(driver.ProgramBinary, "glProgramBinary", binaries);
  optional(driver.ProgramParameteri, "glProgramParameteri", binaries);
  const bool pipelines = !es && (driver.major * 10 + driver.minor >= 41 ||
                                 has_extension(driver, "GL_ARB_separate_shader_objects"));
  optional(driver.BindProgramPipeline, "glBindProgramPipeline", pipelines);
  optional(driver.DeleteProgramPipelines, "glDeleteProgramPipelines", pipelines);
  optional(driver.GenProgramPipelines, "glGenProgramPipelines", pipelines);
  optional(driver.UseProgramStages, "glUseProgramStages", pipelines);
  optional(driver.BeginTransformFeedback, "glBeginTransformFeedback", true);
  optional(driver.EndTransformFeedback, "glEndTransformFeedback", true);
  optional(driver.TransformFeedbackVaryings, "glTransformFeedbackVaryings", true);
  if (pipelines) optional(driver.ProgramParameteri, "glProgramParameteri", true);
}

}  // namespace

void forget_errors(const Driver& driver) {
  // One flag for each kind of error (GL 3.3 core spec 2.5).
  constexpr int kErrorKinds = 8;
  for (int i = 0; i < kErrorKinds && driver.GetError() != GL_NO_ERROR; ++i) {
  }
}

bool has_extension(const Driver& driver, const char* name) {
  GLint count = 0;
  driver.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const auto* const extension =
        reinterpret_cast<const char*>(driver.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (extension && std::strcmp(extension, name) == 0) return true;
  }
  return false;
}

DriverStatus load_driver(Driver& driver, Loader loader, std::string& detail) {
  if (!load(driver.GetString, loader, "glGetString")) {
    detail = "glGetString";
    return DriverStatus::kMissingFunction;
  }
  const auto* const version = reinterpret_cast<const char*>(driver.GetString(GL_VERSION));
  if (!version) {
    detail = "glGetString(GL_VERSION) is NULL";
    return DriverStatus::kNoContext;
  }
  parse_version(driver, version);
  const int wanted_minor = driver.is_es() ? 0 : 3;
  if (driver.major < 3 || (driver.major == 3 && driver.minor < wanted_minor)) {
    detail = std::string("\"") + version + "\", where OpenGL 3.3 or OpenGL ES 3.0 is needed";
    return DriverStatus::kTooOld;
  }
#define LEGACY_GL_LOAD(name, NAME)              \
  if (!load(driver.name, loader, "gl" #name)) { \
    detail = "gl" #name;                        \
    return DriverStatus::kMissingFunction;      \
  }
  LEGACY_GL_DRIVER_FUNCTIONS(LEGACY_GL_LOAD)
#undef LEGACY_GL_LOAD
  load_optional(driver, loader);
  return DriverStatus::kOk;
}

}  // namespace legacy_gl
