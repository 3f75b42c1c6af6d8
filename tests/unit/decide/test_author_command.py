"""What a container of the author's image starts, and what it is given where that is a shell."""

from __future__ import annotations

import socket
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.author_command import entry_point, idle
from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan
from roslab.plan.run import Given

Tree = Callable[[dict[str, str]], Decision]
RUN = "## Usage\n\n```\n{}\n```\n"
ROS = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(node a.cpp)\n",
    "launch/demo.launch": "<launch/>",
    "launch/other.launch": "<launch/>",
    "README.md": RUN.format("roslaunch demo demo.launch"),
}
IMAGE = "FROM ros:noetic\nCOPY . /ws/src/demo\nRUN cd /ws && catkin_make\n"


@pytest.mark.parametrize(
    "argv",
    [(), ("bash",), ("/bin/bash", "-l"), ("bash", "-c", "source /ws/devel/setup.bash && exec bash"),
     ("bash", "-c", "/bin/zsh"), ("tail", "-f", "/dev/null"), ("sleep", "infinity"), ("bash", "-c", "sleep infinity")],
)  # fmt: skip
def test_a_shell_and_what_waits_for_one(argv: tuple[str, ...]) -> None:
    assert idle(argv)


@pytest.mark.parametrize(
    "argv",
    [("python3", "a.py"), ("bash", "run.sh"), ("bash", "-c", "roslaunch a b"), ("bash", "-c", "bash run.sh"),
     ("bash", "-c", "echo 'no end")],
)  # fmt: skip
def test_a_program_is_no_shell(argv: tuple[str, ...]) -> None:
    assert not idle(argv)


@pytest.mark.parametrize(
    ("argv", "kind"),
    [
        ((), "none"),
        (("/ros_entrypoint.sh",), "wrapper"),
        (("bash", "/docker/entrypoint.bash"), "wrapper"),
        (("/tini", "--"), "wrapper"),
        (("tini", "--", "python3", "a.py"), "program"),
        (("conda", "run", "--no-capture-output", "-n", "x"), "wrapper"),
        (("bash", "-c", 'source a; exec "$@"', "--"), "wrapper"),
        (("/bin/bash",), "shell"),
        (("python3", "a.py"), "program"),
    ],
)
def test_what_an_entry_point_does_with_a_command(argv: tuple[str, ...], kind: str) -> None:
    assert entry_point(argv) == kind


@pytest.mark.parametrize("end", ["", 'CMD ["bash"]\n', 'ENTRYPOINT ["/ros_entrypoint.sh"]\nCMD ["/bin/bash"]\n'])
def test_the_readme_names_what_an_image_that_ends_in_a_shell_is_given(tree: Tree, end: str) -> None:
    decision = tree(ROS | {"Dockerfile": IMAGE + end})
    assert decision.dockerfile == "Dockerfile"
    assert decision.command == ("roslaunch", "demo", "demo.launch")
    assert (decision.command_given, decision.command_through_entrypoint) == (True, True)


def test_a_shell_as_the_entry_point_is_replaced(tree: Tree) -> None:
    decision = tree(ROS | {"Dockerfile": IMAGE + 'ENTRYPOINT ["/bin/bash"]\n'})
    assert (decision.command_given, decision.command_through_entrypoint) == (True, False)


@pytest.mark.parametrize(
    ("end", "command"),
    [
        ('CMD ["roslaunch", "demo", "other.launch"]\n', ("roslaunch", "demo", "other.launch")),
        ('ENTRYPOINT ["roslaunch", "demo"]\nCMD ["other.launch"]\n', ("roslaunch", "demo", "other.launch")),
        ('ENTRYPOINT ["/run"]\n', ("/run",)),
    ],
)
def test_what_an_image_starts_by_itself_is_not_given(tree: Tree, end: str, command: tuple[str, ...]) -> None:
    decision = tree(ROS | {"Dockerfile": IMAGE + end})
    assert (decision.command, decision.command_given) == (command, False)


@pytest.mark.parametrize(
    ("folders", "command"),
    [
        ("WORKDIR /app\nCOPY . .\n", ("python", "demo.py")),
        ("COPY . /app\nWORKDIR /app/\n", ("python", "demo.py")),
        ("COPY . /app\nWORKDIR /\n", "cd app && exec python demo.py"),
        ("COPY . /app\nWORKDIR /app/sub\n", "cd .. && exec python demo.py"),
        ("COPY . $SOMEWHERE\n", ("bash",)),
    ],
)
def test_a_file_is_run_in_the_image_s_folder_of_the_tree(
    tree: Tree, folders: str, command: tuple[str, ...] | str
) -> None:
    page = RUN.format("python demo.py")
    decision = tree({"demo.py": "print(1)\n", "README.md": page, "Dockerfile": f"FROM python:3.9\n{folders}"})
    assert (decision.dockerfile, decision.command) == ("Dockerfile", command)
    assert decision.command_given  # a shell, too: the base would start Python's prompt


