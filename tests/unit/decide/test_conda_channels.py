"""What a conda file lists as a channel and is none."""

from __future__ import annotations

import subprocess
from pathlib import Path

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
