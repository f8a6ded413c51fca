# legacy_gl_add_test(<target> SOURCES <file>... [LIBRARIES <library>...] [LABELS <label>...]
#                    [TIMEOUT <seconds>] [WHOLE] [VALGRIND <GoogleTest filter>]
#                    [TRAITS <GoogleTest filter>])
#
# A GoogleTest program linked with the static library; internal headers are included relative to
# src/, test headers relative to tests/. Every TEST is one CTest entry, "<target>.<suite>.<name>";
# with WHOLE the program is one entry, for many short tests that share an expensive start.
# VALGRIND says which of its tests scripts/valgrind runs: all of them unless told, "-*" for none.
#
# A WHOLE program of the label gl runs a second time as "<target>.generic", with all that is known
# of the driver put aside: the path that every GPU takes. TRAITS names the tests that ask for what a
# trait or src/software brings; they are left out there, and where src/software is not built.
function(legacy_gl_add_test target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "WHOLE" "TIMEOUT;VALGRIND;TRAITS" "SOURCES;LIBRARIES;LABELS")
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

  if(LEGACY_GL_VALGRIND)
    legacy_gl_add_valgrind_test(${target} "${arg_VALGRIND}" "${arg_LABELS}")
  elseif(arg_WHOLE)
    if(LEGACY_GL_SOFTWARE_FAST_PATH OR NOT "gl" IN_LIST arg_LABELS)
      add_test(NAME ${target} COMMAND ${target})
      set_tests_properties(${target} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT})
    endif()
    if("gl" IN_LIST arg_LABELS AND NOT "${arg_TRAITS}" STREQUAL "*")
      add_test(NAME ${target}.generic COMMAND ${target} --gtest_filter=-${arg_TRAITS})
      set_tests_properties(
        ${target}.generic PROPERTIES LABELS generic TIMEOUT ${arg_TIMEOUT} ENVIRONMENT
                                     LEGACY_GL_DRIVER_TRAITS=generic)
    endif()
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

# One process a program: starting Mesa under valgrind takes seconds. The program runs under valgrind
# as every program of the tests does then (tests/CMakeLists.txt).
function(legacy_gl_add_valgrind_test target filter labels)
  if(NOT filter)
    set(filter "*")
  elseif(filter STREQUAL "-*")
    return()
  endif()
  add_test(NAME ${target} COMMAND ${target} --gtest_brief=1 --gtest_filter=${filter})
  set_tests_properties(${target} PROPERTIES LABELS "${labels}" TIMEOUT 1800)
endfunction()
