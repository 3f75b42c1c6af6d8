"""Conda environments of any name, and what is told of those that are not made."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import decided, tree_of

Tree = Callable[[dict[str, str]], Decision]
FILE = "name: a\ndependencies:\n  - python=3.7\n  - pytorch=1.7\n  - pip:\n    - einops==0.3.0\n"
LIST = "# platform: linux-64\n_libgcc_mutex=0.1=main\npython=3.7.9=h7579374_0\nnumpy=1.19.2=py37h54aff64_0\n"
CODE = {"train.py": "import torch\n"}


def _page(command: str) -> str:
    return f"# Installation\n```\n{command}\n```\n"


@pytest.mark.parametrize(
    ("command", "path"),
    [
        ("conda env create -f requirement.yml", "requirement.yml"),
        ("mamba env update --file docker/conda/gpu.yaml", "docker/conda/gpu.yaml"),
        ("micromamba create -f lab.yml", "lab.yml"),
        ("conda env create --file=./lab.yml", "lab.yml"),
    ],
)
def test_a_file_of_any_name_that_a_page_gives_conda_is_the_environment(tree: Tree, command: str, path: str) -> None:
    python = tree({**CODE, path: FILE, "README.md": _page(command)}).python
    assert (python.conda_file, python.version, python.manager) == (path, "3.7", "conda")


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("lab.yml", FILE),
        ("sub_demo/toy.yaml", "channels: [conda-forge]\ndependencies:\n  - numpy\n"),
        ("toy.yml", "name: a\ndependencies:\n  - numpy\n  - pip:\n    - einops\n"),
    ],
)
def test_a_file_of_any_name_that_holds_what_an_environment_does_is_one(tree: Tree, path: str, text: str) -> None:
    assert tree({**CODE, path: text, "README.md": "# Lab\n"}).python.conda_file == path


def test_one_of_a_usual_name_comes_first(tree: Tree) -> None:
    other = FILE.replace("3.7", "3.8")
    assert tree({**CODE, "a.yml": FILE, "environment_gpu.yml": other}).python.conda_file == "environment_gpu.yml"


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("lab.yml", "name: a\ndependencies:\n  - numpy\n"),
        ("lab.yml", "name: a\ndependencies: {python: 3}\n"),
        ("lab.yml", "channels: [a]\nrefresh: 3\n"),
        ("lab.yml", f"services: {{a: {{image: b}}}}\n{FILE}"),
        ("Chart.yaml", f"apiVersion: v2\n{FILE}"),
        ("recipe/meta.yaml", f"package: {{name: a}}\nchannels: [c]\n{FILE}"),
        (".github/lab.yml", FILE),
        ("tests/lab.yml", FILE),
    ],
)
def test_yaml_of_other_programs_is_no_environment(tree: Tree, path: str, text: str) -> None:
    assert tree({**CODE, path: text, "README.md": "# Lab\n"}).python.conda_file is None


def test_a_list_of_conda_s_packages_is_the_environment_with_the_channels_of_the_page(tree: Tree) -> None:
    page = _page("conda create --name a --file spec.txt -c conda-forge")
    python = tree({**CODE, "spec.txt": f"{LIST}einops=0.3.0=pypi_0\n", "README.md": page}).python
    assert (python.conda_file, python.version, python.conda_channels) == ("spec.txt", "3.7", ("conda-forge",))
    assert python.conda_specs == ("_libgcc_mutex=0.1=main", "python=3.7.9=h7579374_0", "numpy=1.19.2=py37h54aff64_0")
    assert [each.text for each in python.pip] == ["einops==0.3.0"]


def test_an_old_pip_of_such_a_list_is_the_newest(tmp_path: Path) -> None:
    """Nothing of the file is changed: it is not in the image."""
    files = {**CODE, "spec.txt": f"{LIST}pip=19.3.1=py37_0\n", "README.md": _page("conda create -n a --file spec.txt")}
    tree_of(tmp_path, files)
    plan = plan_repository(tmp_path).plan
    assert plan.python.conda_old_pip
    text = dockerfile(plan)
    assert "numpy=1.19.2=py37h54aff64_0" in text
    assert "pip=19.3.1" not in text
    assert "/tmp/manifests/spec.txt" not in text


def test_a_list_of_files_is_installed_as_it_stands(tmp_path: Path) -> None:
    url = "https://conda.anaconda.org/conda-forge/linux-64/python-3.8.5-h1103e12_9_cpython.tar.bz2"
    files = {
        **CODE,
        "spec-file.txt": f"@EXPLICIT\n{url}\n",
        "README.md": _page("conda create -n a --file spec-file.txt"),
    }
    tree_of(tmp_path, files)
    plan = plan_repository(tmp_path).plan
    assert (plan.python.version, plan.python.conda_file) == ("3.8", "spec-file.txt")
    assert "--prefix /opt/conda --file /tmp/manifests/spec-file.txt" in dockerfile(plan)


@pytest.mark.parametrize(
    "command", ["conda install --file requirements.txt", "conda create -n a --file requirements.txt"]
)
def test_a_list_that_pip_reads_as_well_stays_pip_s(tree: Tree, command: str) -> None:
    python = tree({**CODE, "requirements.txt": "torch==1.7.1\nscipy\n", "README.md": _page(command)}).python
    assert (python.conda_file, python.requirements) == (None, ("requirements.txt",))


@pytest.mark.parametrize(
    ("files", "why"),
    [
        ({"requirements.txt": "torch==1.7.1\n"}, "requirements.txt is installed in its place"),
        ({"other.yml": FILE, "README.md": _page("conda env create -f other.yml\nconda env update -f environment.yml")},
         "an image has one environment, here that of other.yml"),
        ({"package.xml": "<package format='2'><name>a</name></package>", "CMakeLists.txt": "find_package(catkin)\n"},
         "what is compiled here is for the Python of the Ubuntu"),
    ],
)  # fmt: skip
def test_an_environment_that_is_not_made_is_told_with_the_reason(tree: Tree, files: dict[str, str], why: str) -> None:
    told = [each for each in tree({**CODE, "environment.yml": FILE, **files}).warnings if "is not made" in each.message]
    assert [(each.file, each.line) for each in told] == [("environment.yml", 1)]
    assert told[0].message == f"environment.yml is not made: {why}; `conda: environment.yml` in roslab.yaml makes it"


def test_an_environment_for_another_system_is_neither_taken_nor_told(tree: Tree) -> None:
    page = _page("conda env create -f environment_mac.yml\nconda env create -f environment_linux.yml")
    decision = tree({**CODE, "environment_mac.yml": FILE, "environment_linux.yml": FILE, "README.md": page})
    assert decision.python.conda_file == "environment_linux.yml"
    assert not any("is not made" in each.message for each in decision.warnings)


@pytest.mark.parametrize(("torch", "limited"), [("1.10.0", True), ("2.3.0", False)])
@pytest.mark.parametrize("numpy", ["", "- numpy=1.24.3\n"])
def test_what_conda_installed_before_numpy_2_keeps_it_out_of_what_pip_adds(
    tree: Tree, torch: str, limited: bool, numpy: str
) -> None:
    environment = f"channels:\n- pytorch\ndependencies:\n- python=3.9\n- pytorch={torch}\n{numpy}"
    python = tree({"environment.yml": environment, "run.py": "import torch\n"}).python
    assert ("numpy<2" in [bound.written for bound in python.bounds]) is limited


@pytest.mark.parametrize(
    ("channels", "torch", "limited"),
    [
        ("[pytorch]", "pytorch=1.10.0", True),
        ("[conda-forge]", "pytorch==2.2.1=py310_0", True),
        ("[nvidia, pytorch, conda-forge]", "pytorch", True),
        ("[conda-forge, 'https://conda.anaconda.org/pytorch']", "pytorch>=1.8", False),
        ("[conda-forge]", "pytorch::pytorch", True),
        ("[pytorch]", "pytorch=2.5.1", True),
        ("[conda-forge]", "pytorch=2.4.0", False),
        ("[pytorch, conda-forge]", "pytorch>=2.6", False),
        ("[pytorch]", "pytorch=1.10.0\n- mkl=2024.2", False),
        ("[pytorch]", "numpy=1.20", False),
    ],
)
def test_a_torch_of_conda_from_before_mkl_2024_1_keeps_it_out(
    tmp_path: Path, channels: str, torch: str, limited: bool
) -> None:
    files = {"environment.yml": f"channels: {channels}\ndependencies:\n- python=3.9\n- {torch}\n", **CODE}
    tree_of(tmp_path, files)
    plan = plan_repository(tmp_path).plan
    assert plan.python.conda_limits == (*(("mkl<2024.1",) if limited else ()), "setuptools<82")
    assert ("MAMBA_PINNED_PACKAGES='mkl<2024.1,setuptools<82' " in dockerfile(plan)) is limited


@pytest.mark.parametrize(
    ("packages", "limits"),
    [
        (["python=3.9"], ("setuptools<82",)),
        (["python"], ()),
        (["python=3.9", "setuptools=65"], ()),
        (["python=3.9", "setuptools"], ("setuptools<82",)),
    ],
)
def test_an_environment_keeps_pkg_resources(tmp_path: Path, packages: list[str], limits: tuple[str, ...]) -> None:
    listed = "".join(f"- {package}\n" for package in packages)
    (tmp_path / "environment.yml").write_text(f"channels: [conda-forge]\ndependencies:\n{listed}")
    (tmp_path / "train.py").write_text("import json\n")
    assert plan_repository(tmp_path).plan.python.conda_limits == limits


def test_condas_name_of_opencvs_module_is_what_the_code_imports(tree: Tree) -> None:
    file = "name: a\ndependencies:\n  - python=3.9\n  - py-opencv=4.6.0\n"
    python = tree({"train.py": "import cv2\n", "environment.yml": file}).python
    assert not [each for each in python.pip_guessed if each.key == "opencv-python"]


EXPORT = (
    f"# This file may be used to create an environment using:\n# $ conda create --name <env> --file <this file>\n{LIST}"
)


@pytest.mark.parametrize("path", ["requirements.txt", "setup/spec.txt"])
def test_a_list_that_says_that_conda_wrote_it_is_the_environment(tree: Tree, path: str) -> None:
    python = tree({**CODE, path: f"{EXPORT}einops=0.3.0=pypi_0\n", "README.md": _page(f"pip install -r {path}")}).python
    assert (python.conda_file, python.version, python.requirements) == (path, "3.7", ())
    assert [each.text for each in python.pip] == ["einops==0.3.0"]


def test_a_list_that_conda_wrote_on_another_system_is_none(tree: Tree) -> None:
    text = f"{EXPORT}einops=0.3.0=pypi_0\n".replace("linux-64", "win-64")
    python = tree({**CODE, "requirements.txt": text}).python
    assert python.conda_file is None
    assert [each.text for each in python.pip] == ["einops==0.3.0"]


def test_pip_gets_of_conda_s_list_what_it_had_installed_where_no_environment_is_made(tree: Tree) -> None:
    package = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    cmake = "find_package(catkin REQUIRED)\ncatkin_package()\n"
    text = f"{EXPORT}bzip2=1.0.8=h7b6447c_0\neinops=0.3.0=pypi_0\n"
    decision = tree({"ws/node/package.xml": package, "ws/node/CMakeLists.txt": cmake, "ws/node/requirements.txt": text})
    assert [each.text for each in decision.python.pip if each.file.endswith(".txt")] == ["einops==0.3.0"]
    assert [each.text for each in decision.python.pip_tried] == ["einops==0.3.0"]


REFUSED = "dependencies:\n  - python=3.8\n  - numpy\n  - pip:\n    - pytorch3d\n    - dataclasses==0.8\n    - click\n"


def test_what_pip_cannot_install_is_taken_out_of_a_conda_file(tree: Tree) -> None:
    found = tree({"environment.yml": REFUSED, "main.py": "import numpy, click\n"})
    assert found.python.conda_local == ("pytorch3d", "dataclasses")
    assert found.python.conda_pip
    assert [each.url for each in found.python.pip_guessed] == ["git+https://github.com/facebookresearch/pytorch3d"]
    told = " ".join(each.message for each in found.warnings)
    assert "pip cannot install pytorch3d" in told
    assert "newer have it themselves, and the image has 3.8" in told


@pytest.mark.parametrize(
    ("packages", "page", "limits"),
    [
        (["numpy", "pip", {"pip": "torch==1.10.0"}], "", ("python=3.8", "setuptools<82")),
        (["python", "numpy", {"pip": "torch==1.10.0"}], "", ("python=3.8", "setuptools<82")),
        (["numpy"], "It needs Python 3.9.\n", ("python=3.9", "setuptools<82")),
        (["numpy"], "", ()),
        (["numpy=1.19.2=py37h54aff64_0", {"pip": "torch==1.10.0"}], "It needs Python 3.9.\n", ()),
        (["python=3.9", {"pip": "torch==1.10.0"}], "", ("setuptools<82",)),
    ],
)
def test_an_environment_without_a_python_gets_the_one_that_the_rest_asks_for(
    tmp_path: Path, packages: list[str | dict[str, str]], page: str, limits: tuple[str, ...]
) -> None:
    listed = "".join(f"- {each}\n" if isinstance(each, str) else f"- pip:\n  - {each['pip']}\n" for each in packages)
    files = {
        "lab.yml": f"name: a\nchannels: [conda-forge]\ndependencies:\n{listed}",
        "README.md": f"# Lab\n\n{page}\n```\nconda env create --file lab.yml\n```\n",
        "train.py": "import numpy\n",
    }
    tree_of(tmp_path, files)
    assert plan_repository(tmp_path).plan.python.conda_limits == limits


def test_an_environment_without_a_python_gets_that_of_its_day(tmp_path: Path) -> None:
    files = {"environment.yml": "dependencies:\n- numpy\n- pip:\n  - einops\n"}
    found = decided(tmp_path, files, config=Config(pip_date="2020-06-01")).python
    assert found.conda_limits[:1] == (f"python={found.version}",)
    assert found.version == "3.7"


@pytest.mark.parametrize(
    ("between", "guessed"),
    [
        ("conda activate a\n", ["scipy==1.8.0", "evo==1.18.0"]),
        ("conda activate a\npip install --upgrade evo\n", ["scipy==1.8.0", "evo==1.18.0"]),
        ("conda activate a\n# what is left\n", ["scipy==1.8.0", "evo==1.18.0"]),
        ("conda activate a\n```\n\nOr without conda:\n```\n", ["scipy==1.8.0"]),
    ],
)
def test_the_list_that_a_page_has_pip_install_into_the_environment(
    tree: Tree, between: str, guessed: list[str]
) -> None:
    page = _page(f"conda env create -f lab.yml\n{between}pip install -r requirements.txt")
    files = {"lab.yml": FILE, "requirements.txt": "einops==0.4\nscipy==1.8.0\nevo==1.18.0\n", "README.md": page}
    python = tree({"train.py": "import torch\nimport scipy\n", **files}).python
    assert python.conda_file == "lab.yml"
    named = [str(each.written) for each in python.pip_guessed if each.name in {"einops", "scipy", "evo"}]
    assert sorted(named, reverse=True) == guessed
