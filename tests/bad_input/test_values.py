"""Names and packages that carry shell or Dockerfile metacharacters: refused with their place, never interpolated."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

Roslab = Callable[..., CompletedProcess[str]]
EXAMPLES = Path(__file__).resolve().parent.parent.parent / "examples"
HOSTILE = (
    "x; touch owned", "$(touch owned)", "`touch owned`", "x && touch owned", "x|sh",
    "x\\\\\\nRUN touch owned", "--privileged", "x\\ny", "x'y", 'x\\"y', "${HOME}", "x#y", "x\\u2028y", "../../x",
)  # fmt: skip
"""As they stand inside a double-quoted YAML string."""


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    shutil.copytree(EXAMPLES / "python_filter", tmp_path / "robot")
    return tmp_path / "robot"


@pytest.mark.parametrize("value", HOSTILE)
@pytest.mark.parametrize("key", ["name", "apt", "base.image", "skip_keys", "platforms"])
def test_refused_in_the_configuration(roslab: Roslab, robot: Path, key: str, value: str) -> None:
    text = {
        "name": f'name: "{value}"\n',
        "apt": f'apt:\n  - git\n  - "{value}"\n',
        "base.image": f'base:\n  image: "{value}"\n',
        "skip_keys": f'skip_keys: ["{value}"]\n',
        "platforms": f'platforms: ["{value}"]\n',
    }[key]
    (robot / "roslab.yaml").write_text("format: 3\n" + text)
    answer = roslab("create", robot)
    assert answer.returncode == 2, answer.stdout
    assert answer.stderr.startswith(f"roslab.yaml:{4 if key == 'apt' else 3 if key == 'base.image' else 2}:")
    assert not (robot / "Dockerfile").exists()


@pytest.mark.parametrize(
    "value", ["x; touch owned", "$(touch owned)", "`touch owned`", "it's", 'a "b"', "$HOME", "a\\b", "#"]
)
def test_kept_as_text_where_any_text_is_right(roslab: Roslab, robot: Path, value: str) -> None:
    """The value of a variable may be anything on one line: it stands for itself."""
    (robot / "roslab.yaml").write_text(f"format: 3\nenv:\n  GREETING: {json.dumps(value)}\n")
    answer = roslab("create", robot)
    assert answer.returncode == 0, answer.stderr
    dockerfile = (robot / "Dockerfile").read_text()
    line = next(line for line in dockerfile.splitlines() if "GREETING=" in line)
    escaped = value.replace("\\", "\\\\").replace('"', '\\"').replace("$", "\\$")
    assert f'GREETING="{escaped}"' in line


@pytest.mark.parametrize("value", HOSTILE)
def test_hostile_manifest(roslab: Roslab, tmp_path: Path, value: str) -> None:
    """A package.xml is checked by nobody before it comes here: its names reach no command unquoted."""
    shutil.copytree(EXAMPLES / "ros1_talker", tmp_path / "robot")
    manifest = tmp_path / "robot" / "package.xml"
    plain = json.loads(f'"{value}"').replace("&", "&amp;")
    text = manifest.read_text().replace("<depend>roscpp</depend>", f"<depend>{plain}</depend><depend>roscpp</depend>")
    manifest.write_text(text.replace("<name>ros1_talker</name>", f"<name>{plain}</name>"))
    answer = roslab("create", tmp_path / "robot")
    assert answer.returncode in (0, 2), answer.stderr
    for file in ("Dockerfile", "docker_build.sh", "docker_run.sh"):
        if (tmp_path / "robot" / file).exists():
            assert "touch owned" not in (tmp_path / "robot" / file).read_text()


@pytest.mark.parametrize(
    "value", ["numpy; touch owned", "numpy $(touch owned)", "-e ../../x`touch owned`", "--index-url=$(touch owned)"]
)
def test_hostile_requirements(roslab: Roslab, robot: Path, value: str) -> None:
    (robot / "requirements.txt").write_text(f"{value}\nmatplotlib\n")
    answer = roslab("create", robot)
    assert answer.returncode in (0, 2), answer.stderr
    if answer.returncode == 0:
        commands = (robot / "Dockerfile").read_text()
        assert "touch owned" not in commands or f"'{value}'" in commands


def test_folder_with_capitals(roslab: Roslab, tmp_path: Path) -> None:
    shutil.copytree(EXAMPLES / "python_filter", tmp_path / "My Kalman_Filter (v2)")
    answer = roslab("plan", tmp_path / "My Kalman_Filter (v2)")
    assert json.loads(answer.stdout)["name"] == "my-kalman_filter-v2"


def test_name_with_capitals(roslab: Roslab, robot: Path) -> None:
    (robot / "roslab.yaml").write_text("format: 3\nname: MyRobot\n")
    answer = roslab("inspect", robot, "--format", "json")
    assert answer.returncode == 0, answer.stderr
    assert [warning["message"] for warning in json.loads(answer.stdout)["warnings"]] == [
        "image names are in lower case: `MyRobot` becomes `myrobot`"
    ]
    assert json.loads(roslab("plan", robot).stdout)["name"] == "myrobot"


@pytest.mark.parametrize("name", ["my robot", "../robot", "robot:latest", "", "-x", "$(id)"])
def test_name_on_the_command_line(roslab: Roslab, robot: Path, name: str) -> None:
    answer = roslab("plan", robot, f"--name={name}")
    assert answer.returncode == 2
    assert answer.stderr.startswith(f'roslab: error: --name: "{name}" is no image name\n')


def test_name_with_capitals_on_the_command_line(roslab: Roslab, robot: Path) -> None:
    answer = roslab("inspect", robot, "--name", "MyRobot", "--format", "json")
    assert answer.returncode == 0, answer.stderr
    assert json.loads(answer.stdout)["warnings"] == [
        {"message": "--name: image names are in lower case: `MyRobot` becomes `myrobot`", "file": None, "line": None}
    ]


def test_paths_that_are_not_there(roslab: Roslab, robot: Path) -> None:
    """All at once, each with its place."""
    text = "format: 3\ndockerfile: docker/Dockerfile\nrequirements: [requirements.txt, more.txt]\ncontext: kalmann\n"
    (robot / "roslab.yaml").write_text(text)
    answer = roslab("plan", robot)
    assert answer.returncode == 2
    assert [line for line in answer.stderr.splitlines() if "error" in line] == [
        "roslab.yaml:2:1: error: dockerfile: docker/Dockerfile is not there",
        "roslab.yaml:3:34: error: requirements: more.txt is not there",
        "roslab.yaml:4:1: error: context: kalmann is not there",
    ]


def test_configuration_that_is_not_there(roslab: Roslab, robot: Path) -> None:
    answer = roslab("plan", robot, "--config", "rosalb.yaml")
    assert answer.returncode == 2
    assert answer.stderr == (
        "roslab: error: --config: no file rosalb.yaml in the repository\n  give a path relative to its root\n"
    )


@pytest.mark.parametrize("name", ["/etc/passwd", "../roslab.yaml", "kalman"])
def test_configuration_outside(roslab: Roslab, robot: Path, name: str) -> None:
    (robot.parent / "roslab.yaml").write_text("format: 3\n")
    answer = roslab("plan", robot, "--config", name)
    assert answer.returncode == 2
    assert answer.stderr.startswith(f"roslab: error: --config: no file {name} in the repository\n")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--platform", "linux/amd65"], "linux/amd65"),
        (["--platform", "windows"], "windows"),
        (["--platform", "linux/amd64,$(id)"], "$(id)"),
        (["--platform", " , "], "--platform: it is empty"),
        (["--command", "a\nb"], '--command: "a\\nb" is no shell command'),
        (["--test", "a\x01b"], "--test: the character U+0001 is not allowed"),
    ],
)
def test_options(roslab: Roslab, robot: Path, arguments: list[str], message: str) -> None:
    answer = roslab("create", robot, *arguments)
    assert answer.returncode == 2, answer.stdout
    assert message in answer.stderr


def test_unknown_command(roslab: Roslab) -> None:
    answer = roslab("biuld")
    assert answer.returncode == 2
    assert "invalid choice: 'biuld'" in answer.stderr


@pytest.mark.parametrize("value", ["novalue", "1A=x", "A B=x", "=x"])
def test_build_arguments(roslab: Roslab, robot: Path, value: str) -> None:
    answer = roslab("build", robot, "--build-arg", value)
    assert answer.returncode == 2
    assert answer.stderr == f"roslab: error: --build-arg: {value!r} is not NAME=VALUE\n"


def test_explain_a_log_that_is_not_there(roslab: Roslab, tmp_path: Path) -> None:
    answer = roslab("explain", "build.log", cwd=tmp_path)
    assert answer.returncode == 2
    error, advice = answer.stderr.splitlines()
    assert error == "roslab: error: cannot read build.log: No such file or directory"
    assert "comes first" in advice


def test_unknown_question(roslab: Roslab, robot: Path) -> None:
    answer = roslab("inspect", robot, "--explain", "colour")
    assert answer.returncode == 2
    assert answer.stderr.startswith("roslab: error: no question 'colour' here\n  one of: ")
    assert "base_image" in answer.stderr


@pytest.mark.parametrize(
    ("tag", "instead"), [("robot:1", "give --tag 1"), ("lab/robot", ""), (".1", ""), ("", ""), ("x; touch owned", "")]
)
@pytest.mark.parametrize("command", ["build", "run", "lock"])
def test_what_is_no_tag_is_refused_before_anything_is_built(
    roslab: Roslab, robot: Path, command: str, tag: str, instead: str
) -> None:
    answer = roslab(command, robot, f"--tag={tag}")
    assert answer.returncode == 2, answer.stdout
    assert f"argument --tag: {tag!r} is no tag" in answer.stderr
    assert instead in answer.stderr


@pytest.mark.parametrize("begin", [b"PK\x03\x04\x14\x00", b"\x1f\x8b\x08\x00", b"\xfd7zXZ\x00\x00"])
def test_explain_a_log_that_is_packed(roslab: Roslab, tmp_path: Path, begin: bytes) -> None:
    """GitHub's page gives the logs of a run as a zip: its bytes are no lines that matter."""
    (tmp_path / "logs").write_bytes(begin + bytes(range(256)) * 20)
    answer = roslab("explain", "logs", cwd=tmp_path)
    assert answer.returncode == 2
    assert answer.stderr.startswith("roslab: error: logs is packed (")
    assert answer.stdout == ""


def test_an_option_that_a_command_has_not_shows_what_the_command_takes(roslab: Roslab, robot: Path) -> None:
    answer = roslab("migrate", "--format", "json", robot)
    assert answer.returncode == 2
    assert answer.stderr.startswith("usage: roslab migrate ")
    assert "roslab migrate: error: unrecognized arguments: --format" in answer.stderr
