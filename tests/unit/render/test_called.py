"""Scripts that call one another, and the one that reads package.xml files for all of them."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts
from roslab.render.layers.called import CALLED, with_called

SCRIPTS = {file.stem: file.read_text() for file in Path(image_scripts.__path__[0]).glob("*.sh")}
MANIFEST = """\
<package format="2">
  <name lang="en"> driver </name><version>1.0</version>
  <description>the <name>of</name> a camera</description>
  <buildtool_depend>catkin</buildtool_depend>
  <depend condition="$ROS_VERSION == 1">roscpp
  </depend>
  <exec_depend>msgs</exec_depend>
</package>
"""


@pytest.mark.parametrize("script", sorted(CALLED))
def test_the_table_has_what_a_script_calls(script: str) -> None:
    code = re.sub(r"^ *#.*|echo .*", "", SCRIPTS[script], flags=re.MULTILINE)
    words = {*re.findall(r"(?<![\w/-])[a-z]+(?:-[a-z]+)+(?![\w/-])", code)}
    assert {*CALLED[script]} == (words & {*SCRIPTS}) - {script}


def test_no_script_but_one_reads_a_name_itself() -> None:
    removed = re.escape("s#<name>[^<]*</name>##g")
    reads = [name for name, text in SCRIPTS.items() if re.search("sed.*<name", re.sub(removed, "", text))]
    assert reads == []


def test_what_is_called_is_copied_once() -> None:
    assert with_called(("clone-unknown", "required-components")) == (
        "clone-unknown",
        "required-components",
        "clone-holding",
        "leave-out-doubles",
        "listed-repositories",
        "workspace-packages",
        "read-manifest",
        "required-by-cmake",
        "checkout-branch",
        "fetch-submodules",
        "take-ros-branch",
        "serve-rosbuild",
    )


@pytest.mark.parametrize(("what", "told"), [("name", "driver\nother\n"), ("depends", "catkin\nroscpp\nmsgs\n")])
def test_what_manifests_tell(scripts_on_path: Path, what: str, told: str) -> None:
    first, second = scripts_on_path / "first.xml", scripts_on_path / "second.xml"
    first.write_text(MANIFEST)
    second.write_text("<package><name>other</name></package>")
    ran = subprocess.run(["read-manifest", what, first, second], capture_output=True, text=True, check=True)
    assert ran.stdout == told
