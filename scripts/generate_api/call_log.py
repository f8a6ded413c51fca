"""Calls in words: the public entry points that tell a call and make it, and the names of enums.

The functions of src/api are compiled under the names of src/api/plain_names.hpp. src/api/logged_calls.cpp defines
the public names in front of them. The variants of glVertex and its like tell of themselves (variants.py), where no
call passes that is executed at once.
"""

import re

from tables import GENERATED

KINDS = {"GLbyte": "kBytes", "GLubyte": "kUnsignedBytes", "GLshort": "kShorts", "GLushort": "kUnsignedShorts",
         "GLint": "kInts", "GLsizei": "kInts", "GLuint": "kUnsignedInts", "GLfloat": "kFloats", "GLclampf": "kFloats",
         "GLdouble": "kDoubles", "GLclampd": "kDoubles", "GLboolean": "kBooleans", "GLenum": "kEnums"}


def _count(parameter, command):
    names = [p.name for p in command.parameters]
    if re.fullmatch(r"\d+", parameter.length):
        return parameter.length
    if parameter.length in names:
        return f"static_cast<int>({parameter.length})"
    if parameter.length in ("COMPSIZE(pname)", "COMPSIZE(target,pname)") and "pname" in names:
        return "values_of_name(pname)"
    return None


def _argument(parameter, command, api):
    name, group = parameter.name, parameter.group if parameter.group in api.enum_groups else ""
    if "*" in parameter.type:
        pointee = parameter.type.removeprefix("const ").rstrip(" *")
        count = _count(parameter, command)
        if count and parameter.type.startswith("const ") and parameter.type.count("*") == 1 and pointee in KINDS:
            return f"array(Kind::{KINDS[pointee]}, {name}, {count})"
        return f"address({name})"
    if parameter.type == "GLenum":
        return f'enumerant("{group}", {name})'
    if parameter.type == "GLbitfield":
        return f'bitfield("{group}", {name})'
    if parameter.type == "GLboolean":
        return f"boolean({name})"
    if group:
        return f'enumerant_or_number("{group}", {name})'
    if name == "param":
        return f"parameter({name})"
    return f"number({name})"


def arguments(command, api):
    return "{" + ", ".join(_argument(p, command, api) for p in command.parameters) + "}"


def variant(text, api):
    """Each function of a file of variants tells of itself where it would leave its shortest way. All of that is a
    function of its own, so that the shortest way needs no stack frame."""
    def with_log(match):
        name, declaration, body = match.groups()
        command = api.commands[name]
        names = ", ".join(_names(declaration))
        return (f"[[gnu::cold, gnu::noinline]] static void logged_{name}({declaration}) {{\n"
                f"  log_call(\"gl{name}\", {_renamed(command, declaration, api)});\n  {body.strip()}\n}}\n"
                f"LEGACY_GL_API void LEGACY_GL_APIENTRY lgl{name}({declaration}) {{\n"
                f"  if (!direct_context && names_calls()) [[unlikely]] return logged_{name}({names});\n"
                f"  {body.strip()}\n}}\n")
    text = re.sub(r"^LEGACY_GL_API void LEGACY_GL_APIENTRY lgl(\w+)\(([^)]*)\) \{([^}]*)\}\n", with_log, text, flags=re.M)
    return text.replace("using namespace legacy_gl;\n", "using namespace legacy_gl;\nusing namespace legacy_gl::debug;\n"
                        "using Kind [[maybe_unused]] = Argument::Kind;\n", 1)


def _names(declaration):
    return [re.search(r"(\w+)$", part).group(1) for part in declaration.split(",")]


def _renamed(command, declaration, api):
    """The arguments under the names that the definition gives them."""
    renamed = [type(p)(p.type, name, p.group, p.length)
               for p, name in zip(command.parameters, _names(declaration))]
    return "{" + ", ".join(_argument(p, command, api) for p in renamed) + "}"


def plain_names(api, by_hand):
    out = GENERATED + """// The functions of src/api are compiled with this header in front, under other names for the linker:
// the public ones are in logged_calls.cpp, which tells a call where that is asked for and makes it.
#pragma once
#include "state/gl_types.hpp"

// NOLINTBEGIN(readability-redundant-declaration): gl.h declares them without the linker's names.
extern "C" {
"""
    for name in by_hand:
        command = api.commands[name]
        out += f"{command.result} LEGACY_GL_APIENTRY lgl{name}({command.declaration()}) __asm__(\"plain_lgl{name}\");\n"
    return out + "}\n// NOLINTEND(readability-redundant-declaration)\n"


RESULTS = {"GLenum": 'enumerant("ErrorCode", result)', "GLboolean": "boolean(result)", "const GLubyte *": "text(result)"}


def logged_calls(api, by_hand):
    out = GENERATED + """// The public entry points: each call is told where that is asked for (debug/log.hpp), and made
// (plain_names.hpp).
#include "debug/call_log.hpp"
#include "state/gl_types.hpp"

using namespace legacy_gl::debug;
using Kind = Argument::Kind;

extern "C" {
"""
    for name in by_hand:
        command = api.commands[name]
        out += f"{command.result} LEGACY_GL_APIENTRY plain_lgl{name}({command.declaration()});\n"
    for name in by_hand:
        command = api.commands[name]
        names = ", ".join(p.name for p in command.parameters)
        told = RESULTS.get(command.result, "address(result)" if "*" in command.result else "number(result)")
        made = (f"  plain_lgl{name}({names});\n" if command.result == "void" else
                f"  const auto result = plain_lgl{name}({names});\n  log_result({told});\n  return result;\n")
        out += (f"\n[[gnu::cold, gnu::noinline]] static {command.result} logged_{name}({command.declaration()}) {{\n"
                f"  log_call(\"gl{name}\", {arguments(command, api)});\n{made}}}\n"
                f"LEGACY_GL_API {command.result} LEGACY_GL_APIENTRY lgl{name}({command.declaration()}) {{\n"
                f"  if (names_calls()) [[unlikely]] return logged_{name}({names});\n"
                f"  return plain_lgl{name}({names});\n}}\n")
    return out + "\n}\n"


def enum_names(api):
    used = {p.group for command in api.commands.values() for p in command.parameters} | {"ErrorCode"}
    ours = {name for enums in api.enums.values() for name, _ in enums}
    rows = {}
    for enums in api.enums.values():
        for name, value in enums:
            if int(value, 0) >= 0x100 and not name.endswith("_BIT"):
                rows.setdefault(("", int(value, 0)), []).append(name)
    for group in used & api.enum_groups.keys():
        for name, value in api.enum_groups[group]:
            rows.setdefault((group, int(value, 0)), []).append(name)

    def best(names):
        return min(names, key=lambda name: (name not in ours, len(name), name))

    def order(key):
        return key[0].encode(), key[1]
    return GENERATED + "".join(f'{{"{group}", {value:#x}u, "{best(rows[group, value])}"}},\n'
                               for group, value in sorted(rows, key=order) if value < 1 << 32)
