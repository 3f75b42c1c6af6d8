"""setup.py, setup.cfg and pyproject.toml."""

from __future__ import annotations

from pathlib import Path

from roslab.evidence.python import project as python_project
from roslab.evidence.python_project import PythonProject
from roslab.repository.checkout import Repository


def read(tmp_path: Path, files: dict[str, str]) -> dict[str, PythonProject]:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return {project.folder: project for project in python_project.read(Repository.open(tmp_path))}


def names(project: PythonProject, role: str = "") -> list[str]:
    return [asked.written for asked in project.requirements if asked.role == role]


def test_setup_py_follows_names_and_sums(tmp_path: Path) -> None:
    text = """
from setuptools import setup, find_packages
CORE = ["numpy>=1.2", 'scipy']
DEPS = CORE + ["six"]
DEPS += ["yaml"]
DEPS.append("tqdm")
setup(name="thing", install_requires=DEPS, extras_require={"sim": ["pybullet"]}, python_requires=">=3.6",
      classifiers=["Programming Language :: Python :: 3.7"], entry_points={"console_scripts": ["run-it = thing:main"]})
"""
    project = read(tmp_path, {"setup.py": text})[""]
    assert (project.name, project.installable, project.requires_python) == ("thing", True, ">=3.6")
    assert names(project) == ["numpy>=1.2", "scipy", "six", "yaml", "tqdm"]
    assert names(project, "extra") == ["pybullet"]
    assert project.scripts == (("run-it", 8),)
    assert project.requirements[0].line == 3


def test_setup_py_that_reads_its_requirements(tmp_path: Path) -> None:
    text = """
from setuptools import setup
def load(path):
    with open(path) as f:
        return f.read().splitlines()
requirements = load("requirements.txt")
setup(name="x", install_requires=[r for r in requirements if r])
"""
    project = read(
        tmp_path, {"setup.py": text, "requirements.txt": "torch==1.7.1\n-r more.txt\n", "more.txt": "six\n"}
    )[""]
    assert names(project) == ["torch==1.7.1", "six"]
    assert project.requirements[0].file == "requirements.txt"


def test_nothing_of_a_setup_py_is_run(tmp_path: Path) -> None:
    text = f"open({str(tmp_path / 'ran')!r}, 'w')\nfrom setuptools import setup\nsetup(name='x')\n"
    assert read(tmp_path, {"setup.py": text})[""].name == "x"
    assert not (tmp_path / "ran").exists()


def test_python_2_is_read_by_pattern(tmp_path: Path) -> None:
    text = "print 'hello'\nfrom setuptools import setup\nsetup(name='old', install_requires=['numpy==1.1', \"yaml\"])\n"
    project = read(tmp_path, {"setup.py": text})[""]
    assert (project.name, names(project)) == ("old", ["numpy==1.1", "yaml"])


def test_catkin_and_ament_scripts_are_not_for_pip(tmp_path: Path) -> None:
    catkin = (
        "from distutils.core import setup\nfrom catkin_pkg.python_setup import generate_distutils_setup\nsetup(**d)\n"
    )
    ament = "import setuptools\nsetuptools.setup(name='b', data_files=[('share/ament_index/resource_index', [])])\n"
    found = read(
        tmp_path,
        {
            "a/setup.py": catkin,
            "b/setup.py": ament,
            "b/package.xml": "<package/>",
            "b/pyproject.toml": "[project]\nname='b'\n",
        },
    )
    assert [project.installable for project in found.values()] == [False, False]


def test_pyproject_of_both_kinds(tmp_path: Path) -> None:
    modern = (
        '[project]\nname = "a"\nrequires-python = ">=3.8"\ndependencies = ["numpy"]\n[project.scripts]\ngo = "a:b"\n'
    )
    poetry = """
[tool.poetry]
name = "p"
[tool.poetry.dependencies]
python = "^3.8"
numpy = "^1.19.2"
torch = {version = "1.7.1", optional = true}
clip = {git = "https://github.com/openai/CLIP.git", rev = "main"}
six = "*"
[build-system]
build-backend = "poetry.core.masonry.api"
"""
    tools = "[tool.black]\nline-length = 100\n"
    found = read(tmp_path, {"a/pyproject.toml": modern, "p/pyproject.toml": poetry, "t/pyproject.toml": tools})
    assert (found["a"].installable, names(found["a"]), found["a"].scripts) == (True, ["numpy"], (("go", 6),))
    assert found["p"].requires_python == ">=3.8,<4"
    assert names(found["p"]) == ["numpy>=1.19.2,<2", "clip @ git+https://github.com/openai/CLIP.git@main", "six"]
    assert not found["t"].installable


def test_setup_cfg(tmp_path: Path) -> None:
    text = "[metadata]\nname = c\n[options]\npython_requires = >=3.6\ninstall_requires =\n  numpy\n  scipy>1\n"
    project = read(tmp_path, {"setup.cfg": text})[""]
    assert (project.name, project.installable, names(project)) == ("c", True, ["numpy", "scipy>1"])


def test_what_is_compiled(tmp_path: Path) -> None:
    text = "from torch.utils.cpp_extension import CUDAExtension\nfrom setuptools import setup\nsetup(name='e')\n"
    assert "cuda" in read(tmp_path, {"setup.py": text})[""].extensions


def test_broken_files_end_in_nothing(tmp_path: Path) -> None:
    files = {
        "a/pyproject.toml": "[project\n",
        "b/setup.cfg": "no section\n",
        "c/setup.py": "setup(" + "(" * 5000,
        "d/pyproject.toml": "a = " + "[" * 5000,
    }
    assert all(not p.requirements for p in read(tmp_path, files).values())
