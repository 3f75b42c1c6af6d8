"""Extensions of torch without a CUDA that anybody names, and a free torch whose day knew no CUDA of the image's."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
PAGE = "Python 3.8\n\nFirst, install [MinkowskiEngine](https://github.com/NVIDIA/MinkowskiEngine).\n"
NET = "import MinkowskiEngine as ME\nimport torch\n\nME.SparseTensor(torch.zeros(1))\n"
FREE = {"train.py": "import torch\ntorch.zeros(1).cuda()\n", "requirements.txt": "torch\n"}


def of_day(tmp_path: Path, files: dict[str, str], day: str) -> Decision:
    for path, text in files.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    return decide(gather(Repository.open(tmp_path)), Config(pip_date=day), folder_name="demo")


def test_torch_is_that_of_the_compiler_of_the_image(tree: Tree) -> None:
    decision = tree({"README.md": PAGE, "net.py": NET})
    assert decision.cuda == "11.8"
    assert decision.base_image.startswith("nvidia/cuda:11.8")
    assert [each.written for each in decision.python.bounds if each.key == "torch"] == ["torch==2.4.*"]
    assert decision.python.options == ("--extra-index-url https://download.pytorch.org/whl/cu118",)


def test_it_is_of_the_wheels_of_an_old_day(tmp_path: Path) -> None:
    decision = of_day(tmp_path, {"README.md": PAGE, "net.py": NET}, "2022-07-10")
    assert decision.cuda == "11.6"
    assert [each.written for each in decision.python.bounds if each.key == "torch"] == ["torch==1.12.*"]


@pytest.mark.parametrize(
    ("day", "cuda", "index", "said"),
    [
        ("2022-07-10", "11.6", "cu116", "of 2022-07-10 for Python 3.8 is torch 1.12 with CUDA 11.6"),
        ("2023-06-01", "11.7", None, "is torch 2.0 with CUDA 11.7"),
        ("2020-09-01", "11.0", None, "is torch 1.6 with CUDA 10.2, of which no image exists: it brings its own"),
    ],
)
def test_the_image_has_the_cuda_of_a_free_torch_of_its_day(
    tmp_path: Path, day: str, cuda: str, index: str | None, said: str
) -> None:
    decision = of_day(tmp_path, {**FREE, "README.md": "Python 3.8\n"}, day)
    assert decision.cuda == cuda
    assert decision.base_image.startswith(f"nvidia/cuda:{cuda}.")
    options = (f"--extra-index-url https://download.pytorch.org/whl/{index}",) if index else ()
    assert decision.python.options == options
    assert any(said in each.reason for each in decision.reasons if each.question == "cuda")
    assert not decision.warnings


IMPORTED = {"train.py": "import torch\nif __name__ == '__main__':\n    print(torch)\n"}


@pytest.mark.parametrize(
    ("more", "day", "image"),
    [
        ({}, "2024-12-31", "nvidia/cuda:12.4.1-base"),
        ({}, "2021-05-04", "nvidia/cuda:11.8.0-base"),
        ({"README.md": "CUDA 12.1\n"}, "2024-12-31", "nvidia/cuda:12.1.1-base"),
    ],
)
def test_an_image_for_the_wheel_of_a_torch_that_is_only_imported(
    tmp_path: Path, more: dict[str, str], day: str, image: str
) -> None:
    assert of_day(tmp_path, {**IMPORTED, **more}, day).base_image.startswith(image)


@pytest.mark.parametrize(
    ("setup", "cmake", "image"),
    [
        ("ext_modules=[CMakeExtension('a')]", "project(a CXX)\nfind_package(Eigen3 REQUIRED)\n", "base"),
        ("ext_modules=[CMakeExtension('a')]", "project(a CXX)\nfind_package(Torch REQUIRED)\n", "devel"),
        ("ext_modules=[CMakeExtension('a')]", "project(a CXX)\nfind_package(CUDAToolkit)\n", "devel"),
        ("ext_modules=[CMakeExtension('a')]", "project(a CXX CUDA)\n", "devel"),
        ("ext_modules=[CMakeExtension('a')]", "project(a CXX)\nenable_language(CUDA)\n", "devel"),
        ("ext_modules=[CMakeExtension('a')]", None, "devel"),
        ("ext_modules=[Extension('a', ['a.cpp'])]", None, "base"),
        ("ext_modules=cythonize('a.pyx')", None, "base"),
        ("ext_modules=[CUDAExtension('a', ['a.cpp'])]", None, "devel"),
        ("ext_modules=[Extension('a', ['a.cpp'], include_dirs=torch.include())]", None, "devel"),
    ],
)
def test_the_compiler_of_cuda_for_an_extension_that_needs_it(
    tree: Tree, setup: str, cmake: str | None, image: str
) -> None:
    imported = "import torch\n" if "torch." in setup else ""
    text = f"{imported}from setuptools import setup\nsetup(name='a', install_requires=['torch==2.1.0'], {setup})\n"
    decision = tree({"setup.py": text, "CMakeLists.txt": cmake} if cmake else {"setup.py": text})
    assert decision.kind == "cuda"
    assert f"-{image}-" in (decision.base_image or "")
