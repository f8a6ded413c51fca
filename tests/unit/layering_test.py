#!/usr/bin/env python3
"""Includes inside src/ point one way. The tables below are the architecture; docs/architecture.md says why."""

import pathlib
import re
import sys
import unittest

SRC = pathlib.Path(__file__).resolve().parents[2] / "src"

# What the files of a room may include of other rooms. Pairs that still include both ways:
# context and record, context and dlist, context and texture, dlist and execute, execute and submit,
# geometry and record, software and submit.
MAY_INCLUDE = {
    "state": set(),
    "lighting": {"state"},
    "matrix": {"state"},
    "texture": {"context", "state"},
    "evaluator": {"state"},
    "shadergen": set(),
    "geometry": {"context", "lighting", "record", "state"},
    "context": {"dlist", "evaluator", "lighting", "matrix", "record", "state", "texture"},
    "record": {"context", "geometry", "state"},
    "execute": {"context", "dlist", "evaluator", "submit", "texture"},
    "dlist": {"context", "execute", "geometry", "record", "state"},
    "cpu_pipeline": {"context", "dlist", "execute", "geometry", "lighting", "matrix", "state"},
    "translate": {"context", "geometry", "matrix", "shadergen"},
    "driver": {"geometry", "shadergen", "state", "texture", "translate"},
    "submit": {"driver", "execute", "geometry", "record", "shadergen", "software", "translate"},
    "software": {"context", "driver", "execute", "geometry", "record", "submit", "translate"},
    "api": {"context", "cpu_pipeline", "dlist", "driver", "execute", "record", "state", "submit", "texture"},
    "platform": set(),
    "glu": set(),
}

# What only the sources of a room may include, and not its headers.
SOURCES_MAY_INCLUDE = {}

# Headers without knowledge, open to every room but those that are closed.
COMMON_HEADERS = {"state/gl_types.hpp"}

# shadergen is a pure function of its key: no GL types, no state.
CLOSED_ROOMS = {"shadergen"}

# Only these rooms call the driver; platform makes the driver's contexts.
DRIVER_HEADER = re.compile(r"(GL|GLES\d?|EGL|KHR|X11|emscripten)/")
ROOMS_WITH_DRIVER_HEADERS = {"driver", "platform"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
SUFFIXES = {".h", ".hpp", ".inc", ".c", ".cpp"}


def violations(files):
    """The broken rules of `files`, a map from a path relative to src/ to the file's text."""
    found = []
    for path, text in sorted(files.items()):
        room = path.split("/")[0] if "/" in path else ""
        if room not in MAY_INCLUDE:
            found.append(f"{path}: lies in no room of the table")
            continue
        allowed = MAY_INCLUDE[room] | {room}
        if path.endswith((".cpp", ".c")):
            allowed = allowed | SOURCES_MAY_INCLUDE.get(room, set())
        for bracket, target in INCLUDE.findall(text):
            if DRIVER_HEADER.match(target):
                if room not in ROOMS_WITH_DRIVER_HEADERS:
                    found.append(f"{path}: <{target}> is for {sorted(ROOMS_WITH_DRIVER_HEADERS)}")
            elif target.startswith("legacy_gl/"):
                if room in CLOSED_ROOMS:
                    found.append(f"{path}: {room} may not include <{target}>")
            elif bracket == '"':
                if target not in files:
                    found.append(f'{path}: "{target}" is no file below src/')
                elif target in COMMON_HEADERS and room not in CLOSED_ROOMS:
                    pass
                elif target.split("/")[0] not in allowed:
                    found.append(f'{path}: {room} may not include "{target}"')
    return found


def cycle(files):
    """A list of headers each of which includes the next and the last the first, or None."""
    done, path = set(), []

    def visit(name):
        if name in path:
            return path[path.index(name):]
        if name in done or name not in files:
            return None
        path.append(name)
        for _, target in INCLUDE.findall(files[name]):
            result = visit(target)
            if result:
                return result
        path.pop()
        done.add(name)
        return None

    for name in sorted(files):
        result = visit(name)
        if result:
            return result
    return None


class TheTree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.files = {
            str(file.relative_to(SRC)): file.read_text(encoding="utf-8")
            for file in SRC.rglob("*")
            if file.suffix in SUFFIXES
        }

    def test_has_sources(self):
        rooms = {path.split("/")[0] for path in self.files}
        self.assertEqual(rooms - {"CMakeLists.txt", "legacy_gl.map"}, MAY_INCLUDE.keys())

    def test_includes_point_one_way(self):
        self.assertEqual(violations(self.files), [])

    def test_headers_have_an_order(self):
        self.assertIsNone(cycle(self.files))


class TheTables(unittest.TestCase):
    def test_way_of_the_data(self):
        """api is included by no room."""
        includers = {
            room: {other for other, targets in MAY_INCLUDE.items() if room in targets}
            for room in MAY_INCLUDE
        }
        self.assertEqual(includers["api"], set())

    def test_every_name_is_a_room(self):
        for table in (MAY_INCLUDE, SOURCES_MAY_INCLUDE):
            for room, targets in table.items():
                self.assertLessEqual({room} | targets, MAY_INCLUDE.keys())


class TheRules(unittest.TestCase):
    """Each rule reports a tree that breaks it, and only that."""

    COMMON = {
        "api/light.hpp": "",
        "submit/draw.hpp": "",
        "context/context.hpp": "",
        "state/gl_types.hpp": "",
    }

    def check(self, path, text, *expected):
        found = violations({**self.COMMON, path: text})
        self.assertEqual(len(found), len(expected), found)
        for message, part in zip(found, expected):
            self.assertIn(part, message)

    def test_allowed(self):
        self.check("api/light.cpp", '#include "context/context.hpp"\n#include <vector>\n')
        self.check("lighting/light.hpp", '#include "state/gl_types.hpp"\n')
        self.check("driver/functions.hpp", "#include <GL/glcorearb.h>\n")
        self.check("shadergen/key.hpp", "#include <cstdint>\n#include <glm/vec3.hpp>\n")

    def test_wrong_direction(self):
        self.check("state/get.hpp", '#include "submit/draw.hpp"', "state may not")
        self.check("state/get.cpp", '#include "api/light.hpp"', "state may not")
        self.check("glu/sphere.cpp", '  #  include "context/context.hpp"', "glu may not")

    def test_shadergen_is_closed(self):
        self.check("shadergen/key.hpp", '#include "context/context.hpp"', "shadergen may not")
        self.check("shadergen/key.hpp", '#include "state/gl_types.hpp"', "shadergen may not")
        self.check("shadergen/key.hpp", "#include <legacy_gl/gl.h>", "shadergen may not")

    def test_driver_headers(self):
        self.check("api/light.cpp", "#include <GL/glcorearb.h>", "<GL/glcorearb.h>")
        self.check("state/get.cpp", "#include <GLES3/gl3.h>", "<GLES3/gl3.h>")

    def test_unknown_places(self):
        self.check("helpers/x.hpp", "", "no room")
        self.check("x.hpp", "", "no room")
        self.check("api/light.cpp", '#include "light.hpp"', "no file")

    def test_cycle(self):
        files = {"state/a.hpp": '#include "state/b.hpp"', "state/b.hpp": '#include "state/a.hpp"'}
        self.assertEqual(cycle(files), ["state/a.hpp", "state/b.hpp"])
        self.assertIsNone(cycle({"state/a.hpp": '#include "state/b.hpp"', "state/b.hpp": ""}))


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
