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
