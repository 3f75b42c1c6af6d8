"""Make the program's private Python environment on a runner, from the hashed lock beside this file.

Run as ``python3 -I environment.py``; prints nothing and sets the step's output ``python``. The runner's own packages,
PYTHONPATH and the caller's repository are out of reach of what runs in it. It lies in the job's own RUNNER_TEMP, where
a second use in that job finds it; the owner of a runner may name another folder, ROSLAB_PYTHON_CACHE, for all its jobs.
It is read by the runner's Python, whatever its age: hence no syntax newer than 3.6.
"""

# The same reason for what the linter would rather see:
# ruff: noqa: PTH100, PTH103, PTH104, PTH112, PTH118, PTH119, PTH120, PTH123, PTH207, UP031

import glob
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile

LOCK = os.path.join(os.path.dirname(os.path.abspath(__file__)), "requirements.txt")
DISTURBING = ("PIP_TARGET", "PIP_PREFIX", "PIP_USER", "PIP_REQUIRE_VIRTUALENV", "PYTHONPATH", "PYTHONHOME")
"""Settings that would install elsewhere; a mirror that the runner's owner set stays, the hashes guard what it gives."""
OLDEST = (3, 10)
NEWER = ["python3.%d" % minor for minor in range(14, OLDEST[1] - 1, -1)]
PROBE = """
import sys, venv
try:
    import ensurepip
except ImportError:
    import pip
sys.exit(sys.version_info < (%d, %d))
"""
"""Ends with 0 in an interpreter that can make the environment."""


def main() -> int:
    """Return the exit code: 0, or 5 where the environment cannot be made."""
    if sys.version_info < OLDEST:
        newer = newer_python()
        if newer:
            return subprocess.call([newer, "-I", os.path.abspath(__file__)])
        return fail(
            "python3 is %s of version %d.%d, and no python3 of version %d.%d or newer is on this runner: give "
            "actions/setup-python a newer python-version, or put that step after this one"
            % (sys.executable, *sys.version_info[:2], *OLDEST)
        )
    with open(LOCK, "rb") as stream:
        content = stream.read() + sys.version.encode()
    place = os.environ.get("ROSLAB_PYTHON_CACHE") or os.environ.get("RUNNER_TEMP") or "."
    folder = os.path.join(os.path.abspath(place), "roslab-python-" + hashlib.sha256(content).hexdigest()[:12])
    if not os.path.isdir(folder):
        failed = make(folder)
        if failed:
            return fail("the private Python environment cannot be made: %s" % failed)
    python = os.path.join(folder, "bin", "python")
    with open(os.environ.get("GITHUB_OUTPUT") or os.devnull, "a", encoding="utf-8") as stream:
        stream.write("python=" + python + "\n")
    return 0


def make(folder):  # type: (str) -> str
    """Make the environment and return "", else what failed.

    It gets its name when it is complete: a job that was ended leaves none that is half made, and of two that make it at
    once the first one's stays.
    """
    try:
        os.makedirs(os.path.dirname(folder), exist_ok=True)
        made = tempfile.mkdtemp(prefix=os.path.basename(folder) + "-", dir=os.path.dirname(folder))
    except OSError as error:
        return str(error)
    python = os.path.join(made, "bin", "python")
    environment = {name: value for name, value in os.environ.items() if name not in DISTURBING}
    install = ["install", "--quiet", "--disable-pip-version-check", "--no-input", "--no-deps", "--require-hashes"]
    install += ["--only-binary", ":all:", "--requirement", LOCK]
    if lends_pip():
        commands = (
            [sys.executable, "-I", "-m", "venv", "--clear", "--without-pip", made],
            [sys.executable, "-I", "-m", "pip", "--python", python, *install],
        )
    else:
        commands = (
            [sys.executable, "-I", "-m", "venv", "--clear", made],
            [python, "-I", "-m", "pip", *install],
        )
    try:
        for command in commands:
            # pip's own words go to the log; one clear line is the annotation
            if subprocess.call(command, env=environment):
                return "`%s` failed" % " ".join(command[1:5])
        os.rename(made, folder)
    except OSError as error:
        return "" if os.path.isdir(folder) else str(error)
    finally:
        shutil.rmtree(made, ignore_errors=True)
    return ""


def newer_python() -> str:
    """Return an interpreter that is new enough, "" where the runner has none.

    The first ``python3`` on PATH may be what an earlier step installed for the caller's own code. The runner's own is
    behind it, and others lie in its tool cache:
    https://docs.github.com/en/actions/reference/workflows-and-actions/variables#default-environment-variables
    """
    folders = (os.environ.get("PATH") or "").split(os.pathsep)
    found = [os.path.join(folder, name) for name in ["python3", *NEWER] for folder in folders if folder]
    cache = os.environ.get("RUNNER_TOOL_CACHE") or "/opt/hostedtoolcache"
    found += sorted(glob.glob(os.path.join(cache, "Python", "3.*", "*", "bin", "python3")), reverse=True)
    for python in found:
        if os.access(python, os.X_OK):
            with open(os.devnull, "w") as nothing:
                command = [python, "-I", "-c", PROBE % OLDEST]
                if not subprocess.call(command, stdout=nothing, stderr=nothing):
                    return python
    return ""


def lends_pip() -> bool:
    """Tell whether the runner's own pip can install elsewhere: it spares unpacking another, half of the time."""
    try:
        import pip  # noqa: PLC0415 - many an interpreter has none
    except ImportError:
        return False
    return tuple(int(part) for part in pip.__version__.split(".")[:2] if part.isdigit()) >= (22, 3)


def fail(reason: str) -> int:
    """Show why, as an annotation of the run."""
    sys.stdout.write("::error::%s\n" % reason)
    return 5


if __name__ == "__main__":
    sys.exit(main())
