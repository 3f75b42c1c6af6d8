"""Folders of data that git did not keep are made in the image."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

MANIFEST = (
    "<package format='2'><name>demo</name><version>0.1.0</version><description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>{}</buildtool_depend></package>"
)
CMAKE = "project(demo)\nfind_package({} REQUIRED)\nadd_executable(demo src/demo.cpp)\n"
WRITES = 'std::ofstream f(ros::package::getPath("demo") + "{}");\n'


def lost(folder: Path, files: dict[str, str], tool: str = "catkin") -> tuple[list[str], str]:
    """Return the folders that warnings name, and the Dockerfile."""
    base = {
        "README.md": "ROS Noetic\n" if tool == "catkin" else "ROS 2 Humble\n",
        "demo/package.xml": MANIFEST.format(tool),
        "demo/CMakeLists.txt": CMAKE.format(tool),
        "demo/src/demo.cpp": "int main() {}\n",
    }
    tree_of(folder, {**base, **files})
    planned = plan_repository(folder)
    told = [w.message.split()[5] for w in planned.decision.warnings if "its code has files there" in w.message]
    return told, dockerfile(planned.plan)


@pytest.mark.parametrize(
    ("file", "text", "found"),
    [
        ("demo/src/demo.cpp", WRITES.format("/results/path.bin"), "demo/results"),
        ("demo/src/demo.cpp", WRITES.format("/results/maps/"), "demo/results/maps"),
        ("other.cpp", WRITES.format("/results/path.bin"), "demo/results"),
        ("demo/scripts/a.py", "open(rospkg.RosPack().get_path('demo') + '/results/a.csv', 'w')\n", "demo/results"),
        (
            "demo/scripts/a.py",
            "open(os.path.join(rospack.get_path('demo'), 'results/a.csv'), 'w')\n",
            "demo/results",
        ),
        (
            "demo/launch/a.launch",
            "<launch><param name='a' value='$(find demo)/results/a.bin'/></launch>\n",
            "demo/results",
        ),
        ("demo/launch/a.launch", "<launch><param name='a' value='$(find demo)/results/a.yaml'/></launch>\n", ""),
        (
            "demo/launch/a.launch",
            "<launch><!-- <arg name='a' default='$(find demo)/results/a.bin'/> --></launch>\n",
            "",
        ),
        ("demo/src/demo.cpp", WRITES.format("/src/path.bin"), ""),
        ("demo/src/demo.cpp", WRITES.format("/path.bin"), ""),
        ("demo/src/demo.cpp", WRITES.format("/../results/path.bin"), ""),
        ("demo/src/demo.cpp", "// " + WRITES.format("/results/path.bin"), ""),
        ("demo/src/demo.cpp", WRITES.format("/results/a.bin").replace('"demo"', '"others"'), ""),
    ],
)
def test_it_is_made_and_told(tmp_path: Path, file: str, text: str, found: str) -> None:
    root = tmp_path / "whole"
    told, written = lost(root, {file: text})
    assert told == ([f"{found}/"] if found else [])
    line = f"mkdir --parents /home/${{NB_USER}}/ws/src/whole/{found}"
    assert written.count(line) == (2 if found else 0), "before the build, and where the source is copied again after it"


@pytest.mark.parametrize(
    ("files", "told_empty"),
    [
        (["demo/models/net.trt"], False),
        (["demo/models/other.trt"], True),
        (["demo/models/net.trt", "other/net.trt"], True),  # either may be meant
    ],
)
def test_what_lies_elsewhere_is_told(tmp_path: Path, files: list[str], *, told_empty: bool) -> None:
    root = tmp_path / "whole"
    launch = "<launch><param name='a' value='$(find demo)/demo/models/net.trt'/></launch>\n"
    told, written = lost(root, {"demo/launch/a.launch": launch, **dict.fromkeys(files, "")})
    assert told == (["demo/demo/models/"] if told_empty else [])
    assert "whole/demo/demo/models" in written
    warnings = [each.message for each in plan_repository(root).decision.warnings]
    said = "demo/demo/models/net.trt is named there, and the repository has demo/models/net.trt: correct the path"
    assert (said in warnings) != told_empty


@pytest.mark.parametrize(
    ("file", "text", "reads"),
    [
        ("demo/src/demo.cpp", WRITES.format("/results/path.txt"), False),
        ("demo/src/demo.cpp", WRITES.format("/data/path.txt").replace("ofstream", "ifstream"), True),
        ("demo/scripts/a.py", "open(rospkg.RosPack().get_path('demo') + '/data/path.txt', 'w')\n", False),
        ("demo/scripts/a.py", "open(rospkg.RosPack().get_path('demo') + '/data/path.txt')\n", True),
    ],
)
def test_the_file_elsewhere_is_told_only_where_it_is_read(tmp_path: Path, file: str, text: str, *, reads: bool) -> None:
    root = tmp_path / "whole"
    told, written = lost(root, {file: text, "eval/sample/path.txt": ""})
    folder = "demo/results" if "results" in text else "demo/data"
    assert told == ([] if reads else [f"{folder}/"])
    assert f"whole/{folder}" in written


def test_of_ros_2_nothing_is_found_where_the_source_lies(tmp_path: Path) -> None:
    told, written = lost(tmp_path / "whole", {"demo/src/demo.cpp": WRITES.format("/results/a.bin")}, "ament_cmake")
    assert (told, "ws/src/whole/demo/results" in written) == ([], False)


@pytest.mark.parametrize(
    ("file", "refusing", "made"),
    [
        (
            "demo/src/demo.cpp",
            'if (fs::is_directory(d)) { ROS_ERROR("is there"); return 0; }\nfs::create_directory(d);\n',
            False,
        ),
        (
            "demo/src/demo.cpp",
            'if (!fs::is_directory(d)) { ROS_ERROR("no"); return 0; }\nfs::create_directory(e);\n',
            True,
        ),
        ("demo/src/demo.cpp", "if (fs::exists(d)) { fs::remove_all(d); }\nfs::create_directory(d);\n", True),
        ("demo/src/demo.cpp", "if (fs::exists(d)) { return 0; }\n", True),
        ("demo/scripts/a.py", "if os.path.isdir(d):\n    print('is there')\n    sys.exit(1)\nos.makedirs(d)\n", False),
        ("demo/scripts/a.py", "if not os.path.isdir(d):\n    sys.exit(1)\nos.makedirs(e)\n", True),
    ],
)
def test_a_folder_that_the_code_makes_and_must_not_find_is_not_made(
    tmp_path: Path, file: str, refusing: str, *, made: bool
) -> None:
    given = "d = rospkg.RosPack().get_path('demo') + '/results/'\n"
    if file.endswith(".cpp"):
        given = 'fs::path d(ros::package::getPath("demo") + "/results/");\n'
    told, written = lost(tmp_path / "whole", {file: given + refusing})
    assert (told, "ws/src/whole/demo/results" in written) == (["demo/results/"] if made else [], made)
