"""The repairs of ``roslab build``, with a stand-in of docker that answers what apt is asked."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.cli.arguments import parser
from roslab.cli.planning import planned_of
from roslab.cli.repairing import Repairing
from roslab.engine.docker import FailedBuild, why

DOCKER = """\
#!/bin/bash
if [ "$1" = version ]; then
  echo linux/amd64
  exit
fi
echo "$*" >>"${0%/*}/called"
for word in "$@"; do
  case "${word}" in
    */Dockerfile) cat "${word}" >>"${0%/*}/called" ;;
    type=local,dest=*) mkdir "${word#*dest=}" && echo 1 libzoo-dev >"${word#*dest=}/answer" ;;
  esac
done
"""


def failed(line: str) -> FailedBuild:
    said = 'process "/bin/sh -c make" did not complete: exit code: 1'
    log = f"#6 [3/4] RUN make\n#6 1.2 {line}\n#6 ERROR: {said}\n"
    return FailedBuild(*why(log), log=log)


@pytest.fixture
def repairing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Repairing:
    robot = tmp_path / "robot"
    robot.mkdir()
    (robot / "roslab.yaml").write_text("format: 3\nkind: cpp\nsecrets: [apt_auth]\n")
    (robot / "CMakeLists.txt").write_text("project(robot CXX)\nadd_executable(robot main.cpp)\n")
    (robot / "main.cpp").write_text("int main() {}\n")
    (tmp_path / "docker").write_text(DOCKER)
    (tmp_path / "docker").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    monkeypatch.setenv("APT_AUTH", "machine packages.example login a password b")
    options = parser("build").parse_args(["build", str(robot)])
    return Repairing(options=options, planned=planned_of(options), arguments=(("HTTP_PROXY", "http://proxy.example"),))


def test_apt_is_asked_with_the_secrets_and_the_arguments_of_the_build(repairing: Repairing, tmp_path: Path) -> None:
    repairing.repair(failed("/home/a/main.cpp:1:10: fatal error: zoo.h: No such file or directory"))
    assert [str(change) for change in repairing.changes] == ["apt: [libzoo-dev]"]
    called = (tmp_path / "called").read_text()
    assert " --secret id=apt_auth,env=APT_AUTH " in called
    assert " --build-arg HTTP_PROXY=http://proxy.example " in called
    asked = called.rpartition("ARG ASKED\n")[2]
    assert asked.startswith("RUN --mount=type=secret,id=apt_auth,required=true,target=/etc/apt/auth.conf.d/")
    assert "packages-holding /asked >/answer" in asked


def test_a_failure_says_once_how_it_is_corrected(repairing: Repairing) -> None:
    error = failed("write /usr/lib/a.so: No space left on device")
    with pytest.raises(FailedBuild) as raised:
        repairing.repair(error)
    assert raised.value.problems == error.problems


NODE = "project({0})\nfind_package(catkin REQUIRED)\ncatkin_package()\nadd_executable({0}_node main.cpp)\n"
XML = (
    '<package format="2"><name>{0}</name><version>1.0.0</version><buildtool_depend>catkin</buildtool_depend></package>'
)


@pytest.fixture
def workspace(repairing: Repairing, tmp_path: Path) -> Repairing:
    """Return the same for a workspace of four packages, of which the page starts one."""
    robot = tmp_path / "robot"
    (robot / "roslab.yaml").write_text("format: 3\nbase: {ros: noetic}\n")
    (robot / "CMakeLists.txt").unlink()
    (robot / "README.md").write_text("```\nrosrun arm_demo arm_demo_node\n```\n")
    for name in ("arm_demo", "arm_one", "arm_two", "arm_three"):
        (robot / name).mkdir()
        (robot / name / "CMakeLists.txt").write_text(NODE.format(name))
        (robot / name / "package.xml").write_text(XML.format(name))
        (robot / name / "main.cpp").write_text("int main() {}\n")
    repairing.planned = planned_of(repairing.options)
    return repairing


def stopped(package: str, line: str) -> FailedBuild:
    said = 'process "/bin/sh -c catkin_make" did not complete: exit code: 1'
    where = f"/home/jovyan/ws/src/robot/{package}/main.cpp:1:2"
    made = f"make[2]: *** [robot/{package}/CMakeFiles/x.dir/build.make:7: x.o] Error 1"
    log = f"#6 [3/4] RUN catkin_make\n#6 1.2 {where}: {line}\n#6 1.2 {made}\n#6 ERROR: {said}\n"
    return FailedBuild(*why(log), log=log)


def test_each_round_leaves_out_what_failed_in_it(workspace: Repairing, capsys: pytest.CaptureFixture[str]) -> None:
    for package in ("arm_one", "arm_two"):
        workspace.repair(stopped(package, "error: expected ';' before '}' token"))
    assert workspace.planned.decision.left_out == ("arm_one", "arm_two")
    said = capsys.readouterr().err
    assert "roslab: repair 1 leaves out arm_one, which does not compile: expected ';' before '}' token at" in said
    assert "roslab: repair 2 leaves out arm_two, which " in said
    with pytest.raises(FailedBuild) as raised:
        workspace.repair(stopped("arm_demo", "error: expected ';' before '}' token"))
    why = "not repaired: arm_demo does not compile, and the command needs arm_demo"
    assert [str(problem) for problem in raised.value.problems[1:]] == [why]


def test_an_image_that_has_its_name_gives_no_package_up_for_its_command(workspace: Repairing) -> None:
    workspace.kept = ()
    with pytest.raises(FailedBuild):
        workspace.repair(stopped("arm_one", "error: expected ';' before '}' token"))
    assert workspace.changes == []


def test_what_did_not_help_is_taken_back(workspace: Repairing) -> None:
    missing = "fatal error: glog/logging.h: No such file or directory"
    workspace.repair(stopped("arm_one", missing))
    assert [str(change) for change in workspace.changes] == ["apt: [libgoogle-glog-dev]"]
    workspace.repair(stopped("arm_one", missing))
    assert [str(change) for change in workspace.changes] == ["skip_packages: [arm_one]"]
    assert "libgoogle-glog-dev" not in workspace.planned.plan.apt


def test_a_configuration_of_an_old_format_is_no_error_of_its_own(repairing: Repairing, tmp_path: Path) -> None:
    (tmp_path / "robot" / "roslab.yaml").write_text("base: {ubuntu: focal}\napt: [git]\n")
    repairing.planned = planned_of(repairing.options)
    error = failed("/home/a/main.cpp:1:10: fatal error: zoo.h: No such file or directory")
    with pytest.raises(FailedBuild) as raised:
        repairing.repair(error)
    first, second = raised.value.problems
    assert first == error.problems[0]
    assert str(second).startswith("not repaired: it needs apt: [libzoo-dev], for the header zoo.h (main.cpp:1), which ")
    assert "roslab migrate --write" in str(second)
    assert not repairing.changes


def test_a_platform_that_is_not_built_is_not_asked(repairing: Repairing, tmp_path: Path) -> None:
    repairing.options.platforms = "linux/arm64"
    repairing.planned = planned_of(repairing.options)
    repairing.repair(failed("/home/a/main.cpp:1:10: fatal error: zoo.h: No such file or directory"))
    assert " --platform linux/arm64 " in (tmp_path / "called").read_text()


def test_what_the_build_left_out_itself_is_not_added(repairing: Repairing, tmp_path: Path) -> None:
    (tmp_path / "docker").write_text("#!/bin/sh\nexit 1\n")
    line = "/home/a/main.cpp:1:10: fatal error: glog/logging.h: No such file or directory"
    error = failed(f"{line}\n#5 1.0 roslab: left out: apt libgoogle-glog-dev")
    with pytest.raises(FailedBuild) as raised:
        repairing.repair(error)
    assert not repairing.changes
    assert "not repaired" in raised.value.problems[-1].message


@pytest.mark.parametrize("said", ["E: Unable to locate package {}", "E: Package '{}' has no installation candidate"])
def test_what_was_added_and_apt_does_not_have_leaves_the_first_failure(repairing: Repairing, said: str) -> None:
    first = failed("/home/a/main.cpp:1:10: fatal error: zoo.h: No such file or directory")
    repairing.repair(first)
    with pytest.raises(FailedBuild) as raised:
        repairing.repair(failed(said.format("libzoo-dev")))
    assert raised.value.log == first.log
    assert "it needs libzoo-dev, which apt does not have here" in raised.value.problems[-1].message


@pytest.fixture
def authored(repairing: Repairing, tmp_path: Path) -> Repairing:
    """Return the same for a tree whose own Dockerfile is built."""
    robot = tmp_path / "robot"
    (robot / "roslab.yaml").unlink()
    (robot / "Dockerfile").write_text("FROM ubuntu:20.04\nCOPY . /src\nRUN make\n")
    repairing.planned = planned_of(repairing.options)
    assert repairing.planned.plan.author_dockerfile
    return repairing


def test_a_dockerfile_of_the_tree_that_does_not_build_is_generated(
    authored: Repairing, capsys: pytest.CaptureFixture[str]
) -> None:
    missing = "/src/main.cpp:1:10: fatal error: glog/logging.h: No such file or directory"
    authored.repair(failed(missing))
    assert authored.planned.plan.author_dockerfile is None
    said = capsys.readouterr().err
    assert "roslab: repair 1 generates a Dockerfile: Dockerfile does not build: " in said
    assert "; this repairs it:\n" in said
    assert "+RUN apt-get update" in said
    authored.repair(failed(missing))
    assert [str(change) for change in authored.changes] == ["dockerfile: false", "apt: [libgoogle-glog-dev]"], (
        "the same cause is repaired in the generated one"
    )
    with pytest.raises(FailedBuild):
        authored.repair(failed(missing))
    assert authored.planned.plan.author_dockerfile is None


def test_a_dockerfile_that_is_named_is_built_as_it_is(authored: Repairing, tmp_path: Path) -> None:
    (tmp_path / "robot" / "roslab.yaml").write_text("format: 3\ndockerfile: Dockerfile\n")
    authored.planned = planned_of(authored.options)
    with pytest.raises(FailedBuild) as raised:
        authored.repair(failed("some program: a message that nobody knows"))
    said = str(raised.value.problems[-1])
    assert said == "not repaired: the image is built from Dockerfile, and no line is certain to repair it"
    assert authored.changes == []


def test_no_dockerfile_is_generated_for_what_the_machine_lacks(authored: Repairing) -> None:
    with pytest.raises(FailedBuild):
        authored.repair(failed("write /usr/lib/a.so: No space left on device"))
    assert authored.changes == []
