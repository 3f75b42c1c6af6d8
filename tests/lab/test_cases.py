"""What users meet and no example shows: built with what a stand-in has, and what must be in the image looked at."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from . import laboratory
from .laboratory import Laboratory

CASES = Path(__file__).resolve().parent.parent / "cases"
BUILT = {
    "format_2019": [],
    "isolated": [],
    "local_base": [],
    "offscreen": [],
    "rosbuild": ["ros:indigo-ros-base"],
    "window": [],
}
"""Those that the lab builds, with the stand-ins that it makes only when they are asked for."""
NEEDS_MORE = {
    "conda_environment": "conda's installer and its channels",
    "python2_node": "Python 2, which Debian 12 has not",
    "source_library": "Pangolin from its code host",
    "submodule": "nanoflann from its code host",
}
"""Those that the lab does not build, and what they would need. Their Dockerfiles are golden files."""


def test_each_case_is_built_or_says_what_it_would_need() -> None:
    assert {path.name for path in CASES.iterdir()} == {*BUILT, *NEEDS_MORE}


@pytest.mark.usefixtures("x_server")
@pytest.mark.parametrize("case", BUILT)
def test_the_image_has_what_it_must(
    roslab: Callable[..., CompletedProcess[str]], lab: Laboratory, tmp_path: Path, case: str
) -> None:
    """`verify` of the case runs inside the image, as the author's own test."""
    if BUILT[case]:
        laboratory.up(bases=BUILT[case])
    repository = tmp_path / case
    shutil.copytree(CASES / case, repository)
    built = roslab("build", repository, "--tag", "repro-lab", "--test", "./verify", env=lab.environment, timeout=1800)
    assert built.returncode == 0, built.stderr[-8000:]
    image = built.stdout.strip()
    assert image.endswith(":repro-lab")
    subprocess.run(["docker", "image", "rm", image], env=dict(lab.environment), capture_output=True, check=True)
