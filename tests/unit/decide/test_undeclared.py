"""Old releases that need a limit which they do not declare."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.undeclared import decide_undeclared
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("lines", "bounds"),
    [
        (["torchvision==0.4.0"], ["pillow<7"]),
        (["torchvision<0.5"], ["pillow<7"]),
        (["torchvision<=0.5"], []),
        (["torchvision==0.5.0"], []),
        (["torchvision"], []),
        (["torchvision==0.4.0", "Pillow==8.1.0"], []),
        (["torchvision==0.4.0", "Pillow>=7.1"], []),
        (["torchvision==0.4.0", "Pillow>=6"], ["pillow<7"]),
        (["tensorboardX==2.0", "tensorboard==2.2.0"], ["protobuf<3.21"]),
        (["flask==1.0.2"], ["itsdangerous<2.1", "jinja2<3.1", "werkzeug<2.1"]),
        (["hdbscan==0.8.28"], ["Cython<3"]),
        (["hdbscan==0.8.28", "Cython>=3"], []),
        (["hdbscan"], []),
        (["flask @ https://example.org/flask-1.0.2.zip"], []),
        (["trimesh<=3.7.12"], ["numpy<1.24"]),
        (["trimesh<=3.7.12", "numpy<2"], ["numpy<1.24"]),
        (["trimesh<=3.7.12", "numpy<1.20"], []),
        (["trimesh==3.9.4"], []),
    ],
)
def test_a_release_that_does_not_say_what_it_needs(lines: list[str], bounds: list[str]) -> None:
    assert [each.written for each in decide_undeclared(map(stated, lines)).answer.pip] == bounds


@pytest.mark.parametrize(
    ("lines", "day", "python", "bounds"),
    [
        (["pandas==2.0.3"], None, "3.10", ["numpy<2"]),
        (["pandas==2.2.2"], None, "3.10", []),
        (["pandas"], None, "3.10", []),
        (["faiss-cpu==1.8.0"], None, "3.10", ["numpy<2"]),
        (["faiss-cpu==1.9.0"], None, "3.10", []),
        (["faiss-cpu"], None, "3.10", []),
        (["pandas==1.3.0"], None, "3.8", []),
        (["pandas==2.1.0"], None, "3.13", []),
        (["pandas==2.1.0"], None, "3.12.4", ["numpy<2"]),
        (["trimesh==3.7.12"], None, "3.8", ["numpy<1.24"]),
        (["trimesh==3.7.12"], None, "3.11", ["numpy<1.24"]),
        (["trimesh==3.7.12"], None, "3.12", []),  # no such NumPy has a wheel for it, and none compiles there
        (["networkx==2.4"], None, "3.7", []),
        (["networkx==2.4"], None, "2.7", []),
        (["pandas==2.0.3", "numpy==1.24.0"], None, "3.10", []),
        (["pandas==2.0.3", "opencv-python==4.12.0.88"], None, "3.10", []),
        (["gym"], None, "3.10", ["numpy<2"]),
        (["gym==0.21.0"], None, "3.10", ["numpy<2"]),
        (["gym", "numpy>=2"], None, "3.10", []),
        (["gtsam"], None, "3.10", []),
        (["gtsam"], "2024-09-01", "3.10", ["numpy<2"]),
        (["gtsam>=4.2"], "2024-09-01", "3.10", ["numpy<2"]),
        (["gtsam"], "2026-05-01", "3.10", []),
        (["pandas"], "2024-09-01", "3.10", []),
        (["open3d"], "2024-09-01", "3.10", ["numpy<2"]),
        (["open3d==0.19.0"], "2024-09-01", "3.10", []),
    ],
)
def test_what_was_compiled_for_numpy_1(lines: list[str], day: str | None, python: str, bounds: list[str]) -> None:
    found = decide_undeclared(map(stated, lines), day=day, python=python)
    assert [each.written for each in found.answer.pip] == bounds


def test_the_bound_holds_for_what_the_repository_does_not_name(tree: Tree) -> None:
    files = {"requirements.txt": "numpy\ntensorboardX==2.0\n", "main.py": "import tensorboardX\n"}
    assert "protobuf<3.21" in [each.written for each in tree(files).python.bounds]


def test_sources_older_than_cython_3_are_built_with_an_older_one(tree: Tree) -> None:
    python = tree({"requirements.txt": "numpy\nhdbscan==0.8.28\n", "main.py": "import hdbscan\n"}).python
    assert "Cython<3" in [each.written for each in python.bounds]
    assert {each.written for each in python.first} == {"numpy", "Cython<3"}


def test_what_only_the_list_of_a_package_from_git_names_is_there(tree: Tree) -> None:
    pip = "dependencies:\n  - python=3.7\n  - pip:\n    - git+https://github.com/mit-han-lab/torchsparse.git\n"
    assert "backports.cached_property" in [each.name for each in tree({"environment.yaml": pip}).python.first]


@pytest.mark.parametrize(
    ("lines", "conda", "pip"),
    [
        (["diffusers=0.11.1"], ["huggingface_hub<0.26"], ["huggingface-hub<0.26"]),
        (["conda-forge::diffusers=0.11.1", "huggingface_hub"], ["huggingface_hub<0.26"], ["huggingface-hub<0.26"]),
        (["diffusers=0.11.1", "huggingface_hub=0.16"], [], []),
        (["diffusers=0.11.1", "huggingface_hub>=0.26"], [], []),
        (["pip", {"diffusers": "0.11.1"}], ["huggingface_hub<0.26"], ["huggingface-hub<0.26"]),
        (["flask=1.1"], ["itsdangerous<2.1", "jinja2<3.1", "werkzeug<2.1"], None),
        (["flask=2"], [], []),
        (["diffusers"], [], []),
    ],
)
def test_conda_takes_no_newer_one_either(
    tree: Tree, lines: list[str | dict[str, str]], conda: list[str], pip: list[str] | None
) -> None:
    listed = "".join(f"  - {each}\n" for each in lines if isinstance(each, str))
    by_pip = "".join(f"    - {name}=={of}\n" for each in lines if isinstance(each, dict) for name, of in each.items())
    listed += f"  - pip:\n{by_pip}" if by_pip else ""
    files = {"environment.yml": f"name: a\ndependencies:\n  - python=3.9\n{listed}", "main.py": "import numpy\n"}
    python = tree({**files, "README.md": "```\nconda env create -f environment.yml\npython main.py\n```\n"}).python
    assert python.manager == "conda"
    assert [each for each in python.conda_limits if not each.startswith("setuptools")] == conda
    bounds = [each.written for each in python.bounds]
    assert bounds == (conda if pip is None else pip)


def test_what_conda_installs_is_told_with_its_place(tree: Tree) -> None:
    text = "name: a\ndependencies:\n  - python=3.9\n  - diffusers=0.11.1\n"
    found = tree(
        {"environment.yml": text, "README.md": "`conda env create -f environment.yml`\n", "a.py": "import os\n"}
    )
    (why,) = [each for each in found.reasons if each.answer == "huggingface-hub<0.26"]
    assert why.file == "environment.yml"


def test_what_no_python_after_one_has(tree: Tree) -> None:
    """Isaac Gym is on no index, and is compiled for no Python after 3.8."""
    setup = "from setuptools import setup\nsetup(name='a', packages=['a'], install_requires=['{}'])\n"
    asked = {
        name: tree({"setup.py": setup.format(name), "a/__init__.py": ""}) for name in ("isaacgym==1.0rc4", "torch")
    }
    assert [found.python and found.python.version for found in asked.values()] == ["3.8", "3.10"]


@pytest.mark.parametrize(
    ("python", "file", "lines", "bounds"),
    [
        ("3.8", "play.py", "scipy", True),
        ("3.8", "tests/play.py", "scipy", False),
        ("3.8", "play.py", "numpy==1.24.4", False),
        ("3.10", "play.py", "scipy", False),  # it does not run there
    ],
)
def test_what_the_reader_adds_to_the_image_needs_an_older_numpy(
    tree: Tree, python: str, file: str, lines: str, *, bounds: bool
) -> None:
    """Isaac Gym uses np.float when it is imported, and NumPy 1.24 is the newest that Python 3.8 has."""
    found = tree(
        {
            "requirements.txt": f"{lines}\n",
            ".python-version": f"{python}\n",
            "run.py": "import scipy\n",
            file: "import isaacgym\nimport scipy\n",
        }
    )
    assert found.python.version == python
    assert ("numpy<1.24" in [each.written for each in found.python.bounds]) == bounds
