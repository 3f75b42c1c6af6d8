"""Folders of the tree in which its scripts have a simulator look for models: the image has them, too."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
BUILT = {
    "sim/package.xml": "<package><name>sim</name><buildtool_depend>catkin</buildtool_depend></package>",
    "sim/CMakeLists.txt": "project(sim)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    "sim/models/cup/model.sdf": "<sdf/>\n",
    "plugins/libcup.so": "",
    "README.md": "ROS Noetic\n",
}
ITSELF = '"$( cd "$( dirname "${BASH_SOURCE[0]}" )" >/dev/null 2>&1 && pwd )"'


@pytest.mark.parametrize(
    ("file", "script", "found"),
    [
        ("setup.sh", f"DIR={ITSELF}\nexport GAZEBO_MODEL_PATH=$GAZEBO_MODEL_PATH:$DIR/sim/models\n", "./sim/models"),
        ("sim/scripts/a.bash", "D=$(dirname $0)/..\nexport GAZEBO_MODEL_PATH=${D}/models\n", "./sim/models"),
        ("sim/a.sh", f"export GAZEBO_MODEL_PATH={ITSELF}/models:$GAZEBO_MODEL_PATH\n", "./sim/models"),
        ("tools/a.sh", "export GAZEBO_MODEL_PATH=$(pwd)/sim/models\n", "./sim/models"),
        ("sim/a.sh", "export GAZEBO_MODEL_PATH=`pwd`/models\n", "./sim/models"),
        ("a.sh", 'export GAZEBO_MODEL_PATH="$(rospack find sim)/models:$GAZEBO_MODEL_PATH"\n', "./sim/models"),
        ("a.sh", "export GAZEBO_MODEL_PATH=$PWD/sim/models\nexport GAZEBO_MODEL_PATH=$PWD\n", "./sim/models:./"),
        ("a.sh", "export GAZEBO_MODEL_PATH=~/other/sim/models\n", ""),
        ("a.sh", "export GAZEBO_MODEL_PATH=$OTHER/sim/models\n", ""),
        ("a.sh", "export GAZEBO_MODEL_PATH=$PWD/lost\n", ""),
        ("a.sh", "if [ -d x ]; then\n  export GAZEBO_MODEL_PATH=$PWD/sim/models\nfi\n", ""),
        ("a.sh", "# export GAZEBO_MODEL_PATH=$PWD/sim/models\n", ""),
        ("a.sh", "export ANOTHER_PATH=$PWD/sim/models # GAZEBO_MODEL_PATH\n", ""),
        ("third_party/a.sh", "export GAZEBO_MODEL_PATH=$(pwd)/sim/models\n", ""),
        ("a.sh", "export GAZEBO_MODEL_PATH=$(((((((((((\n", ""),
    ],
)
def test_what_a_script_sets(tree: Tree, file: str, script: str, found: str) -> None:
    decision = tree({**BUILT, file: script})
    assert dict(decision.variables).get("GAZEBO_MODEL_PATH", "") == found


def test_a_path_that_has_the_repository_s_name(tree: Tree, tmp_path: Path) -> None:
    for folder, found in (("sim/models", "./sim/models"), ("lost", "")):
        decision = tree({**BUILT, "a.sh": f"export GAZEBO_MODEL_PATH=~/ws/src/{tmp_path.name}/{folder}\n"})
        assert dict(decision.variables).get("GAZEBO_MODEL_PATH", "") == found


def test_several_scripts_and_variables(tree: Tree) -> None:
    scripts = {
        "a.sh": "export GAZEBO_PLUGIN_PATH=$PWD/plugins\nexport GAZEBO_MODEL_PATH=$PWD/sim/models\n",
        "b.sh": "export GAZEBO_MODEL_PATH=$PWD/sim/models:$PWD/plugins\n",
    }
    decision = tree({**BUILT, **scripts})
    wanted = {"GAZEBO_PLUGIN_PATH": "./plugins", "GAZEBO_MODEL_PATH": "./sim/models:./plugins"}
    assert dict(decision.variables) == wanted
    (why,) = [each for each in decision.reasons if each.answer.startswith("GAZEBO_MODEL_PATH=")]
    assert (why.file, why.line, why.reason) == ("a.sh", 2, "a script of the tree sets it, and the simulator reads it")


def test_a_page_comes_first(tree: Tree) -> None:
    page = {"README.md": "ROS Noetic\n```\nexport GAZEBO_MODEL_PATH=`pwd`/plugins\n```\n"}
    decision = tree({**BUILT, **page, "a.sh": "export GAZEBO_MODEL_PATH=$PWD/sim/models\n"})
    assert dict(decision.variables) == {"GAZEBO_MODEL_PATH": "./plugins"}
