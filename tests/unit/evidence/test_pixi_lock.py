"""What a manifest of pixi leaves free has the version of its lock."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.python import pixi
from roslab.repository.checkout import Repository

MANIFEST = "[workspace]\nchannels = ['conda-forge']\nplatforms = ['linux-64']\n[dependencies]\n{}\n"
LINE = "{}- conda: https://conda.anaconda.org/conda-forge/{}/{}.conda\n"
LOCK = (
    "version: 6\nenvironments:\n  default:\n    channels:\n    - url: https://conda.anaconda.org/conda-forge/\n"
    "    packages:\n      linux-64:\n"
    + LINE.format("{indent}", "linux-64", "python-3.11.9-hb806964_0_cpython")
    + LINE.format("{indent}", "noarch", "opencv-python-4.9.0-py_0")
    + LINE.format("{indent}", "linux-64", "jpeg-9e-h0b41bf4_3")
    + "      osx-64:\n"
    + LINE.format("{indent}", "osx-64", "eigen-3.3.0-h1_0")
    + "  docs:\n    packages:\n      linux-64:\n"
    + LINE.format("{indent}", "noarch", "sphinx-7.2.6-pyhd8ed1ab_0")
    + "packages:\n"
    + LINE.format("", "linux-64", "numpy-1.26.4-py311_0")
)


@pytest.mark.parametrize("indent", ["      ", "        "])
@pytest.mark.parametrize(
    ("asked", "spec"),
    [
        ("python = '*'", "python=3.11.9"),
        ("python = '>=3.10,<3.13'", "python=3.11.9"),
        ("python = '3.12.*'", "python=3.12.*"),
        ("opencv-python = '*'", "opencv-python=4.9.0"),
        ("jpeg = '*'", "jpeg=9e"),
        ("eigen = '*'", "eigen"),
        ("sphinx = '*'", "sphinx"),
        ("numpy = '>=1.20'", "numpy>=1.20"),
    ],
)
def test_the_default_environment_for_linux_is_read(tmp_path: Path, indent: str, asked: str, spec: str) -> None:
    (tmp_path / "pixi.toml").write_text(MANIFEST.format(asked))
    (tmp_path / "pixi.lock").write_text(LOCK.replace("{indent}", indent))
    (found,) = pixi.read(Repository.open(tmp_path))
    assert found.specs == (spec,)
    assert found.python == (spec[7:11] if asked.startswith("python") else None)
