"""The chain of repairs: what `roslab build` would try is what `roslab explain` and the action propose, in its order."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path

import pytest

from roslab.cli.main import main
from roslab.cli.repairing import given
from roslab.explain.answer import explain
from roslab.github.explaining import mend
from roslab.github.run import Run
from roslab.pipeline import plan_repository
from roslab.repair.chain import Asking, proposed, unasked
from roslab.repair.change import Repair
from trees import tree_of

CMAKE = "cmake_minimum_required(VERSION 3.0)\nproject({0})\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
CMAKE += "add_executable({0}_node main.cpp)\n"
XML = '<package format="2"><name>{}</name><version>1.0.0</version><buildtool_depend>catkin</buildtool_depend></package>'
WORKSPACE = {
    "roslab.yaml": "format: 3\nbase: {ros: noetic}\n",
    "README.md": "```\nrosrun arm_demo arm_demo_node\n```\n",
    **{f"{name}/CMakeLists.txt": CMAKE.format(name) for name in ("arm_demo", "arm_extra")},
    **{f"{name}/package.xml": XML.format(name) for name in ("arm_demo", "arm_extra")},
    **{f"{name}/main.cpp": "#include A\nint main() {}\n" for name in ("arm_demo", "arm_extra")},
}
PROGRAM = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.5)\nproject(arm CXX)\nadd_executable(arm_app a.cpp)\n"
    "add_executable(arm_extra b.cpp)\n",
    "a.cpp": "int main() {}\n",
    "b.cpp": "int main() { return grip(); }\n",
    "README.md": "# Arm\n\n```\nmkdir build && cd build && cmake .. && make\n./arm_app\n```\n",
}
PYTHON = {
    "roslab.yaml": "format: 3\nkind: python\n",
    "requirements.txt": "fast-robot==2.0\n",
    "main.py": "import fast_robot\n",
}
OWN = {"Dockerfile": "FROM ubuntu:20.04\nCOPY . /src\nRUN make\n", "main.cpp": "int main() {}\n"}
SOURCE = "/home/jovyan/ws/src/robot/arm_extra/main.cpp:1:2"
MADE = "make[2]: *** [robot/arm_extra/CMakeFiles/x.dir/build.make:7: x.o] Error 1"
HEADER = f"{SOURCE}: fatal error: {{}}: No such file or directory"


def log(command: str, *lines: str) -> bytes:
    said = "".join(f"#6 1.2 {line}\n" for line in lines)
    end = f'process "/bin/sh -c {command}" did not complete: exit code: 1'
    return f"#6 [3/4] RUN {command}\n{said}#6 ERROR: {end}\n".encode()


KNOWN = log("catkin_make", HEADER.format("glog/logging.h"), MADE)
HELD = log("catkin_make", HEADER.format("zoo.h"), MADE)
CODE = log("catkin_make", f"{SOURCE}: error: expected ';' before '}}' token", MADE)
OTHER = log(
    "cmake .. && make",
    "/home/jovyan/arm/b.cpp:1:21: error: 'grip' was not declared in this scope",
    "make[1]: *** [CMakeFiles/Makefile2:148: CMakeFiles/arm_extra.dir/all] Error 2",
)
WHEEL = log("pip install -r a.txt", "Downloading fast-robot-2.0.tar.gz", "Failed to build fast-robot")
CASES = {
    "a table": (WORKSPACE, KNOWN, ["apt: [libgoogle-glog-dev]"], []),
    "apt": (WORKSPACE, HELD, ["apt: [libzoo-dev]"], []),
    "another Python": (PYTHON, WHEEL, ["base.python: 3.9"], []),
    "a package left out": (WORKSPACE, CODE, [], ["skip_packages: [arm_extra]"]),
    "a generated Dockerfile": (OWN, log("make", "a message that nobody knows"), [], ["dockerfile: false"]),
    "a program left out": (PROGRAM, OTHER, [], ["build_args: [arm_app]"]),
}


class Answers:
    """A stand-in of whom is asked, which keeps the questions."""

    def __init__(self) -> None:
        self.asked: list[str] = []

    def files(self, paths: Sequence[str]) -> str:
        self.asked.append("apt")
        return "1 libzoo-dev\n" if any("zoo" in path for path in paths) else ""

    def wheels(self, lines: Sequence[str]) -> str:
        self.asked.append("pip")
        return "fast-robot 3.9\n" if lines else ""

    @property
    def asking(self) -> Asking:
        return Asking(files=self.files, wheels=self.wheels)


def found_in(folder: Path, said: bytes, who: Asking, *, whole: bool = False, again: bool = False) -> Repair:
    return proposed(explain(io.BytesIO(said)), given(plan_repository(folder)), asking=who, whole=whole, again=again)


@pytest.mark.parametrize("case", CASES)
def test_each_comes_in_its_turn(tmp_path: Path, case: str) -> None:
    files, said, changes, left = CASES[case]
    who = Answers()
    tree_of(tmp_path / "robot", files)
    found = found_in(tmp_path / "robot", said, who.asking)
    assert ([str(change) for change in found.changes], [str(change) for change in found.left]) == (changes, left)
    assert who.asked == {"apt": ["apt"], "another Python": ["pip"]}.get(case, [])


@pytest.mark.parametrize("case", CASES)
def test_the_action_proposes_the_same_and_writes_nothing_that_leaves_out(tmp_path: Path, case: str) -> None:
    files, said, changes, left = CASES[case]
    tree_of(tmp_path / "robot", files)
    plan = plan_repository(tmp_path / "robot").plan
    run = Run(
        plan=plan, image="ghcr.io/o/robot", username="o", push=False, reason="", cache="none",
        config="roslab.yaml" if "roslab.yaml" in files else "",
    )  # fmt: skip
    mending = mend(explain(io.BytesIO(said)), run, tmp_path / "robot", Answers().asking)
    (problem,) = mending.problems
    hint = problem.hint or ""
    assert [change for change in (*changes, *left) if f"`{change}`" in hint] == [*changes, *left]
    assert ("It could be built " in hint) == bool(left)
    assert bool(mending.repairs) == bool(changes)
    assert mending.hunk is None or not left


def test_a_person_is_told_what_would_be_left_out_and_nothing_is_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tree_of(tmp_path / "robot", WORKSPACE)
    (tmp_path / "log").write_bytes(CODE)
    assert main(["explain", str(tmp_path / "log"), str(tmp_path / "robot")]) == 0
    said = capsys.readouterr().out
    assert "could be built without arm_extra, which does not compile: expected ';'" in said
    assert (
        "In roslab.yaml, if nothing that you start needs what is left out:\n  skip_packages:\n    - arm_extra" in said
    )
    assert main(["explain", str(tmp_path / "log"), str(tmp_path / "robot"), "--apply"]) == 5
    assert "without arm_extra, which does not compile" in capsys.readouterr().err
    assert (tmp_path / "robot" / "roslab.yaml").read_text() == WORKSPACE["roslab.yaml"]


@pytest.mark.parametrize(
    ("case", "line"),
    [
        ("apt", "--ask asks apt which package holds what is missing\n"),
        ("another Python", "--ask asks pip's index for which Python it has a wheel of fast-robot==2.0\n"),
        ("a table", ""),
    ],
)
def test_who_could_be_asked_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str], case: str, line: str) -> None:
    files, said, _, _ = CASES[case]
    tree_of(tmp_path / "robot", files)
    (tmp_path / "log").write_bytes(said)
    assert main(["explain", str(tmp_path / "log"), str(tmp_path / "robot")]) == 0
    out = capsys.readouterr().out
    assert out.endswith(line) if line else "--ask" not in out
    answer = explain(io.BytesIO(said))
    found = proposed(answer, given(plan_repository(tmp_path / "robot")))
    assert len(unasked(found, answer, given(plan_repository(tmp_path / "robot")))) == bool(line)


DOCKER = """\
#!/bin/bash
case "$*" in
  *Server.Version*) echo 27.1.0 ;;
  version*) echo linux/amd64 ;;
