"""What a conda file lists as a channel and is none, and the channels of one that names none."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

CHANNELS = """\
name: a
channels:
  - https://anaconda.org/pytorch3d/pytorch3d/0.7.4/download
  - "https://anaconda.org/lab/tool"  # its page
  - https://example.org/pkgs/linux-64/tool-1.0-py38_0.tar.bz2
  - https://conda.anaconda.org/lab
  - https://anaconda.org/lab/label/dev
  - https://mirrors.example.org/anaconda/pkgs/main
  - conda-forge
dependencies:
  - python=3.8
"""


def test_what_is_no_channel_is_told_and_left_out(tmp_path: Path) -> None:
    (tmp_path / "environment.yml").write_text(CHANNELS)
    (tmp_path / "train.py").write_text("import torch\n")
    planned = plan_repository(tmp_path)
    out = CHANNELS.splitlines()[2:5]
    assert [each.strip(' -"').partition('"')[0] for each in out] == [*planned.plan.python.conda_no_channels]
    told = [w.message.partition(" is no channel")[0] for w in planned.plan.warnings if "is no channel" in w.message]
    assert told == [*planned.plan.python.conda_no_channels]
    command = next(
        line
        for line in dockerfile(planned.plan).splitlines()
        if "sed --in-place" in line and "/environment.yml" in line
    )
    command = command.strip("RUN &\\").replace("/tmp/manifests/environment.yml", str(tmp_path / "environment.yml"))
    subprocess.run(["bash", "-c", command], check=True)
    kept = [line for line in CHANNELS.splitlines() if line not in out]
    assert (tmp_path / "environment.yml").read_text().splitlines() == kept


LIST = "# platform: linux-64\npython=3.7.6=h0371630_2\nnumpy=1.18.1=py37h4f9e942_0\n"
PAGE = "# Install\n```\n{}\n```\n"
BY_PAGE = "conda install torchvision cudatoolkit=10.2 -c pytorch\nconda install --channel=conda-forge -c <yours> tool"


@pytest.mark.parametrize(
    ("more", "page", "channels"),
    [
        ("", "", ("defaults",)),
        ("", BY_PAGE, ("defaults", "pytorch", "conda-forge")),
        ("", "conda create -n a --file spec.txt -c lab\n" + BY_PAGE, ("lab",)),
        ("magma-cuda101=2.5.1=1\n", "", ("defaults", "pytorch")),
        ("pytorch=1.6.0=py3.7_cuda10.1.243_cudnn7.6.3_0\n", "", ("defaults", "pytorch")),
        ("pytorch=1.4.0=cuda101py37h02f0884_0\n", "", ("defaults",)),
        ("_libgcc_mutex=0.1=conda_forge\n", "", ("defaults", "conda-forge")),
        ("tqdm=4.62.2=pyhd8ed1ab_0\n", "", ("defaults", "conda-forge")),
        ("colorama=0.4.4=pyh9f0ad1d_0\n", "", ("defaults", "conda-forge")),
        ("metar=1.8.0=pyhd3deb0d_0\n", "", ("defaults", "conda-forge")),
        ("ca-certificates=2021.5.30=ha878542_0\n", "", ("defaults", "conda-forge")),
        ("certifi=2021.5.30=py37h89c1867_0\n", "", ("defaults", "conda-forge")),
        ("python_abi=3.7=2_cp37m\n", "", ("defaults", "conda-forge")),
        ("six=1.16.0=pyh6c4a22f_0\npytorch=1.9.0=py3.7_cpu_0\n", "", ("defaults", "pytorch", "conda-forge")),
        (
            "six=1.16.0=pyhd3eb1b0_0\nca-certificates=2021.5.30=h06a4308_0\nwheel=0.37=py37h06a4308_0\n",
            "",
            ("defaults",),
        ),
    ],
)
def test_a_list_without_channels_has_those_of_its_page_and_its_builds(
    tmp_path: Path, more: str, page: str, channels: tuple[str, ...]
) -> None:
    (tmp_path / "spec.txt").write_text(LIST + more)
    (tmp_path / "train.py").write_text("import numpy\n")
    (tmp_path / "README.md").write_text(PAGE.format(page or "pip install -r spec.txt"))
    plan = plan_repository(tmp_path).plan
    assert (plan.python.conda_file, plan.python.conda_channels) == ("spec.txt", channels)
    assert f"/opt/conda {' '.join(f'--channel {each}' for each in channels)} python=3.7.6" in " ".join(
        dockerfile(plan).replace("\\\n", "").split()
    )


@pytest.mark.parametrize(
    ("listed", "before"),
    [
        ("", ["CONDA_CHANNELS=pytorch,conda-forge,defaults"]),
        ("channels: [lab]\n", ["CONDA_CHANNELS=defaults"]),
        ("channels: [nodefaults, lab]\n", []),
    ],
)
def test_so_has_a_file_without_channels(tmp_path: Path, listed: str, before: list[str]) -> None:
    (tmp_path / "environment.yml").write_text(f"{listed}dependencies:\n  - python=3.8\n  - numpy\n")
    (tmp_path / "train.py").write_text("import numpy\n")
    (tmp_path / "README.md").write_text(PAGE.format("conda env create -f environment.yml\n" + BY_PAGE))
    text = dockerfile(plan_repository(tmp_path).plan)
    (line,) = [line for line in text.splitlines() if "micromamba create" in line]
    assert [word for word in line.split() if word.startswith("CONDA_CHANNELS=")] == before
