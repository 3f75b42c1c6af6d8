"""A repository that is itself the ``src`` of its author's workspace finds what the build writes beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan
from roslab.render.dockerfile import dockerfile

MANIFEST = (
    "<package format='2'><name>demo</name><version>0.1.0</version>"
    "<description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>catkin</buildtool_depend></package>"
)
CMAKE = "cmake_minimum_required(VERSION 3.0)\nproject(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
HERE = "#!/bin/bash\nhere=$(cd $(dirname $0); pwd)\n"
PAGE = (
    "# Demo\n\nROS Noetic\n\n## Usage\n\n```bash\ncd /author\ncatkin_make\n"
    "python3 /author/src/tools/run.py -c /author/src/demo/config/a.yaml\n```\n"
)
CLONE = "ROS Noetic\n```\nmkdir ws\ncd ws\ngit clone https://github.com/a/{}.git src\ncatkin_make\n```\n"
PROGRAM = "import argparse\nif __name__ == '__main__':\n    argparse.ArgumentParser().parse_args()\n"
IN_PYTHON = (
    "import os\nhere = os.path.dirname({}os.path.abspath(__file__){})\n"
    "if __name__ == '__main__':\n    os.system('bash -c \"source {{}}{}/devel/setup.bash\"'.format(here))\n"
)


def planned(folder: Path, files: dict[str, str], at: str = "demo/") -> Plan:
    package = {f"{at}package.xml": MANIFEST, f"{at}CMakeLists.txt": CMAKE, "demo/config/a.yaml": "a: 1\n"}
    for path, written in {"README.md": "ROS Noetic\n", **package, **files}.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(written)
    return plan_repository(folder).plan


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({".gitignore": "*.o\n/CMakeLists.txt\n"}, True),
        ({".gitignore": "*.o\nCMakeLists.txt.user\n"}, False),
        ({"run.sh": HERE + 'source "$here/../devel/setup.bash"\n'}, True),
        ({"tools/run.sh": HERE + "source $here/../../devel/setup.bash\n"}, True),
        ({"tools/run.sh": HERE + "source $here/../devel/setup.bash\n"}, False),  # in the repository itself
        ({"run.sh": HERE + 'source "$here/../install/setup.bash"\n'}, False),  # of another tool
        ({"tools/run.py": IN_PYTHON.format("os.path.dirname(", ")", "/..")}, True),
        ({"tools/run.py": IN_PYTHON.format("", "", "/../..")}, True),
        ({"tools/run.py": IN_PYTHON.format("", "", "/../../..")}, False),
        (
            {"README.md": CLONE.format("whole")},
            True,
        ),
        ({"README.md": CLONE.format("other")}, False),
    ],
)
def test_what_the_build_writes_is_linked_beside_it(tmp_path: Path, files: dict[str, str], *, found: bool) -> None:
    root = tmp_path / "whole"
    plan = planned(root, files)
    assert plan.workspace.folder == "ws/src/whole"
    assert (("ws/src/devel", "../devel") in plan.workspace.links) == found
    assert ("ln --symbolic ../devel /home/${NB_USER}/ws/src/devel" in dockerfile(plan)) == found


def test_one_package_lies_in_the_src_of_any_workspace(tmp_path: Path) -> None:
    assert not planned(tmp_path, {".gitignore": "/CMakeLists.txt\n"}, at="").workspace.links


@pytest.mark.parametrize(
    ("file", "text", "found"),
    [
        (
            "docker/run.sh",
            HERE + "docker run --rm \\\n    -v /dev:/dev \\\n    -v $here/../:/author/src \\\n    demo\n",
            True,
        ),
        ("run.sh", 'docker run -v "$(pwd)":/author/src demo\n', True),
        ("run.sh", "docker run --volume=${PWD}:/author/src:rw demo\n", True),
        ("docker/run.sh", 'docker run -v "$(pwd)":/author/src demo\n', False),  # of the folder it is called in
        ("docker/run.sh", HERE + "docker run -v $here:/author/src demo\n", False),
        ("run.sh", 'docker run -v "$(pwd)":/author/src/demo demo\n', False),
        ("run.sh", 'docker run -v "$(pwd)":/other/src demo\n', False),  # in which nothing builds
        ("docker-compose.yml", "services:\n  demo:\n    image: demo\n    volumes:\n      - ./:/author/src\n", True),
        ("docker/compose.yaml", "services:\n  demo:\n    image: demo\n    volumes:\n      - ..:/author/src:rw\n", True),
        ("docker/compose.yaml", "services:\n  demo:\n    image: demo\n    volumes:\n      - .:/author/src\n", False),
    ],
)
def test_the_author_s_workspace_leads_to_the_image_s(tmp_path: Path, file: str, text: str, *, found: bool) -> None:
    files = {file: text, "README.md": PAGE, "tools/run.py": PROGRAM}
    plan = planned(tmp_path / "whole", files)
    linked = (("/author/devel", "ws/devel"), ("/author/src", "ws/src/whole"))
    assert plan.author_folders == (linked if found else ())
    given = "/author/src/demo/config/a.yaml" if found else "demo/config/a.yaml"
    assert plan.run.command == ("python3", "tools/run.py", "-c", given)


@pytest.mark.parametrize(
    ("folder", "found"),
    [
        ("/home/jovyan/ws", False),
        ("/home/jovyan/other", False),
        ("/", False),
        ("/usr", False),
        ("/usr/local/ws", False),
        ("/etc", False),
        ("/root/ws", False),
        ("/opt", False),
        ("/opt/ros/noetic", False),
        ("/-rf", False),
        ("/author/-x", False),
        ("/opt/ws", True),
        ("/home/me/ws", True),
        ("/author/../ws", True),
    ],
)
def test_no_link_lies_in_a_folder_of_the_image(tmp_path: Path, folder: str, *, found: bool) -> None:
    above = folder.replace("/author/..", "")
    page = PAGE.replace("cd /author\n", f"cd {above}\n").replace("/author/", f"{above.rstrip('/')}/")
    plan = planned(
        tmp_path / "whole",
        {
            "run.sh": f'docker run -v "$(pwd)":{folder}/src demo\n',
            "README.md": page,
            "tools/run.py": PROGRAM,
        },
    )
    linked = ((f"{above}/devel", "ws/devel"), (f"{above}/src", "ws/src/whole"))
    assert plan.author_folders == (linked if found else ())
    assert found or not any(word.startswith(f"{above}/src") for word in plan.run.command)
