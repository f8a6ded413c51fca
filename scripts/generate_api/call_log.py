"""Calls in words: the public entry points that tell a call and make it, and the names of enums.

The functions of src/api are compiled under the names of src/api/plain_names.hpp. src/api/logged_calls.cpp defines
the public names in front of them. The variants of glVertex and its like (variants.py) are logged where they leave
their shortest way.
"""

import re

from registry import Parameter
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
    return ", ".join(_argument(p, command, api) for p in command.parameters)


def variant(name, declaration, body, api):
    """A row of src/api/vertex_variants_*.cpp: `body` is what the variant does with the values of `declaration`."""
    command = api.commands[name]
    names = re.findall(r"(\w+)(?:,|$)", declaration)
    told = [_argument(Parameter(p.type, own_name, p.group, p.length), command, api)
            for p, own_name in zip(command.parameters, names)]
    return f"LEGACY_GL_VARIANT({name}, ({declaration}), ({', '.join(names)}), {body}, {', '.join(told)})\n"


RESULTS = {"void": "nothing", "GLenum": "error_code", "GLboolean": "boolean", "const GLubyte *": "text"}


def logged_calls(api, by_hand):
    out = GENERATED
    for name in by_hand:
        command = api.commands[name]
        result = RESULTS.get(command.result, "address" if "*" in command.result else "number")
        fields = [command.result, name, f"({command.declaration()})", f"({command.names()})", result,
                  arguments(command, api)]
        out += f"LEGACY_GL_LOGGED_CALL({', '.join(filter(None, fields))})\n"
    return out


def enum_names(api):
    """One name for each value, and the names by group where a group calls a value otherwise. Small values and bits
    have names in their groups alone."""
    ours = {name for enums in api.enums.values() for name, _ in enums}
    groups = {p.group for command in api.commands.values() for p in command.parameters} | {"ErrorCode"}
    bitfields = {p.group for command in api.commands.values() for p in command.parameters if p.type == "GLbitfield"}

    def best(names):
        return min(names, key=lambda name: (name not in ours, len(name), name))

    every, of_group = {}, {}
    for enums in api.enums.values():
        for name, value in enums:
            every.setdefault(int(value, 0), []).append(name)
    for group in groups & api.enum_groups.keys():
        for name, value in api.enum_groups[group]:
            if group not in bitfields:
                every.setdefault(int(value, 0), []).append(name)
            of_group.setdefault((group, int(value, 0)), []).append(name)
    rows = {("", value): best(names) for value, names in every.items()
            if 0x100 <= value < 1 << 32 and not best(names).endswith("_BIT")}
    for (group, value), names in of_group.items():
        if value < 1 << 32 and (group in bitfields or rows.get(("", value)) != best(names)):
            rows[group, value] = best(names)
    return GENERATED + "".join(f'{{"{group}", {value:#x}u, "{rows[group, value]}"}},\n'
                               for group, value in sorted(rows, key=lambda key: (key[0].encode(), key[1])))
