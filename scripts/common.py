"""What the Python scripts beside this file share: Debian packages, and an X server of their own."""

import contextlib
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def installed(package):
    status = subprocess.run(["dpkg-query", "--show", "--showformat=${db:Status-Status}", package],
                            capture_output=True, text=True, check=False).stdout
    return status == "installed"


def install(packages):
    missing = [p for p in sorted(set(packages)) if not installed(p)]
    if not missing:
        return
    root = [] if os.geteuid() == 0 else ["sudo"]
    apt = [*root, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get"]
    subprocess.run([*apt, "update", "--quiet"], check=True, stdout=subprocess.DEVNULL)
    for package in missing:
        print(f"==> Installing {package}", flush=True)
        if subprocess.run([*apt, "install", "--yes", "--quiet", "--no-install-recommends", package],
                          check=False, stdout=subprocess.DEVNULL).returncode:
            print(f"    {package} is not to be had")


@contextlib.contextmanager
def x_server(size="640x480"):
    """An X server; yields its display. It does not start anew when its last client leaves: SDL opens the display
    twice, and the second time would meet that."""
    reader, writer = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{size}x24", "-nolisten", "tcp", "-noreset"],
                              pass_fds=[writer], stderr=subprocess.DEVNULL)
    os.close(writer)
    with os.fdopen(reader) as pipe:
        display = pipe.readline().strip()
    if not display:
        sys.exit("Xvfb did not start")
    try:
        yield f":{display}"
    finally:
        server.terminate()
        server.wait()


def environment(display, ours, home):
    """On llvmpipe, without vsync; for ours on a driver that is told to have no fixed function."""
    env = dict(os.environ, DISPLAY=display, LIBGL_ALWAYS_SOFTWARE="1", HOME=home, vblank_mode="0",
               XDG_RUNTIME_DIR=home, NO_AT_BRIDGE="1", SDL_AUDIODRIVER="dummy")
    if ours:
        env["MESA_GL_VERSION_OVERRIDE"] = "4.5FC"
    return env


def drop_in_runner(build):
    """The command that puts the drop-in of that build in the place of the system's libGL."""
    runner = build / "bin/legacy-gl-run"
    if not os.access(runner, os.X_OK):
        sys.exit(f"{runner} is not there: build first (scripts/test)")
    return [str(runner)]
