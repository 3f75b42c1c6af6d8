"""conda solves an environment for the GPU although the machine that builds has none."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]


def _environment(*packages: str) -> dict[str, str]:
    lines = "".join(f"  - {package}\n" for package in ("python=3.8", *packages))
    return {"environment.yml": f"channels: [conda-forge]\ndependencies:\n{lines}", "run.py": "import torch\n"}


@pytest.mark.parametrize(
    ("packages", "cuda"),
    [
        (("pytorch=1.10.2", "cudatoolkit=11.3"), "11.3"),
        (("pytorch=2.1", "cuda-version=12.1"), "12.1"),
        (("numpy",), ""),
    ],
)
def test_conda_is_told_the_cuda_of_the_image(tree: Tree, packages: tuple[str, ...], cuda: str) -> None:
    decision = tree({**_environment(*packages), **({} if cuda else {"run.py": "import numpy\n"})})
    assert decision.python.manager == "conda"
    assert decision.python.conda_cuda == cuda


def test_a_newer_cuda_of_the_environment_is_what_its_packages_ask_for(tree: Tree) -> None:
    authored = {"docker/Dockerfile": "FROM nvidia/cuda:11.3.1-devel-ubuntu20.04\nRUN pip install torch==1.12.1+cu113\n"}
    decision = tree({**_environment("pytorch", "cuda-toolkit=12.1"), **authored})
    assert decision.python.conda_cuda == "12.1"


def test_a_deleted_image_leaves_conda_its_own_cuda(tree: Tree) -> None:
    decision = tree(_environment("pytorch=1.6.0", "cudatoolkit=10.2"))
    (said,) = [each.message for each in decision.warnings if each.message.startswith("CUDA 10.2: its images were")]
    assert "What conda installs loads its own, but what is compiled in the image is for 11." in said
    assert "will not see the GPU" not in said


def test_pip_needs_none(tree: Tree) -> None:
    assert not tree({"requirements.txt": "torch==1.13.1\n"}).python.conda_cuda


FREEZE = ("pytorch=1.8.0=py3.9_cuda11.1_cudnn8.0.5_0", "torchvision=0.9.0=py39_cu111", "pyyaml=6.0")
OWN = "from setuptools import setup\nsetup(name='demo', packages=['demo'], install_requires=['torch', 'pyyaml'])\n"


def _frozen(*packages: str, folder: str = "conda/") -> dict[str, str]:
    lines = "".join(f"  - {package}\n" for package in ("python=3.9", *packages))
    return {
        f"{folder}environment.yml": f"channels: [pytorch]\ndependencies:\n{lines}",
        "setup.py": OWN,
        "demo/__init__.py": "",
        "README.md": f"```\nconda env create -f {folder}environment.yml\npip install -e .\npython run.py\n```\n",
        "run.py": "import torch\nimport yaml\nprint(torch.zeros(1).cuda(), yaml.load('a'))\n",
        "pip/requirements.txt": "torch==1.8.0\n",
    }


@pytest.mark.parametrize("packages", [FREEZE, ("pytorch=1.8.0", "cudatoolkit=11.1", "pyyaml=6.0")])
def test_pip_replaces_nothing_that_the_environment_pins(tree: Tree, packages: tuple[str, ...]) -> None:
    decision = tree(_frozen(*packages, folder="" if "cudatoolkit=11.1" in packages else "conda/"))
    assert (decision.python.manager, decision.python.projects) == ("conda", (".",))
    assert not {each.key for each in decision.python.bounds} & {"torch", "pyyaml"}
    assert decision.python.options == ()
    assert decision.cuda == "11.1"
    assert not [warning for warning in decision.warnings if "CUDA" in warning.message]


def test_a_torch_that_pip_installs_beside_conda_comes_from_the_index_of_its_cuda(tmp_path: Path) -> None:
    lines = "channels: [defaults]\ndependencies:\n  - python=3.7\n  - pip:\n    - torch==1.7.1\n"
    (tmp_path / "environment.yml").write_text(lines)
    (tmp_path / "run.py").write_text("import torch\ntorch.zeros(1).cuda()\n")
    plan = plan_repository(tmp_path).plan
    page = "--find-links https://download.pytorch.org/whl/cu110/torch_stable.html"
    assert re.search(rf"{re.escape(page)} --upgrade --requirement environment.yml.pip", dockerfile(plan))
    assert [each for each in plan.warnings if "will not see the GPU" in each.message] == []


@pytest.mark.parametrize(
    ("channels", "packages", "limited"),
    [
        ("pytorch, conda-forge", "python=3.7, cudatoolkit=11.1, pytorch, torchvision", True),
        ("pytorch, conda-forge", "python=3.8, cudatoolkit=11.3.1, pytorch>=1.9", True),
        ("pytorch, conda-forge", "python=3.8, cudatoolkit, pytorch", True),
        ("pytorch, nvidia, defaults", "python=3.11, pytorch-cuda=11.8, pytorch", True),
        ("defaults", "python=3.8, cudatoolkit=11.3, pytorch::pytorch", True),
        ("pytorch, conda-forge", "python=3.8, cudatoolkit=11.3, pytorch=1.12", True),
        ("pytorch, conda-forge", "python=3.8, cudatoolkit=11.1, pytorch=1.12", False),  # none is for 11.1
        ("pytorch, conda-forge", "python=3.8, cudatoolkit=11.1, pytorch>=1.11", False),
        ("pytorch, conda-forge", "python=3.8, cudatoolkit=11.3, pytorch=1.12.1=py3.8_cpu_0", False),
        ("pytorch, conda-forge", "python=3.8, cudatoolkit=11.7, pytorch", False),  # it needs the channel nvidia
        ("pytorch, conda-forge", "python=3.11, cudatoolkit, pytorch", False),
        ("pytorch, defaults", "python=3.11, pytorch-cuda=11.8, pytorch", False),
        ("conda-forge", "python=3.9, cudatoolkit=11.3, pytorch", False),
        ("pytorch, conda-forge", "python=3.8, cudatoolkit=11.3, cpuonly, pytorch", False),
        ("pytorch, conda-forge", "python=3.8, pytorch", False),
    ],
)
def test_pytorch_is_a_build_for_the_cuda_that_the_file_names(
    tree: Tree, channels: str, packages: str, *, limited: bool
) -> None:
    lines = "".join(f"  - {package}\n" for package in packages.split(", "))
    code = {"run.py": "import torch\n\ntorch.zeros(1).cuda()\n"}
    decision = tree({**code, "environment.yml": f"channels: [{channels}]\ndependencies:\n{lines}"})
    assert decision.kind == "cuda"
    assert ("pytorch=*=*cuda*" in decision.python.conda_limits) == limited
    assert any(each.answer == "pytorch=*=*cuda*" for each in decision.reasons) == limited
