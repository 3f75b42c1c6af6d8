"""A conda environment that was written on Windows or macOS is made from what Linux has of it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan
from roslab.render.dockerfile import dockerfile

WINDOWS = """\
name: a
channels:
  - pytorch
  - conda-forge
dependencies:
  - blas=1.0=mkl
  - conda-forge::certifi=2021.5.30=py38haa95532_0
  - cudatoolkit=11.1.1=heb2d755_7
  - ffmpeg=4.3.1=ha925a31_0
  - icc_rt=2019.0.0=h0cc432a_1
  - m2w64-gmp=6.1.0=2
  - numpy=1.20.3=py38ha4e8547_0
  - python=3.8.10=hdbf39b2_7
  - pytorch=1.9.0=py3.8_cuda11.1_cudnn8_0
  - vs2015_runtime=14.27.29016=h5e58377_2
  - pip:
    - einops==0.3.0
    - pywin32==301
"""
LINUX = (
    *("blas=1.0=mkl", "conda-forge::certifi=2021.5.30", "cudatoolkit=11.1.1", "ffmpeg", "numpy=1.20.3"),
    *("python=3.8.10", "pytorch=1.9.0"),
)


def plan_of(folder: Path, text: str) -> Plan:
    (folder / "environment.yml").write_text(text)
    (folder / "main.py").write_text("import numpy\nif __name__ == '__main__':\n    print('a')\n")
    return plan_repository(folder).plan


def told(plan: Plan) -> list[str]:
    return [each.message for each in plan.warnings if "is of an environment on" in each.message]


def test_what_windows_alone_has_and_builds_are_left_out(tmp_path: Path) -> None:
    plan = plan_of(tmp_path, WINDOWS)
    assert plan.python.conda_specs == LINUX
    assert plan.python.conda_channels == ("pytorch", "conda-forge", "defaults")
    assert plan.python.pip == ("einops==0.3.0",)
    assert len(told(plan)) == 1
    text = dockerfile(plan)
    assert "/tmp/manifests/environment.yml" not in text
    assert "--channel defaults \\\n      blas=1.0=mkl" in text


@pytest.mark.parametrize(
    ("prefix", "system"),
    [
        ("C:\\Users\\me\\a", "Windows"),
        ("'D:/envs/a'", "Windows"),
        ("/Users/me/a", "macOS"),
        ("/home/me/a", ""),
        ("", ""),
    ],
)
def test_the_place_of_the_environment_tells_the_system(tmp_path: Path, prefix: str, system: str) -> None:
    libcxx = "  - libcxx=12.0.0=h2f01273_0\n" if system == "macOS" else ""
    lines = f"name: a\ndependencies:\n{libcxx}  - numpy=1.20.3=py38h4b4dc7a_0\n  - python=3.8.10=h88f2d9e_7\n"
    plan = plan_of(tmp_path, f"{lines}prefix: {prefix}\n" if prefix else lines)
    assert [each.split(":")[0].rpartition(" ")[2] for each in told(plan)] == [system][: bool(system)]
    assert plan.python.conda_specs == (("numpy=1.20.3", "python=3.8.10") if system else ())


def test_a_file_that_linux_can_read_stays(tmp_path: Path) -> None:
    plan = plan_of(tmp_path, "name: a\ndependencies:\n  - python=3.8\n  - numpy\nprefix: C:\\Users\\me\\a\n")
    assert not told(plan)
    assert plan.python.conda_specs == ()
    assert "/tmp/manifests/environment.yml" in dockerfile(plan)


def test_channels_that_are_shut_out_stay_so(tmp_path: Path) -> None:
    text = WINDOWS.replace("  - conda-forge\n", "  - conda-forge\n  - nodefaults\n", 1)
    assert plan_of(tmp_path, text).python.conda_channels == ("pytorch", "conda-forge")
