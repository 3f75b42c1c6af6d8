"""Imports that nothing brings are told with their lines; what may come from elsewhere is not."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SETUP = "from setuptools import setup\nsetup(name='play', install_requires=['numpy'])\n"
PAGE = {"README.md": "# Run\n```\npython run.py\n```\n", "run.py": "import numpy\n"}
"""What its program imports is tried by its own name; play.py is none of that."""


def test_a_package_behind_a_login_is_told_where_the_code_imports_it(tree: Tree) -> None:
    code = "import numpy\nimport isaacgym\nfrom isaacgym import gymapi\n"
    found = tree({"play.py": code, "setup.py": "from setuptools import setup\nsetup(install_requires=['numpy'])\n"})
    assert [(w.file, w.line) for w in found.warnings if "isaacgym" in w.message] == [("play.py", 2)]
    (said,) = [each.message for each in found.warnings if "isaacgym" in each.message]
    assert "unpack its archive in the source and run roslab again" in said
    assert "`pip install --no-deps --editable isaacgym/python`" in said
    assert said.count("roslab.yaml") == 1
    assert "`pip`" not in said
    assert {"libvulkan1", "libegl1", "ninja-build"} <= {*found.apt_guessed}


def test_its_system_packages_are_not_for_a_test_of_it(tree: Tree) -> None:
    found = tree({"play.py": "import numpy\n", "tests/a.py": "import isaacgym\n", "requirements.txt": "numpy\n"})
    assert "libvulkan1" not in found.apt_guessed


@pytest.mark.parametrize(
    ("distro", "module", "apt", "told"),
    [
        ("Indigo", "PySide", "python-pyside", False),
        ("Melodic", "PyQt4", "python-qt4", False),
        ("Indigo", "cv", "python-opencv", False),
        ("Indigo", "IPython", "ipython", False),
        ("Noetic", "IPython", "ipython3", False),
        ("Melodic", "numpy", "python-numpy", False),
        ("Noetic", "PySide", "", True),
        ("Noetic", "gtk", "", False),
    ],
)
def test_a_module_of_python_2_comes_from_the_ubuntu_that_has_it(
    tree: Tree, distro: str, module: str, apt: str, *, told: bool
) -> None:
    package = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"
    cmake = "project(a)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
    page = f"Tested on ROS {distro}.\n"
    code = f"#!/usr/bin/env python\nimport rospy\nimport {module}\n"
    found = tree({"package.xml": package, "CMakeLists.txt": cmake, "README.md": page, "scripts/show.py": code})
    assert found.ros_distro == distro.lower()
    assert any(f"imports {module}" in warning.message for warning in found.warnings) == told
    assert not apt or apt in found.apt_guessed
    assert apt or not [name for name in found.apt_guessed if "pyside" in name or "gtk" in name]


@pytest.mark.parametrize(
    ("files", "names"),
    [
        (
            {"play.py": "import numpy\nimport acme_arm\nimport acme_hand\n"},
            "acme_arm (play.py:2), acme_hand (play.py:3)",
        ),
        ({"play.py": "try:\n    import acme_arm\nexcept ImportError:\n    pass\n"}, ""),
        ({"play.py": "import acme_arm\n", "requirements.txt": "numpy\n"}, "acme_arm"),
        ({"play.py": "import acme_arm\n", "requirements.txt": "acme-robots\n"}, ""),
        ({"play.py": "import acme_arm\n", "requirements.txt": "acme_arm_driver\n"}, ""),
        ({"play.py": "import rospy\nimport tf2_ros\n", "requirements.txt": "numpy\n"}, ""),
        ({"play.py": "import numpy\n", "node.py": "import tf\nimport std_msgs\nimport acme_arm\n"}, "acme_arm"),
        ({"play.py": "import skfmm\n", "requirements.txt": "scikit-fmm\n"}, ""),
        ({"play.py": "import hector_uav_msgs\n", "requirements.txt": "numpy\n"}, ""),
        ({"play.py": "try:\n    import acme_arm\nexcept ImportError:\n    pass\n", "setup.py": SETUP}, ""),
        ({"play.py": '"""You can\nimport the top of it.\n"""\nimport numpy\n', "setup.py": SETUP}, ""),
        ({"tests/test_play.py": "import acme_arm\n"}, ""),
        ({"play.py": "import acme_arm\n", "README.md": "```\npip install acme-arm\n```\n"}, ""),
        ({"play.py": "import play_sdk\n", "setup.py": SETUP}, "play_sdk"),
        ({"play.py": "import play_sdk\n", "setup.py": SETUP.replace("numpy", "play-core")}, ""),
        (
            {
                "play.py": "import play_sdk\n",
                "setup.py": SETUP.replace("setup(", "setup(ext_modules=[Extension('a', [])],"),
            },
            "",
        ),
        (
            {
                "play.py": "import translate\n",
                ".gitmodules": '[submodule "down"]\n\tpath = down\n\turl = https://github.com/a/down.git\n',
            },
            "translate",
        ),
        (
            {
                "play.py": "import down_ops\n",
                ".gitmodules": '[submodule "down"]\n\tpath = down\n\turl = https://github.com/a/down.git\n',
            },
            "",
        ),
    ],
)
def test_a_module_of_no_table_is_told_once(tree: Tree, files: dict[str, str], names: str) -> None:
    said = [w.message for w in tree({**PAGE, "play.py": "import numpy\n", **files}).warnings if "no table" in w.message]
    assert len(said) == bool(names)
    assert not names or f"brings it: {names}; " in said[0]


@pytest.mark.parametrize(
    ("more", "unless"),
    [
        ({}, "brings it: acme_arm; name the package"),
        ({"requirements.txt": "numpy\n"}, "; unless a declared package brings it, name the package under `pip`"),
        (
            {
                "requirements.txt": "numpy\n",
                ".gitmodules": '[submodule "down"]\n\tpath = down\n\turl = https://github.com/a/down.git\n',
            },
            "; unless a declared package or a submodule brings it, name",
        ),
    ],
)
def test_what_else_may_bring_it_is_said(tree: Tree, more: dict[str, str], unless: str) -> None:
    found = tree({**PAGE, "play.py": "import numpy\nimport acme_arm\n", **more})
    ((message, file, line),) = [(w.message, w.file, w.line) for w in found.warnings if "no table" in w.message]
    assert (file, line) == ("play.py", 2)
    assert unless in message


def test_a_module_that_is_compiled_from_its_repository_comes_after_torch(tree: Tree) -> None:
    code = "import torch\nimport pointnet2_ops.pointnet2_modules as ops\ntorch.zeros(1).cuda()\n"
    found = tree({**PAGE, "play.py": code, "requirements.txt": "torch\n"})
    (asked,) = [each for each in found.python.pip_guessed if each.key == "pointnet2-ops"]
    assert asked.vcs
    assert asked.url.endswith("#subdirectory=pointnet2_ops_lib")
    assert "-devel-" in found.base_image
    assert found.python.requirements == ("requirements.txt",)  # brings torch, before what is guessed
    assert "torch" not in {each.key for each in (*found.python.first, *found.python.pip_guessed)}


SCAN = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "src/scan.py": "import rospy\nimport range_libc\n",
}
LIBRARY = "git clone https://github.com/kctess5/range_libc\ncd range_libc/pywrapper\n"


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({}, True),
        ({"README.md": f"```\n{LIBRARY}```\n"}, True),  # nothing compiles it there
        ({"src/range_libc/__init__.py": ""}, False),
        ({"src/scan.py": "try:\n    import range_libc\nexcept ImportError:\n    pass\n"}, False),
    ],
)
def test_a_package_of_ros_imports_what_pip_lacks(tree: Tree, files: dict[str, str], told: bool) -> None:
    found = [(w.file, w.line) for w in tree({**SCAN, **files}).warnings if "imports range_libc" in w.message]
    assert found == [("src/scan.py", 2)] * told


@pytest.mark.parametrize("install", ["pip install .", "python setup.py install"])
def test_what_a_page_installs_from_its_repository_is_not_lost(tree: Tree, install: str) -> None:
    page = f"```\n{LIBRARY}{install}\n```\n"
    found = tree({"play.py": "import range_libc\n", "requirements.txt": "numpy\n", "README.md": page})
    assert not any("range_libc" in warning.message for warning in found.warnings)
    assert [asked.url for asked in found.python.pip_guessed] == [
        "git+https://github.com/kctess5/range_libc#subdirectory=pywrapper"
    ]


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("As a prerequisite, you need to have [acme](https://github.com/lab/acme) installed.\n", True),
        ("The code requires the package [acme](https://github.com/lab/acme).\n", True),
        ("Download and install the acme code [here](https://github.com/lab/acme) by its page.\n", True),
        ("Install the drivers, then look at the code [here](https://github.com/lab/acme).\n", False),
        ("You need to have seen [acme](https://github.com/lab/acme).\n", False),
        ("Thanks to [acme](https://github.com/lab/acme), which depends on nothing.\n", False),
    ],
)
def test_what_a_page_requires_by_a_link(tree: Tree, said: str, told: bool) -> None:
    """Its name begins like that of a submodule, which may hold it just as well."""
    modules = '[submodule "acme_env"]\n\tpath = acme_env\n\turl = https://github.com/lab/acme_env.git\n'
    files = {"play.py": "import acme_agent\n", "requirements.txt": "numpy\n", ".gitmodules": modules}
    found = tree({**files, "README.md": f"# Run\n{said}```\npython play.py\n```\n"})
    assert [each.url for each in found.python.pip_guessed] == ["git+https://github.com/lab/acme"] * told
    messages = [w.message for w in found.warnings if "acme_agent" in w.message]
    assert len(messages) == told
    assert all("or acme (https://github.com/lab/acme) brings it" in message for message in messages)


@pytest.mark.parametrize(
    "page",
    [
        "It depends on our [PyAcmeArm](https://github.com/lab/PyAcmeArm) module, which you will need to install.\n",
        "```\ngit clone https://github.com/lab/PyAcmeArm\ncd PyAcmeArm\npip install .\n```\n",
    ],
)
def test_a_package_that_parts_its_name_otherwise_brings_the_module(tree: Tree, page: str) -> None:
    found = tree({"play.py": "import py_acme_arm\n", "requirements.txt": "numpy\n", "README.md": f"# Install\n{page}"})
    assert [each.url for each in found.python.pip_guessed] == ["git+https://github.com/lab/PyAcmeArm"]
    assert not any("py_acme_arm" in warning.message for warning in found.warnings)


@pytest.mark.parametrize(("module", "told"), [("acme", False), ("acme_hand", True)])
def test_the_folders_of_a_link_tell_what_it_brings(tree: Tree, module: str, told: bool) -> None:
    page = "```\npip install git+https://github.com/lab/fork.git#subdirectory=acme/acme/python\npython play.py\n```\n"
    found = tree({"play.py": f"import {module}\n", "README.md": page})
    assert any("no table" in warning.message for warning in found.warnings) == told


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({}, [("src/scan.py", 2)]),
        ({"src/acme_arm.py": ""}, []),
        ({"package.xml": SCAN["package.xml"].replace("</package>", "<depend>acme_arm_ros</depend></package>")}, []),
        ({"CMakeLists.txt": f"{SCAN['CMakeLists.txt']}pybind11_add_module(acme_arm arm.cpp)\n", "arm.cpp": ""}, []),
        ({"src/scan.py": "import rospy\nimport tf2_sensor_msgs\nimport gtk\nimport acme_msgs.msg\n"}, []),
        ({"src/scan.py": "import rospy\ntry:\n    import acme_arm\nexcept ImportError:\n    pass\n"}, []),
        ({"test/check.py": "import acme_arm\n", "src/scan.py": "import rospy\n"}, []),
    ],
)
def test_a_node_imports_what_no_table_knows(tree: Tree, files: dict[str, str], told: list[tuple[str, int]]) -> None:
    found = tree({**SCAN, "src/scan.py": "import rospy\nimport acme_arm\n", **files})
    said = [w for w in found.warnings if "no table knows which package brings it" in w.message]
    assert [(w.file, w.line) for w in said] == told
    assert all("or its repository under `source`" in w.message for w in said)


@pytest.mark.parametrize(
    ("name", "more", "told"),
    [
        ("arm-brumby", "", True),
        ("brumby-arm-play", "", True),
        ("arm-brumby", ", ext_modules=[Extension('brumby', [])]", False),
        ("arm-play", ", extras_require={'sim': ['brumby-core']}", False),
    ],
)
def test_a_project_is_called_after_what_it_needs(tree: Tree, name: str, more: str, *, told: bool) -> None:
    setup = SETUP.replace("'play'", repr(name)).replace("])", "]" + more + ")")
    found = tree({**PAGE, "play.py": "import numpy\nimport brumby\n", "setup.py": setup})
    assert any("brings it: brumby;" in warning.message for warning in found.warnings) == told


@pytest.mark.parametrize("package", ["brumby_mpc", "mpc_brumby"])
def test_a_package_of_ros_is_called_after_what_it_needs(tree: Tree, package: str) -> None:
    manifest = f"<package><name>{package}</name><buildtool_depend>catkin</buildtool_depend></package>"
    cmake = f"project({package})\nfind_package(catkin REQUIRED)\n"
    found = tree({"package.xml": manifest, "CMakeLists.txt": cmake, "src/a.py": "import rospy\nimport brumby\n"})
    assert any("brings it: brumby;" in warning.message for warning in found.warnings)


def test_what_a_page_only_clones_may_bring_it_and_is_not_in_the_image(tree: Tree) -> None:
    page = "# Install\n```\ngit clone git@github.com:lab/brumby_control.git\n```\n# Run\n```\npython play.py\n```\n"
    found = tree({"README.md": page, "play.py": "import numpy\nimport brumby\n", "requirements.txt": "numpy\n"})
    (said,) = [warning.message for warning in found.warnings if "no table" in warning.message]
    assert "unless a declared package or brumby_control (https://github.com/lab/brumby_control.git) brings it" in said
