#!/usr/bin/env python3
"""exports_test.py LIBRARY INCLUDE-DIRECTORY: the shared library exports what the public headers
declare with LEGACY_GL_API, no more and no less."""

import pathlib
import re
import subprocess
import sys

DECLARATION = re.compile(r"^[ \t]*LEGACY_GL_API\b[^;{]*?\b(\w+)\s*\(", re.MULTILINE)


def main(library, include_directory):
    listing = subprocess.run(
        ["nm", "--dynamic", "--defined-only", "--format=posix", library],
        check=True, capture_output=True, text=True).stdout
    exported = {line.split()[0] for line in listing.splitlines()}
    declared = set()
    for header in sorted(pathlib.Path(include_directory, "legacy_gl").glob("*.h*")):
        declared |= set(DECLARATION.findall(header.read_text(encoding="utf-8")))

    foreign = {name for name in exported if not re.fullmatch(r"(lgl|legacy_gl_)\w+", name)}
    problems = {
        "exported under a foreign name": foreign,
        "exported and in no header": exported - declared - foreign,
        "in a header and not exported": declared - exported,
    }
    for problem, names in problems.items():
        for name in sorted(names):
            print(f"{problem}: {name}")
    print(f"{len(exported)} exported, {len(declared)} declared")
    return 0 if exported and not any(problems.values()) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
