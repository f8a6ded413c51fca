# cmake -DOUTPUT=<source> -DDIRECTORY=<src/shadergen> -P generator_version.cmake
# Writes the digest of the sources of the shader generator as a constant.
file(GLOB sources ${DIRECTORY}/*.cpp ${DIRECTORY}/*.hpp)
list(SORT sources)
set(digests "")
foreach(source IN LISTS sources)
  file(SHA256 ${source} digest)
  string(APPEND digests "${digest}\n")
endforeach()
string(SHA256 version "${digests}")
string(SUBSTRING ${version} 0 16 version)
file(
  WRITE ${OUTPUT}
  "// Written by cmake/generator_version.cmake.
#include \"shadergen/generator_version.hpp\"

const char* legacy_gl::generator_version() { return \"${version}\"; }
")
