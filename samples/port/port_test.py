"""The old program and its port draw the same picture, and docs/porting.md shows the diff between them.

port_test.py BEFORE AFTER SOURCE_DIRECTORY GUIDE
"""
import difflib
import pathlib
import subprocess
import sys
import tempfile


def picture(program, directory):
    path = pathlib.Path(directory, pathlib.Path(program).name + ".ppm")
    subprocess.run([program, path], check=True)
    header, pixels = path.read_bytes().split(b"\n", 1)
    return header, pixels


def diff(directory):
    before, after = (
        pathlib.Path(directory, name).read_text().splitlines() for name in ("before.c", "after.c")
    )
    lines = difflib.unified_diff(before, after, "before.c", "after.c", lineterm="")
    return "\n".join(line.rstrip() for line in lines)


def main(before, after, source_directory, guide):
    with tempfile.TemporaryDirectory() as directory:
        old_header, old = picture(before, directory)
        new_header, new = picture(after, directory)
    if old_header != new_header or len(old) != len(new):
        return "the pictures differ in size"
    if len(set(old)) < 50:
        return "the old program draws nothing"
    # One step: equal colours on either side of a rounding.
    largest = max(abs(a - b) for a, b in zip(old, new))
    if largest > 1:
        return f"the pictures differ by {largest} steps"
    if diff(source_directory) not in pathlib.Path(guide).read_text():
        return f"{guide} does not show this diff:\n{diff(source_directory)}"
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
