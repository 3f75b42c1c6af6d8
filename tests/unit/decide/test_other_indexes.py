"""Frameworks that only their maker's index has are asked for there, in the release that the repository is for."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
INDEX = "--extra-index-url https://pypi.nvidia.com"
TRAIN = "from isaaclab.app import AppLauncher\nimport omni.log\nfrom pxr import Usd\nimport isaaclab_tasks\n"
SETUP = "from setuptools import setup\nsetup(name='walk', classifiers=['Isaac Sim :: {}'])\n"


def _asked(found: Decision) -> list[str]:
    return [each.written for each in (*found.python.pip, *found.python.pip_guessed)]


@pytest.mark.parametrize(
    ("said", "release", "python"),
    [
        ({"setup.py": SETUP.format("4.5.0")}, "2.1.0", "3.10"),
        (
            {"README.md": "# Walk\n[![Isaac Sim](https://img.shields.io/badge/IsaacSim-5.0.0-silver.svg)]\n"},
            "2.2.0",
            "3.11",
        ),
        ({"README.md": "# Walk\nTested with Isaac Lab v2.0.\n"}, "2.0.2", "3.10"),
        ({}, "2.3.2.post1", "3.11"),
    ],
)
def test_the_release_is_the_one_that_is_said(tree: Tree, said: dict[str, str], release: str, python: str) -> None:
    found = tree({"train.py": TRAIN, **said})
    assert f"isaaclab[isaacsim,all]=={release}" in _asked(found)
    assert INDEX in found.python.options
    assert found.python.version == python
    assert not {"usd-core", "isaaclab-tasks", "omni"} & {*_asked(found)}
    assert not any("no table knows" in each.message for each in found.warnings)


def test_what_needs_it_is_for_amd64_and_a_gpu_and_its_licence_is_told(tree: Tree) -> None:
    found = tree({"train.py": TRAIN})
    assert found.platforms == ("linux/amd64",)
    assert found.kind == "cuda"
    assert any("-e OMNI_KIT_ACCEPT_EULA=YES" in each.message for each in found.warnings)


def test_a_declared_one_stays_the_authors_and_gets_the_index(tree: Tree) -> None:
    found = tree({"train.py": TRAIN, "requirements.txt": "isaaclab[isaacsim]==2.0.1\ntorch==2.5.1\n"})
    assert INDEX in found.python.options
    assert not any("2.3" in each for each in _asked(found))


def test_of_an_older_generation_pip_gets_the_simulator_and_git_the_rest(tree: Tree) -> None:
    found = tree({"train.py": "from omni.isaac.lab.app import AppLauncher\nimport omni.isaac.core\n"})
    asked = _asked(found)
    assert "isaacsim==4.2.0.2" in asked
    assert not any(each.startswith("isaaclab") for each in asked)
    assert [each.partition("extensions/")[2] for each in asked if "IsaacLab@v1.4.1" in each] == [
        "omni.isaac.lab",
        "omni.isaac.lab_assets",
        "omni.isaac.lab_tasks",
    ]
    assert all(each.editable for each in found.python.pip_guessed if each.url)
    assert found.python.version == "3.10"


def test_the_simulator_alone(tree: Tree) -> None:
    found = tree({"train.py": "from isaacsim import SimulationApp\n", "README.md": "Isaac Sim 4.5\n"})
    assert "isaacsim[all,extscache]==4.5.0.0" in _asked(found)
    assert found.python.version == "3.10"


def test_nothing_without_an_import(tree: Tree) -> None:
    found = tree({"train.py": "import numpy\n", "README.md": "Compared with Isaac Lab 2.1.\n"})
    assert _asked(found) == ["numpy"]
    assert INDEX not in found.python.options