def planned(folder: Path, files: dict[str, str]) -> Plan:
    for path, text in files.items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    return plan_repository(folder).plan


def test_a_program_of_ros_is_given_with_the_workspaces(tmp_path: Path) -> None:
    plan = planned(tmp_path, ROS | {"Dockerfile": IMAGE})
    assert plan.run.given
    start = plan.proofs[-1]
    assert start.command == plan.run.given.command
    assert start.command[:2] == ("bash", "-c")
    assert start.command[3:] == ("start", "roslaunch", "demo", "demo.launch")
    assert (start.required, start.guessed, start.rung) == (False, True, 1)


@pytest.mark.parametrize("text", ["command: roslaunch demo other.launch", "command: [roslaunch, demo, other.launch]"])
def test_the_command_of_roslab_yaml_runs_beside_an_own_dockerfile(tmp_path: Path, text: str) -> None:
    said = f"format: 3\ndockerfile: Dockerfile\n{text}\n"
    plan = planned(
        tmp_path, ROS | {"Dockerfile": IMAGE + 'CMD ["roslaunch", "demo", "demo.launch"]\n', "roslab.yaml": said}
    )
    assert plan.run.given
    assert "other.launch" in " ".join(plan.run.given.command)
    assert (plan.proofs[-1].command, plan.proofs[-1].required) == (plan.run.given.command, True)


@pytest.mark.parametrize("runs", ["rosrun demo node", "roslaunch demo demo.launch"])
def test_a_node_has_a_master_in_the_author_s_image(tmp_path: Path, runs: str) -> None:
    page = {"README.md": RUN.format(runs)}
    plan = planned(tmp_path / "tree", ROS | {"Dockerfile": IMAGE} | page)
    assert plan.run.given
    assert plan.run.given.command[3:] == ("start", *runs.split())
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    said = tmp_path / "said"
    before = f'find() {{ :; }}; ROS_MASTER_URI=http://localhost:{port}; roscore() {{ echo "$@" >{said}; }}; '
    before += f"sleep() {{ until [ -s {said} ]; do command sleep 0.01; done; }}; "
    subprocess.run(["bash", "-c", before + plan.run.given.command[2], "start", "true"], check=True)
    assert (said.read_text() == f"-p {port}\n") if runs.startswith("rosrun") else not said.exists()


def test_a_compiled_program_is_found_where_it_was_compiled(tmp_path: Path) -> None:
    cmake = "cmake_minimum_required(VERSION 3.10)\nproject(demo)\nadd_executable(demo_of_it a.cpp)\n"
    files = {"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n", "README.md": RUN.format("./build/demo_of_it x")}
    plan = planned(tmp_path, files | {"Dockerfile": "FROM ubuntu:22.04\nCOPY . /a\nRUN cd /a && cmake . && make\n"})
    assert plan.run.given
    assert plan.run.given.command[3:] == ("start", "demo_of_it", "x")


def test_the_workspaces_of_an_image_are_sourced(tmp_path: Path) -> None:
    plan = planned(tmp_path, ROS | {"Dockerfile": IMAGE})
    assert plan.run.given
    made = tmp_path / "ws/devel"
    made.mkdir(parents=True)
    (made / "setup.bash").write_text("export MADE=here\n", encoding="utf-8")
    script = plan.run.given.command[2].replace("find / -xdev", f"find {tmp_path} -xdev")
    done = subprocess.run(
        ["bash", "-c", script, "start", "sh", "-c", "echo $MADE"], capture_output=True, text=True, check=True
    )
    assert done.stdout == "here\n"


@pytest.mark.parametrize(
    ("copied", "argv"),
    [
        ("COPY . /ws/src/demo\nWORKDIR /ws\n", ("rosrun", "demo", "node", "src/demo/cfg/a.yaml")),
        ("ENV WS=/ws\nCOPY . $WS/src/demo\nWORKDIR $WS\n", ("rosrun", "demo", "node", "src/demo/cfg/a.yaml")),
        ("COPY . /ws/src/demo\nWORKDIR /ws/src/demo\n", ("rosrun", "demo", "node", "cfg/a.yaml")),
        ("COPY . $HOME/src/demo\nWORKDIR /ws\n", ("roslaunch", "demo", "other.launch")),
        ("COPY . /ws/src/demo\n", ("rosrun", "demo", "node", "ws/src/demo/cfg/a.yaml")),
    ],
)
def test_a_node_is_given_the_files_where_the_author_s_image_has_them(
    tree: Tree, copied: str, argv: tuple[str, ...]
) -> None:
    page = RUN.format("rosrun demo node cfg/a.yaml\nroslaunch demo other.launch")
    image = f"FROM ros:noetic\n{copied}RUN cd /ws && catkin_make\n"
    assert tree({**ROS, "cfg/a.yaml": "rate: 1\n", "README.md": page, "Dockerfile": image}).command == argv


