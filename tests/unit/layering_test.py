#!/usr/bin/env python3
"""The rooms of src/ depend on each other one way, by what they include and by what they call.

The table below is the architecture; docs/architecture.md says why. With --objects DIRECTORY (the object files of a build)
the symbols that a room's objects need are looked up too: each has to be defined in a room that this one may include.
"""

import pathlib
import re
import subprocess
import sys
import unittest

SRC = pathlib.Path(__file__).resolve().parents[2] / "src"

# What the files of a room may include of other rooms, lowest room first: each names only rooms above itself in the table.
MAY_INCLUDE = {
    "state": set(),
    "debug": {"state"},
    "lighting": {"state"},
    "matrix": set(),
    "texture": {"state"},
    "evaluator": {"state"},
    "shadergen": set(),
    "geometry": {"lighting", "state"},
    "context": {"debug", "evaluator", "lighting", "matrix", "state", "texture"},
    "record": {"context", "debug", "geometry", "lighting", "state", "texture"},
    "translate": {"context", "geometry", "lighting", "matrix", "record", "shadergen", "texture"},
    "driver": {"debug", "geometry", "shadergen", "state", "texture"},
    "execute": {"context", "debug", "driver", "evaluator", "lighting", "matrix", "record", "state", "texture"},
    "cpu_pipeline": {"context", "debug", "execute", "geometry", "lighting", "matrix", "record", "state", "texture"},
    "dlist": {"context", "debug", "execute", "geometry", "record", "state"},
    "submit": {"context", "cpu_pipeline", "debug", "driver", "execute", "geometry", "matrix", "record", "shadergen", "state",
               "texture", "translate"},
    "software": {"context", "debug", "driver", "geometry", "lighting", "matrix", "record", "shadergen", "submit", "texture",
                 "translate"},
    "api": {"context", "cpu_pipeline", "debug", "dlist", "driver", "evaluator", "execute", "lighting", "matrix", "record", "software",
            "state", "submit", "texture"},
    "glu": set(),
    "platform": {"api"},
}

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


def symbols(objects, flag):
    """{room: {symbol}} of the object files below `objects`, one directory a room; `flag` is nm's."""
    found = {}
    for room in MAY_INCLUDE:
        # A build directory keeps the objects of sources that were moved or removed since.
        files = sorted(str(file) for file in objects.glob(f"{room}/**/*.o")
                       if (SRC / file.relative_to(objects).with_suffix("")).exists())
        if files:
            lines = subprocess.run(["nm", "--format=posix", flag, *files], text=True, capture_output=True, check=True).stdout
            # Weak symbols are inline functions: every room that uses one has its own.
            found[room] = {line.split()[0] for line in lines.splitlines() if len(line.split()) > 1 and
                           line.split()[1] not in "wWvVu"}
    return found


def link_violations(needed, defined):
    """Which symbols a room needs of rooms that it may not include."""
    home = {symbol: room for room, names in defined.items() for symbol in names}
    def public(symbol):
        return symbol.startswith(("lgl", "legacy_gl_"))  # legacy_gl/*.h, open to every room

    return sorted(f"{room}: {symbol} is defined in {home[symbol]}/" for room, names in needed.items() for symbol in names
                  if symbol in home and not public(symbol) and home[symbol] not in MAY_INCLUDE[room] | {room})


class TheObjects(unittest.TestCase):
    directory = None

    def test_symbols_come_from_rooms_below(self):
        if not self.directory:
            self.skipTest("no --objects")
        needed, defined = symbols(self.directory, "--undefined-only"), symbols(self.directory, "--defined-only")
        self.assertGreater(len(defined), 10, f"no object files in {self.directory}")
        self.assertEqual(link_violations(needed, defined), [])

    def test_reports_a_call_upwards(self):
        self.assertEqual(len(link_violations({"state": {"f"}, "api": {"f", "g"}}, {"api": {"f"}, "submit": {"g"}})), 1)


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
        """api is included by platform alone, which exports its names."""
        includers = {
            room: {other for other, targets in MAY_INCLUDE.items() if room in targets}
            for room in MAY_INCLUDE
        }
        self.assertEqual(includers["api"], {"platform"})

    def test_every_name_is_a_room(self):
        for targets in MAY_INCLUDE.values():
            self.assertLessEqual(targets, MAY_INCLUDE.keys())

    def test_one_way(self):
        """No two rooms include each other, by whatever way round."""
        before = set()
        for room, targets in MAY_INCLUDE.items():
            self.assertLessEqual(targets, before, room)
            before.add(room)


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
    if "--objects" in sys.argv:
        at = sys.argv.index("--objects")
        TheObjects.directory = pathlib.Path(sys.argv[at + 1])
        del sys.argv[at:at + 2]
    sys.exit(unittest.main(verbosity=2))
