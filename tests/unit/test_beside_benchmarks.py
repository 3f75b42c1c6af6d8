"""The benchmarks measure the program that lies beside them, not another that is installed."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def test_the_program_beside_them_is_measured(tmp_path: Path) -> None:
    package = tmp_path / "roslab"
    package.mkdir()
    (package / "__init__.py").write_text("")
    said = subprocess.run(
        [sys.executable, "-c", "import benchmarks, roslab; print(roslab.__file__)"],
        cwd=ROOT,
        env={"PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert Path(said.stdout.strip()).parent == ROOT / "scripts" / "roslab"
