"""Requirements that build with packages which no list of theirs names."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

SCRIPTS = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts"
PIP = """\
#!/bin/bash
echo "$*" >>"${CALLS}"
[[ "$*" = *--no-build-isolation* ]] || exit "${ALONE}"
"""


def calls(tmp_path: Path, requirements: str, alone: int) -> list[str]:
    """Run the step that installs the requirement files with a pip that exits with ``alone`` at its first call."""
    root = tmp_path / "repository"
    root.mkdir()
    (root / "requirements.txt").write_text(requirements)
    (root / "demo.py").write_text("import numpy\n")
    text = dockerfile(plan_repository(root).plan)
    step = re.search(r"# Requirement files\n(?:COPY .*\n)+RUN (?:--mount\S+ \\\n)?((?:.*\\\n)*.*)\n", text)
    assert step is not None
    programs = tmp_path / "bin"
    programs.mkdir()
    for name, script in (("python3", PIP), ("pip-cache", "#!/bin/bash\necho --no-cache-dir\n")):
        (programs / name).write_text(script)
        (programs / name).chmod(0o755)
    shutil.copy(SCRIPTS / "ask-pip-again.sh", programs / "ask-pip-again")
    log = tmp_path / "calls"
    environment = {"PATH": f"{programs}:/usr/bin:/bin", "CALLS": str(log), "ALONE": str(alone)}
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", step[1]], env=environment, timeout=60, check=False)
    found = log.read_text().splitlines()
    return [*found, f"exit {done.returncode}"]


ALONE = "-m pip install --no-cache-dir --requirement /tmp/manifests/requirements.txt"
TOGETHER = ALONE.replace(" --requirement", " --no-build-isolation --requirement")


@pytest.mark.parametrize(
    ("requirements", "alone", "expected"),
    [
        ("torch\nMinkowskiEngine\n", 1, [ALONE, TOGETHER, "exit 0"]),
        ("torch\nMinkowskiEngine\n", 0, [ALONE, "exit 0"]),
        ("numpy\n", 1, [ALONE, "exit 1"]),
    ],
)
def test_what_imports_torch_in_its_setup_py_finds_it(
    tmp_path: Path, requirements: str, alone: int, expected: list[str]
) -> None:
    assert calls(tmp_path, requirements, alone) == expected
