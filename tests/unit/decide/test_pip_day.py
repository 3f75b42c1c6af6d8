"""The day of pip's packages: that of an old last commit, or the one that ``pip_date`` names."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roslab.errors import ConfigurationError
from roslab.knowledge.days import long_ago, usual
from roslab.knowledge.frameworks import newest_framework
from roslab.knowledge.tools import for_old_packages, python_tools
from roslab.pipeline import Planned, plan_repository
from roslab.plan.lock import use
from roslab.plan.locked import Lock
from roslab.render.dockerfile import dockerfile
from roslab.render.report import inspection_text
from trees import commit, tree_of

PYTHON = {"main.py": "import numpy\n\nprint(numpy.zeros(3))\n", "requirements.txt": "numpy\nscipy\n"}
TORCH = {"main.py": "import torch\n", "requirements.txt": "torch\n"}


def committed(folder: Path, files: dict[str, str], day: str, config: str = "") -> Planned:
    """Plan a repository of one commit of a day."""
    said = {"roslab.yaml": f"format: 3\n{config}"} if config else {}
    tree_of(folder, {**files, **said})
    commit(folder, day)
    return plan_repository(folder)


def test_an_old_repository_gets_packages_and_a_python_of_its_time(tmp_path: Path) -> None:
    planned = committed(tmp_path, PYTHON, "2019-03-01")
    assert planned.plan.python.day == "2019-03-01"
    assert planned.plan.base_image == "ubuntu:18.04"
    text = dockerfile(planned.plan)
    assert text.count('eval "$(index-as-of 2019-03-01 --or-today)"') == 2, "what builds, and the packages"
    assert "take-snapshots" not in text
    assert "git-as-of /usr/local/bin" not in text
    shown = inspection_text(planned.decision, planned.plan)
    assert "what pip installs without a version is of 2019-03-01: the last commit is old" in shown


def test_a_repository_that_is_worked_on_is_not_touched(tmp_path: Path) -> None:
    planned = committed(tmp_path, PYTHON, long_ago())
    assert planned.plan.python.day is None
    assert "$(index-as-of" not in dockerfile(planned.plan)
    assert not [reason for reason in planned.decision.reasons if reason.question == "pip_date"]


@pytest.mark.parametrize(("said", "day"), [("today", None), ("2018-06-01", "2018-06-01"), ("paper", "2019-03-01")])
def test_roslab_yaml_decides(tmp_path: Path, said: str, day: str | None) -> None:
    planned = committed(tmp_path, PYTHON, "2019-03-01", f"pip_date: {said}\n")
    assert planned.plan.python.day == day


def test_a_day_can_be_named_for_a_new_commit(tmp_path: Path) -> None:
    assert committed(tmp_path, PYTHON, long_ago(), "pip_date: 2018-06-01\n").plan.python.day == "2018-06-01"


def test_one_day_for_all_and_another_for_pip_contradict_each_other(tmp_path: Path) -> None:
    with pytest.raises(ConfigurationError, match="`date` is the day of pip's packages too"):
        committed(tmp_path, PYTHON, "2019-03-01", "date: paper\npip_date: today\n")


def test_a_python_that_is_named_stays(tmp_path: Path) -> None:
    page = {"README.md": "# Planner\n\nNeeds Python 3.9.\n"}
    planned = committed(tmp_path, PYTHON | page, "2021-01-10")
    assert planned.plan.python.version == "3.9"


def test_clones_of_pip_are_of_the_day(tmp_path: Path) -> None:
    lines = {"requirements.txt": "numpy\ngit+https://github.com/example/solver.git\n"}
    assert "COPY --from=scripts /git-as-of /usr/local/bin/" in dockerfile(
        committed(tmp_path, PYTHON | lines, "2021-01-10").plan
    )


def test_a_lock_needs_no_day(tmp_path: Path) -> None:
    plan = committed(tmp_path, PYTHON, "2021-01-10").plan
    lock = Lock(base=plan.base_image, digest="", python="venv 3.8", rosdistro=None, tools=(), sources=(), machines=())
    assert plan.python.day
    assert use(plan, lock).python.day is None


def test_what_is_compiled_for_torch_gets_the_cuda_of_its_day(tmp_path: Path) -> None:
    kernel = {"kernel.cu": "__global__ void k() {}\n"}
    setup = {"setup.py": "from torch.utils.cpp_extension import CUDAExtension\nfrom setuptools import setup\n"}
    setup["setup.py"] += (
        "setup(name='x', ext_modules=[CUDAExtension('x', ['kernel.cu'])], install_requires=['torch'])\n"
    )
    (tmp_path / "old").mkdir()
    plan = committed(tmp_path / "old", kernel | setup, "2022-12-01").plan
    assert "cuda:11.7" in plan.base_image
    assert plan.python.bounds == ("torch==1.13.*", "numpy<2")
    (tmp_path / "free").mkdir()
    assert "cuda:11.7" in committed(tmp_path / "free", TORCH, "2022-12-01").plan.base_image, "that of the wheel"


def test_ros_installs_its_pip_packages_of_the_day(tmp_path: Path) -> None:
    package = (
        '<package format="2"><name>robot</name><version>1.0.0</version><description>x</description>'
        '<maintainer email="a@example.org">a</maintainer><license>MIT</license>'
        "<buildtool_depend>catkin</buildtool_depend><depend>rospy</depend></package>"
    )
    cmake = "cmake_minimum_required(VERSION 3.0)\nproject(robot)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
    ros = {"package.xml": package, "CMakeLists.txt": cmake}
    (tmp_path / "plain").mkdir()
    text = dockerfile(committed(tmp_path / "plain", ros, "2021-01-10").plan)
    assert "index-as-of" not in text, "rosdep's keys alone"
    lines = {"requirements.txt": "transforms3d\n"}
    text = dockerfile(committed(tmp_path, ros | lines, "2021-01-10", "base: {ros: noetic}\n").plan)
    own, *dated = text.split('eval "$(index-as-of 2021-01-10 --or-today)"')
    assert "'pip<24.1; python_version < \"3.9\"'" in own
    assert ["'setuptools" in part for part in (own, *dated)] == [False, True, False], "what old sources build with"
    by_pip = package.replace("</package>", "<exec_depend>python3-networkx-pip</exec_depend></package>")
    text = dockerfile(
        committed(tmp_path, {**ros, **lines, "package.xml": by_pip}, "2021-01-10", "base: {ros: noetic}\n").plan
    )
    assert '--or-today)" \\\n && install-rosdep-keys' in text, "a key that rosdep gives to pip"


def test_pythons_that_had_wheels() -> None:
    assert [python for python in ("2.7", "3.6", "3.7", "3.8") if usual(python, "2019-10-01")] == ["3.6", "3.7"]


def test_the_newest_framework_of_a_day() -> None:
    newest = newest_framework("torch", "2021-04-01")
    assert newest is not None
    assert newest.first == "1.8"
    assert newest_framework("torch", "2016-01-01") is None


def test_pip_reads_the_metadata_of_old_packages() -> None:
    assert for_old_packages(python_tools("3.12", None)).installers == ("pip<24.1", "setuptools<82", "wheel")
    old = for_old_packages(python_tools("3.6", None))
    assert old.installers[:2] == ('pip<22; python_version < "3.7"', 'pip<24.1; python_version >= "3.7"')
    assert replace(old, installers=()) == replace(python_tools("3.6", None), installers=())


@pytest.mark.parametrize(
    ("page", "day", "old"),
    [
        ("pip install scipy", "2024-01-10", True),
        ("pip install scipy", "2024-09-10", False),
        ("pip install scipy==1.4.1", "2024-09-10", True),
    ],
)
def test_what_is_installed_by_name_after_pip_became_strict_needs_no_older_pip(
    tmp_path: Path, page: str, day: str, old: bool
) -> None:
    files = {"main.py": "import scipy\n", "README.md": f"```\n{page}\npython main.py\n```\n"}
    planned = committed(tmp_path, files, day, f"pip_date: {day}\n")
    assert planned.plan.python.day == day
    assert any(line.startswith("pip<24.1") for line in planned.plan.python_tools.installers) is old


@pytest.mark.parametrize("said", ["Python 3.6 or newer", "Python 3.6+", "Python >= 3.6", "Python 3.6 or above"])
def test_the_oldest_python_that_works_is_not_the_one_that_is_meant(tmp_path: Path, said: str) -> None:
    planned = committed(tmp_path, PYTHON | {"README.md": f"# Planner\n\nNeeds {said}.\n"}, "2022-01-10")
    assert planned.plan.python.version == "3.8"
    assert "python=3.8" not in dockerfile(planned.plan), "the Ubuntu's own"


def test_the_pip_of_conda_reads_old_metadata_too(tmp_path: Path) -> None:
    planned = committed(tmp_path, PYTHON | {"README.md": "Needs Python 3.7.\n", "k.cu": "int x;\n"}, "2021-01-10")
    assert planned.plan.python.manager == "conda"
    assert "python=3.7 'pip<24.1'" in dockerfile(planned.plan)


@pytest.mark.parametrize(
    ("day", "code", "python"),
    [
        ("2024-05-01", "print(1)\n", "3.10"),
        ("2018-05-01", "print(1)\n", "2.7"),
        ("2024-05-01", "print 'a'\n", "2.7"),
    ],
)
def test_classifiers_of_an_ended_python_are_the_oldest_that_works(
    tmp_path: Path, day: str, code: str, python: str
) -> None:
    setup = "from setuptools import setup\nsetup(name='a', classifiers=['Programming Language :: Python :: 2.7'])\n"
    files = {"setup.py": setup, "a.py": code, "b.py": code, "c.py": code}
    assert committed(tmp_path, files, day).plan.python.version == python
