if(LEGACY_GL_SANITIZE_THREAD)
  set(LEGACY_GL_SANITIZERS thread)
elseif(LEGACY_GL_SANITIZE)
  set(LEGACY_GL_SANITIZERS address,undefined)
endif()

# legacy_gl_set_compile_options(<target>): what every C and C++ target of this tree is compiled with.
function(legacy_gl_set_compile_options target)
  target_compile_features(${target} PRIVATE c_std_99 cxx_std_20)
  set_target_properties(${target} PROPERTIES C_EXTENSIONS OFF CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wsign-conversion -Wshadow)
  if(LEGACY_GL_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()

  # A fused multiply-add rounds once where Mesa's CPU arithmetic rounds twice. Vertex positions have
  # to match Mesa's bit for bit, or coverage and GL_EQUAL depth tests differ by single pixels.
  target_compile_options(${target} PRIVATE -ffp-contract=off)

  if(LEGACY_GL_SANITIZERS)
    target_compile_options(${target} PRIVATE -fsanitize=${LEGACY_GL_SANITIZERS}
                                             -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${LEGACY_GL_SANITIZERS})
  endif()
endfunction()
