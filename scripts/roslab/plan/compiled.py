"""Rung 0: what scripts of the repository compile for Python is there."""

from __future__ import annotations

from roslab.decide.decision import Decision
from roslab.plan.proof import Proof
from roslab.plan.workspace import Workspace
from roslab.values.endings import SHELL_SCRIPTS

COMPILED_SCRIPT = """\
import io, os, re, sys
seen, failed = 0, []
for folder, folders, files in os.walk(sys.argv[1]):
    folders[:] = [each for each in folders if each not in (".git", "build")]
    if "setup.py" not in files or not os.path.isdir(os.path.join(folder, "build")):
        continue
    with io.open(os.path.join(folder, "setup.py"), encoding="utf-8", errors="replace") as file:
        if not re.search("Extension *[(]", file.read()):
            continue
    seen += 1
    if not any(name.endswith(".so") for _, _, names in os.walk(folder) for name in names):
        failed.append(folder)
print("extensions looked at: %d" % seen)
sys.exit("\\n".join("%s: its setup.py has compiled no module" % each for each in failed) or 0)
"""
"""A setup.py that was called leaves the folder ``build``, and in it, or beside its package, each module it compiled.

https://setuptools.pypa.io/en/latest/userguide/ext_modules.html, read 2026-11-25.
"""


def compiled(decision: Decision, place: Workspace) -> list[Proof]:
    """Return the proof that each extension which a script began to compile has a module.

    The step of the image tolerates such a script, which may end well although one of its commands failed.
    """
    called = (each for each in decision.scripts if each.path.endswith((*SHELL_SCRIPTS, ".py")) and not each.copies)
    python = decision.python
    installs = python.pip or python.pip_guessed or python.requirements or python.conda_file or python.conda_specs
    if decision.dockerfile is not None or not any(called) or not installs:
        return []
    interpreter = "python2" if (python.version or "").startswith("2") else "python3"
    command = ("bash", "-c", f'cd && exec {interpreter} -c "$@"', "proof", COMPILED_SCRIPT, place.folder)
    return [Proof(name="what scripts compile for Python is there", command=command)]
