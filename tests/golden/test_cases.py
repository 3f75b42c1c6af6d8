"""What a user can meet and no example shows: each case gives exactly this Dockerfile; its ``verify`` runs in its image.

``REPRO_REFRESH=1 pytest tests/golden`` rewrites them: read the diff. The lab builds those that it can.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from golden_files import CASES, CASES_GOLDEN, contents, folded, unfolded

NAMES = sorted(path.name for path in CASES.iterdir() if path.is_dir())
RECORDED = {"submodule": ("third_party/nanoflann", "b0f109a5c726f1e565e624ee448136bf30e2e7b4")}
"""Submodules, and the commits that the tree records: nanoflann 1.3.2."""


def case(name: str, folder: Path) -> Path:
    """Copy a case to where the folder's name is the image's; one with a submodule becomes a commit that records it."""
    copy = folder / name
    shutil.copytree(CASES / name, copy)
    if name in RECORDED:
        path, commit = RECORDED[name]
        git = ["git", "-C", str(copy), "-c", "user.name=Somebody", "-c", "user.email=somebody@example.org"]
        for words in (
            ("init", "--quiet", "--initial-branch", "main"),
            ("add", "--all"),
            ("update-index", "--add", "--cacheinfo", f"160000,{commit},{path}"),
            ("commit", "--quiet", "--message", "A submodule"),
        ):
            subprocess.run([*git, *words], check=True, env={**os.environ, "GIT_COMMITTER_DATE": "2022-03-01T12:00:00Z"})
    return copy


@pytest.mark.parametrize("name", NAMES)
def test_files(roslab: Callable[..., CompletedProcess[str]], name: str, tmp_path: Path) -> None:
    copy = case(name, tmp_path)
    # Elsewhere: in one case the author's own Dockerfile stands where it would be written, and is built on what is
    create = roslab("create", copy, "--output", tmp_path / "made")
    assert create.returncode == 0, create.stderr
    written = [path for name in ("Dockerfile", "Dockerfile.bases") if (path := tmp_path / "made" / name).exists()]
    made = written[0].read_text()
    assert str(tmp_path) not in made, "a path of this machine"
    golden = CASES_GOLDEN / f"{name}.Dockerfile"
    if os.environ.get("REPRO_REFRESH") == "1":
        golden.write_text(folded("Dockerfile", made))
    assert made == unfolded(golden.read_text()), f"{golden.name} changed: REPRO_REFRESH=1, and read the diff"


def test_no_golden_file_without_its_case_and_none_without_what_must_be_seen() -> None:
    assert sorted(name.partition(".")[0] for name in contents(CASES_GOLDEN)) == NAMES
    for name in NAMES:
        assert os.access(CASES / name / "verify", os.X_OK), name
