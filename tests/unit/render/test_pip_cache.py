"""What pip downloads is kept where the builder's disk has room for that too."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "pip-cache.sh"


@pytest.mark.parametrize(
    ("said", "option"),
    [("Avail\n   21\n", "--cache-dir={cache}"), ("Avail\n   19\n", "--no-cache-dir"), ("", "--no-cache-dir")],
)
def test_the_disk_decides(tmp_path: Path, said: str, option: str) -> None:
    cache = tmp_path / "pip"
    for folder in ("wheels", "http-v2"):
        (cache / folder).mkdir(parents=True)
    (tmp_path / "said").write_text(said)
    (tmp_path / "df").write_text(f'#!/bin/bash\n[ -s "{tmp_path}/said" ] && cat "{tmp_path}/said"\n')
    (tmp_path / "df").chmod(0o755)
    script = SCRIPT.read_text()
    assert script.count("cache=/root/.cache/pip\n") == 1
    script = script.replace("cache=/root/.cache/pip\n", f"cache={cache}\n")
    environment = {**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"}
    answer = subprocess.run(["bash", "-c", script], env=environment, capture_output=True, text=True, check=True)
    assert answer.stdout == option.format(cache=cache) + "\n"
    assert sorted(folder.name for folder in cache.iterdir()) == ["http-v2"], (
        "a wheel that was built fits one image alone"
    )