@pytest.mark.parametrize(
    ("heading", "more", "started"),
    [
        ("Installation", "", True),
        ("Testing", "", False),
        ("Installation", "add_executable(other b.cpp)\n", False),  # two, and the page's is named like a test
    ],
)
def test_the_only_program_is_the_command_though_it_is_named_like_a_test(
    tree: Tree, heading: str, more: str, *, started: bool
) -> None:
    files = {
        "package.xml": ROS["package.xml"],
        "CMakeLists.txt": f"project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(fetch_test a.cpp)\n{more}",
        "README.md": f"## {heading}\n\n```\nrosrun demo fetch_test\n```\n",
        "Dockerfile": IMAGE,
    }
    assert (tree(files).command == ("rosrun", "demo", "fetch_test")) is started


def test_a_script_that_only_prepares_is_not_the_command_though_it_is_the_only_one(tree: Tree) -> None:
    page = "## Installation\n\n```\nbash download_data.sh\n```\n"
    files = {"README.md": page, "download_data.sh": "wget a\n", "requirements.txt": "numpy\n"}
    assert tree(files).command == ("bash",)


@pytest.mark.parametrize(
    ("copied", "names"),
    [("COPY a /ws/src/a\n", ("a",)), ("COPY . /ws/src/demo\n", ("a", "b"))],
)
def test_of_an_image_of_the_author_only_what_it_copies_is_looked_for(
    tree: Tree, copied: str, names: tuple[str, ...]
) -> None:
    files = {
        f"{name}/package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend>"
        "<depend>acme_unknown</depend></package>"
        for name in ("a", "b")
    }
    files |= {f"{name}/CMakeLists.txt": f"project({name})\nfind_package(catkin REQUIRED)\n" for name in ("a", "b")}
    image = f"FROM ros:noetic\n{copied}RUN cd /ws && catkin_make\n"
    decision = tree({**files, "Dockerfile": image})
    assert (decision.dockerfile, tuple(sorted(decision.package_names))) == ("Dockerfile", names)
    assert not any("rosdep has no key" in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("base", "last", "given"),
    [
        ("ghcr.io/lab/robot:1.2", "", True),
        ("python:3.12", "", True),
        ("ghcr.io/lab/robot:1.2", "CMD bash\n", False),
        ("ubuntu:22.04", "", False),
        ("pytorch/pytorch:2.4.0-cuda12.4-cudnn9-runtime", "", False),
    ],
)
def test_the_shell_of_the_plan_is_what_a_container_starts(tmp_path: Path, base: str, last: str, *, given: bool) -> None:
    (tmp_path / "Dockerfile").write_text(f"FROM {base}\nCOPY . /robot\nRUN pip install /robot\n{last}")
    (tmp_path / "setup.py").write_text("from setuptools import setup\nsetup(name='robot', packages=['robot'])\n")
    plan = plan_repository(tmp_path).plan
    assert plan.run.command == ("bash",)
    assert plan.run.given == (Given(command=("bash",), entrypoint=False) if given else None)


@pytest.mark.parametrize(
    ("image", "prefix"),
    [
        ("FROM ros:humble\nWORKDIR /ws\nCOPY . /ws/src\nRUN colcon build\n", "src/"),
        ("FROM ros:humble\nWORKDIR /ws/src\nCOPY . /ws/src\nRUN colcon build\n", ""),
    ],
)
def test_every_command_names_files_from_where_a_container_starts(tree: Tree, image: str, prefix: str) -> None:
    build = "<buildtool_depend>ament_cmake</buildtool_depend>"
    files = {
        "estimator/package.xml": f"<package format='3'><name>estimator</name>{build}</package>",
        "estimator/CMakeLists.txt": "project(estimator)\nfind_package(ament_cmake REQUIRED)\n"
        "add_executable(flat a.cpp)\nadd_executable(round a.cpp)\n",
        "config/a.yml": "a: 1\n",
        "tools/show.py": "if __name__ == '__main__':\n    print(1)\n",
        "README.md": RUN.format(
            "ros2 run estimator flat --ros-args --params-file config/a.yml\n"
            "ros2 run estimator round --ros-args --params-file config/a.yml\npython3 tools/show.py"
        ),
        "docker/Dockerfile": image,
    }
    decision = tree(files)
    assert decision.dockerfile == "docker/Dockerfile"
    end = ("--ros-args", "--params-file", f"{prefix}config/a.yml")
    script = ("bash", "-c", "cd src && exec python3 tools/show.py") if prefix else ("python3", "tools/show.py")
    runs = {("ros2", "run", "estimator", name, *end) for name in ("flat", "round")}
    assert {*decision.command_candidates} >= {*runs, script}
