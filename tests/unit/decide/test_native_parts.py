"""Libraries that pip's packages are compiled against and do not bring, of the release that pip takes."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.native_parts import brought, decide_native_parts
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]


def parts(line: str, day: str | None = None) -> list[str]:
    return [part.name for part in decide_native_parts([stated(line)], (), (), day).answer.parts]


@pytest.mark.parametrize(
    ("line", "day", "name"),
    [
        ("mujoco-py==2.0.2.13", None, "MuJoCo 2.0"),
        ("mujoco_py>=2.1,<2.2", "2020-01-01", "MuJoCo 2.1.0"),
        ("mujoco-py==1.50.1.68", None, "MuJoCo 1.50"),
        ("mujoco-py==0.5.7", None, "MuJoCo 1.31"),
        ("mujoco-py<2", None, "MuJoCo 1.50"),
        ("mujoco-py>=1.50,<2.1", None, "MuJoCo 2.0"),
        ("mujoco-py>=1.50,<2.1", "2019-01-01", "MuJoCo 1.50"),
        ("mujoco-py", None, "MuJoCo 2.1.0"),
        ("mujoco-py", "2021-11-18", "MuJoCo 2.0"),
        ("mujoco-py @ git+https://host.test/mujoco-py", None, "MuJoCo 2.1.0"),
        ("gym[mujoco]==0.17.3", None, "MuJoCo 1.50"),
        ("gym[all]==0.13.0", "2019-07-01", "MuJoCo 2.0"),
        ("gym[mujoco_py]", None, "MuJoCo 2.1.0"),
        ("gym[mujoco]", "2021-01-01", "MuJoCo 1.50"),
        ("d4rl @ git+https://host.test/d4rl", None, "MuJoCo 2.1.0"),
        ("robosuite==1.2.0", None, "MuJoCo 2.0"),
        ("dm_control==0.0.322773188", None, "MuJoCo 2.0"),
        ("dm_control", "2021-01-01", "MuJoCo 2.0"),
        ("dm-control", "2021-11-01", "MuJoCo 2.1.0"),
        ("baselines", "2018-11-22", "MuJoCo 1.50"),
        ("baselines==0.1.5", "2019-05-01", "MuJoCo 2.0"),
    ],
)
def test_the_release_says_which(line: str, day: str | None, name: str) -> None:
    assert parts(line, day) == [name]


@pytest.mark.parametrize(
    "line",
    [
        "mujoco",
        "gym==0.17.3",
        "gym[mujoco]==0.26.2",
        "gym[atari]",
        "free-mujoco-py",
        "robosuite",
        "robosuite==1.3.1",
        "dm_control",
        "baselines @ git+https://host.test/baselines",
    ],
)
def test_what_needs_none(line: str) -> None:
    assert parts(line) == []


def test_a_package_that_brings_its_library_is_compiled_too() -> None:
    assert decide_native_parts([stated("robosuite==1.3.1")], (), (), None).answer.modules == ("mujoco_py",)


def test_a_copy_in_the_tree_is_of_the_release_that_it_says(tree: Tree) -> None:
    setup = "from setuptools import setup\nsetup(name='dm_control', version='{}', install_requires=['numpy'])\n"
    page = "```\npip install -e ./dm_control\n```\n"
    old = {"README.md": page, "dm_control/setup.py": setup.format("0.0.301472480"), "train.py": "import dm_control\n"}
    old |= {"requirements.txt": "dm_control\n"}
    (part,) = tree(old).python.native_parts
    assert part.folder == ".mujoco/mujoco200_linux"
    assert dict(part.variables) == {
        "MJLIB_PATH": ".mujoco/mujoco200_linux/bin/libmujoco200.so",
        "MJKEY_PATH": ".mujoco/mjkey.txt",
    }
    assert tree(old).python.compiled_modules == ()
    assert tree({**old, "dm_control/setup.py": setup.format("1.0.9")}).python.native_parts == ()


def test_what_comes_with_what_comes_with_another(tree: Tree) -> None:
    (found, further) = brought([stated("baselines")], "2018-11-22")
    assert (found.key, further.written) == ("gym", "mujoco-py>=1.50")
    assert [each.key for each in brought([stated("gym==0.17.3"), stated("baselines")], None)] == ["mujoco-py"]
    files = {"train.py": "from baselines import logger\n", "README.md": "```\npip install gym==0.10.9\n```\n"}
    (part,) = tree(files).python.native_parts
    assert (part.package, part.guessed) == ("mujoco-py", True)


@pytest.mark.parametrize("files", [{"requirements.txt": "robomimic==0.2.0\n"}, {"train.py": "import robomimic\n"}])
def test_what_it_brings_is_built_with_a_cmake_that_still_takes_it(tree: Tree, files: dict[str, str]) -> None:
    assert "cmake<4" in {each.written for each in tree({"README.md": "# Lab\n", **files}).python.first}


@pytest.mark.parametrize(
    ("lines", "brings"),
    [
        (("gym[box2d]==0.21.0",), {"box2d-py"}),
        (("gym[box2d,mujoco]==0.21.0",), {"box2d-py", "mujoco-py"}),
        (("gym[classic_control]==0.21.0",), set[str]()),
        (("gymnasium==1.2.2", "gymnasium[box2d]"), {"box2d-py"}),
        (("gymnasium[box2d]",), {"box2d"}),
    ],
)
def test_each_extra_brings_its_own_in_the_release_that_is_declared(lines: tuple[str, ...], brings: set[str]) -> None:
    assert {each.key for each in brought(map(stated, lines), None)} == brings


def test_what_is_asked_for_by_itself_is_not_brought() -> None:
    assert not brought([stated("d4rl"), stated("mujoco-py==2.0.2.13")], None)


def test_a_release_that_no_row_knows_is_told() -> None:
    choice = decide_native_parts([stated("mujoco-py==0.4.4")], (), (), None)
    assert not choice.answer.parts
    assert [warning.message.partition(" that ")[0] for warning in choice.warnings] == [
        "mujoco-py==0.4.4 needs a native library"
    ]


def test_the_compiler_of_the_module_stays_old() -> None:
    bounds = decide_native_parts([stated("mujoco-py")], (), (), None).answer.bounds
    assert [each.written for each in bounds] == ["Cython<3"]
    asked = [stated("mujoco-py"), stated("Cython==0.29.21")]
    assert not decide_native_parts(asked, (), (), None).answer.bounds


def test_what_is_declared(tree: Tree) -> None:
    decision = tree({"train.py": "import mujoco_py\n", "requirements.txt": "mujoco-py==2.0.2.13\n"})
    (part,) = decision.python.native_parts
    assert (part.folder, part.guessed) == (".mujoco/mujoco200", False)
    assert dict(part.variables)["MUJOCO_PY_MJKEY_PATH"] == ".mujoco/mjkey.txt"
    first = {each.written for each in decision.python.first}
    assert {"numpy", "Cython<3", "cffi", "fasteners<1", "glfw", "imageio"} <= first
    said = [(reason.answer, reason.file) for reason in decision.reasons if "does not bring it" in reason.reason]
    assert said == [("MuJoCo 2.0", "requirements.txt")]


def test_what_comes_with_another(tree: Tree) -> None:
    decision = tree({"train.py": "import gym\n", "requirements.txt": "gym[mujoco]==0.17.3\n"})
    assert [part.name for part in decision.python.native_parts] == ["MuJoCo 1.50"]
    assert "patchelf" in decision.apt_guessed
    assert decision.platforms == ("linux/amd64",)


def test_the_trees_own_copy(tree: Tree) -> None:
    setup = "from setuptools import setup\nsetup(name='mujoco-py', version='2.1.2.14', packages=['mujoco_py'])\n"
    decision = tree({"setup.py": setup, "mujoco_py/__init__.py": "", "train.py": "import mujoco_py\n"})
    assert [part.name for part in decision.python.native_parts] == ["MuJoCo 2.1.0"]
    assert decision.platforms_refused == (
        ("linux/arm64", "MuJoCo 2.1.0, which mujoco-py needs, is an archive for amd64 only"),
    )


def test_what_is_only_imported(tree: Tree) -> None:
    decision = tree({"train.py": "import mujoco_py\n", "requirements.txt": "numpy\n"})
    assert [(part.name, part.guessed) for part in decision.python.native_parts] == [("MuJoCo 2.1.0", True)]
    assert "linux/arm64" in decision.platforms


def test_a_page_that_fetches_it_asks_for_nothing_more(tree: Tree) -> None:
    page = "# Installation\n```\nwget https://www.roboti.us/download/mujoco200_linux.zip\nwget https://host.test/arm.zip\n```\n"
    files = {"train.py": "import mujoco_py\n", "requirements.txt": "mujoco-py==2.0.2.13\n", "README.md": page}
    told = [warning.message for warning in tree(files).warnings if "not part of the image" in warning.message]
    assert ["arm.zip" in message for message in told] == [True]


def test_what_a_declared_package_brings_counts_more_than_an_import(tree: Tree) -> None:
    code = "import gym\nimport mujoco_py\n"
    decision = tree({"train.py": code, "requirements.txt": "gym[mujoco]==0.17.3\n"})
    assert [(part.name, part.guessed) for part in decision.python.native_parts] == [("MuJoCo 1.50", False)]
