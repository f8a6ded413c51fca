"""The table of entry points, src/api/entry_points/*.json: sections, summaries and errors.

A chapter is {"chapter", "section", "entry_points": [row...]}. A row:

  name              entry point without gl, as a regular expression: a row may speak for a family
  section           of the OpenGL 2.1 specification, when it is not the chapter's
  summary           shapes, units, spaces, ranges
  inside_begin_end  true: allowed there; "undefined": may raise GL_INVALID_OPERATION or not; missing: raises it
  in_lists          false: executed at once while a list is being compiled; missing: lists hold it
  valid_call        C++ calls that raise nothing outside glBegin/glEnd; gl is the table of functions
  valid_call_setup  what goes before them
  errors            [{"code", "when", "call", "setup", "mesa_differs"}...]

"call" and "setup" are C++ with the help of tests/gl/error_cases.cpp. <a|b> in them stands for one test
with a and one with b. An error without "call" is documentation. "mesa_differs" says why Mesa's code is
another one.
"""

import itertools
import json
import re
from dataclasses import dataclass, field


@dataclass
class Chapter:
    title: str
    section: str
    rows: list
    names: list = field(default_factory=list)  # its entry points, row by row


def _section_key(section):
    return [int(part) for part in section.split(".")]


def read(directory, api):
    """Chapters in the specification's order, and name -> row. Every entry point has exactly one row."""
    chapters, table = [], {}
    for path in sorted(directory.glob("*.json")):
        source = json.loads(path.read_text())
        chapter = Chapter(source["chapter"], source["section"], source["entry_points"])
        for row in chapter.rows:
            row.setdefault("section", chapter.section)
            names = [name for name in api.commands if re.fullmatch(row["name"], name)]
            if not names:
                raise SystemExit(f"{path.name}: no entry point is called {row['name']}")
            for name in names:
                if name in table:
                    raise SystemExit(f"{path.name}: {name} has a row already: {table[name]['name']}")
                table[name] = row
            chapter.names += names
        chapters.append(chapter)
    missing = [name for name in api.commands if name not in table]
    if missing:
        raise SystemExit("no row in src/api/entry_points: " + ", ".join(missing))
    return sorted(chapters, key=lambda c: _section_key(c.section)), table


def expand(*texts):
    """<a|b> in any of the texts: all combinations, the same alternatives varying together."""
    groups = list(dict.fromkeys(g for text in texts for g in re.findall(r"<([^<>]*\|[^<>]*)>", text)))
    for choice in itertools.product(*(group.split("|") for group in groups)):
        result = texts
        for group, value in zip(groups, choice):
            result = tuple(text.replace(f"<{group}>", value) for text in result)
        yield result


def valid_calls(row):
    if row.get("inside_begin_end"):
        return
    for call in row.get("valid_call", []):
        yield from expand(call, row.get("valid_call_setup", ""))
