# legacy_gl_add_test(<target> SOURCES <file>... [LIBRARIES <library>...] [LABELS <label>...]
#                    [TIMEOUT <seconds>] [WHOLE])
#
# A GoogleTest program linked with the static library; internal headers are included relative to
# src/, test headers relative to tests/. Every TEST is one CTest entry, "<target>.<suite>.<name>";
# with WHOLE the program is one entry, for many short tests that share an expensive start.
function(legacy_gl_add_test target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "WHOLE" "TIMEOUT" "SOURCES;LIBRARIES;LABELS")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_SOURCES)
    message(FATAL_ERROR "legacy_gl_add_test(${target}): bad arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif()

  add_executable(${target} ${arg_SOURCES})
  legacy_gl_set_compile_options(${target})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${target} PRIVATE legacy_gl_internal ${arg_LIBRARIES} GTest::gtest_main)

  if(arg_WHOLE)
    add_test(NAME ${target} COMMAND ${target})
    set_tests_properties(${target} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT})
  else()
    # The list is read when ctest starts: a program that cannot run fails there and not in the build.
    gtest_discover_tests(
      ${target}
      TEST_PREFIX "${target}."
      DISCOVERY_MODE PRE_TEST
      DISCOVERY_TIMEOUT 60
      PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT})
  endif()
endfunction()