esac
for word in "$@"; do
  case "${word}" in
    type=local,dest=*) mkdir "${word#*dest=}" && echo "${ANSWER}" >"${word#*dest=}/answer" ;;
  esac
done
"""


@pytest.mark.parametrize(
    ("answer", "line"),
    [
        ("1 libzoo-dev", "adds apt: [libzoo-dev], for the header zoo.h (arm_extra/main.cpp:1)\n"),
        ("", "nothing to add: no package of the image's sources holds the header zoo.h (arm_extra/main.cpp:1)\n"),
    ],
)
def test_asked_the_engine_is_asked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], answer: str, line: str
) -> None:
    tree_of(tmp_path / "robot", WORKSPACE)
    (tmp_path / "log").write_bytes(HELD)
    (tmp_path / "docker").write_text(DOCKER)
    (tmp_path / "docker").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    monkeypatch.setenv("ANSWER", answer)
    assert main(["explain", str(tmp_path / "log"), str(tmp_path / "robot"), "--ask"]) == 0
    assert line in capsys.readouterr().out


def test_without_an_engine_nobody_can_be_asked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    tree_of(tmp_path / "robot", WORKSPACE)
    (tmp_path / "log").write_bytes(HELD)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert main(["explain", str(tmp_path / "log"), str(tmp_path / "robot"), "--ask"]) == 5
    assert "docker is not installed" in capsys.readouterr().err


def test_what_is_named_already_gives_nothing_up(tmp_path: Path) -> None:
    tree_of(tmp_path / "robot", WORKSPACE)
    assert found_in(tmp_path / "robot", CODE, Answers().asking, whole=True).left == ()


@pytest.mark.parametrize(
    "said",
    [
        b"",
        b"#5 [2/2] RUN make\n#5 DONE 1.0s\n#6 exporting to image\n#6 naming to a done\n#6 DONE 0.1s\n",
        b"Traceback (most recent call last):\nModuleNotFoundError: No module named 'zoo'\n",
    ],
    ids=["nothing", "a good build", "a run"],
)
def test_no_dockerfile_is_generated_where_no_build_failed(tmp_path: Path, said: bytes) -> None:
    tree_of(tmp_path / "robot", OWN)
    assert found_in(tmp_path / "robot", said, Answers().asking).left == ()


def test_one_is_generated_where_the_builder_cannot_read_the_authors(tmp_path: Path) -> None:
    tree_of(tmp_path / "robot", OWN)
    said = b"#1 [internal] load build definition from Dockerfile\n#1 DONE 0.0s\n"
    said += b"ERROR: failed to solve: dockerfile parse error on line 3: unknown instruction: RUUN\n"
    (change,) = found_in(tmp_path / "robot", said, Answers().asking).left
    assert str(change) == "dockerfile: false"


def test_what_did_not_help_is_not_proposed_again(tmp_path: Path) -> None:
    tree_of(tmp_path / "robot", WORKSPACE)
    found = found_in(tmp_path / "robot", KNOWN, Answers().asking, again=True)
    assert ([*found.changes], [str(change) for change in found.left]) == ([], ["skip_packages: [arm_extra]"])
