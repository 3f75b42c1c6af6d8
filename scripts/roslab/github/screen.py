"""Proofs of programs with windows: the X server that they need, and their screenshots as an artifact."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager

from roslab.engine import docker as engine
from roslab.github import workflow
from roslab.github.run import Folder, Run, artifact_name, slug

INSTALL_SECONDS = 300.0


@contextmanager
def screenshots(folder: Folder, run: Run, platforms: Sequence[str], environment: Mapping[str, str]) -> Iterator[None]:
    """Prepare a job's proofs, and afterwards output where their screenshots are, also those of failed proofs.

    The outputs are ``screenshots``, a pattern of files or ``""`` if there is none, and ``screenshots-artifact``.
    """
    if not any(proof.display for proof in run.plan.proofs):
        yield
        return
    _install()
    try:
        yield
    finally:
        found = any(folder.artifact.glob("screenshot-*.png"))
        part = slug(platforms[0]) if len(platforms) == 1 else "all"
        # An artifact belongs to an attempt: a second attempt cannot replace the first one's
        name = f"{artifact_name('screenshots', run)}-{part}-{environment.get('GITHUB_RUN_ATTEMPT') or 1}"
        pattern = str(folder.artifact / "screenshot-*.png") if found else ""
        workflow.outputs({"screenshots": pattern, "screenshots-artifact": name}, environment)


def _install() -> None:
    """Install Xvfb with apt if it is missing and this user may; otherwise the proof reports what is missing."""
    if shutil.which("Xvfb") or not shutil.which("apt-get"):
        return
    root = [] if os.geteuid() == 0 else ["sudo", "--non-interactive"]
    if root and (not shutil.which("sudo") or engine.output([*root, "true"]).returncode):
        return
    apt = [*root, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get"]
    with workflow.group("Install Xvfb, which GitHub's own runners have"):
        for words in (["update"], ["install", "--yes", "--no-install-recommends", "xvfb"]):
            answer = engine.output([*apt, "--quiet", *words], timeout=INSTALL_SECONDS)
            engine.say(answer.stdout + answer.stderr)
            if answer.returncode:
                return
