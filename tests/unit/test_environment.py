"""The program's private environment is made by whatever Python the runner has first on its PATH."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parent.parent.parent / "scripts/environment.py"
LOCK = SCRIPT.with_name("requirements.txt")
ENVIRONMENT = "roslab-python-" + hashlib.sha256(LOCK.read_bytes() + sys.version.encode()).hexdigest()[:12]


def old_python() -> str | None:
    """Return a real interpreter older than 3.10: of the PATH, or of pyenv."""
    pyenv = sorted(Path.home().glob(".pyenv/versions/3.[6-9].*/bin/python3"))
    names = [*(shutil.which(f"python3.{minor}") for minor in range(9, 5, -1)), *map(str, pyenv)]
    for name in filter(None, names):
        code = "import sys; sys.exit(not (3, 6) <= sys.version_info[:2] < (3, 10))"
        if subprocess.run([name, "-c", code], capture_output=True, check=False).returncode == 0:
            return name
    return None


@pytest.fixture
def old(tmp_path: Path) -> Path:
    """Return a folder whose ``python3`` is older than the program needs."""
    found = old_python()
    if found is None:
        pytest.skip("this machine has no Python older than 3.10")
    folder = tmp_path / "old"
    folder.mkdir()
    (folder / "python3").symlink_to(
        subprocess.check_output([found, "-c", "import sys; print(sys.executable)"], text=True).strip()
    )
    return folder


def run(path: list[Path], place: Path, **more: str) -> subprocess.CompletedProcess[str]:
    environment = {
        "PATH": os.pathsep.join(map(str, path)),
        "RUNNER_TEMP": str(place),
        "GITHUB_OUTPUT": str(place / "output"),
        "RUNNER_TOOL_CACHE": str(place / "tools"),
        **{name: value for name, value in os.environ.items() if name.startswith(("PIP_", "SSL_", "REQUESTS_"))},
        **more,
    }
    return subprocess.run(
        [path[0] / "python3", "-I", SCRIPT], env=environment, capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize("where", ["PATH", "tool cache"])
def test_an_older_python_first_on_path_stops_nothing(tmp_path: Path, old: Path, where: str) -> None:
    new = tmp_path / ("tools/Python/3.12.1/x64/bin" if where == "tool cache" else "new")
    new.mkdir(parents=True)
    (new / "python3").symlink_to(sys.executable)
    path = [old] if where == "tool cache" else [old, new]
    made = tmp_path / ENVIRONMENT  # as an earlier use in the same job left it: nothing is installed here
    made.mkdir()
    ran = run(path, tmp_path)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert (tmp_path / "output").read_text() == f"python={made}/bin/python\n"


def test_the_runners_owner_may_keep_it_for_all_jobs(tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    (kept / ENVIRONMENT).mkdir(parents=True)
    ran = run([Path(sys.executable).parent], tmp_path, ROSLAB_PYTHON_CACHE=str(kept))
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert (tmp_path / "output").read_text() == f"python={kept / ENVIRONMENT}/bin/python\n"


def test_what_cannot_be_made_leaves_nothing_that_looks_made(tmp_path: Path) -> None:
    place = tmp_path / "runner"
    place.mkdir()
    ran = run([Path(sys.executable).parent], place, PIP_NO_INDEX="1", PIP_NO_CACHE_DIR="1")
    assert ran.returncode == 5
    assert "::error::the private Python environment cannot be made: `" in ran.stdout
    assert not list(place.iterdir())
