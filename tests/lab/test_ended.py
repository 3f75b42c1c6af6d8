"""A base that has ended: expired keys, a mirror that lacks it, a source that is gone; its image still builds."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from roslab.knowledge.keys import key
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

from .doors import write
from .laboratory import Laboratory
from .old_world import Signer, deb, release, serving

SNAPSHOT = "http://snapshots.ros.org/kinetic/final/ubuntu"
PACKAGE = """\
<package format="2">
  <name>robot</name><version>1.0.0</version><description>x</description>
  <maintainer email="a@example.org">a</maintainer><license>MIT</license>
  <buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend>
</package>
"""
REPOSITORY = {
    "package.xml": PACKAGE,
    "CMakeLists.txt": "cmake_minimum_required(VERSION 2.8.3)\nproject(robot)\nfind_package(catkin REQUIRED)\n"
    "catkin_package()\n",
    "roslab.yaml": "format: 3\nbase: {ros: kinetic-ros-base}\napt: [ros-kinetic-pose, robot-tool]\n",
}
LISTS = {
    "one-line": {
        "sources.list": "deb http://archive.ubuntu.com/ubuntu/ xenial main\n"
        "deb http://security.ubuntu.com/ubuntu xenial-security main\n",
        "sources.list.d/ros1-latest.list": "deb [signed-by=/usr/share/keyrings/ros.gpg] "
        "http://packages.ros.org/ros/ubuntu xenial main\n",
        "sources.list.d/gone.list": "deb http://gone.example.org/packages ./\n",
        "sources.list.d/kept.list": "deb http://kept.example.org/packages xenial main\n",
    },
    "stanzas": {
        "sources.list.d/ubuntu.sources": "Types: deb\nURIs: http://archive.ubuntu.com/ubuntu/\n"
        "Suites: xenial xenial-updates\nComponents: main\n",
        "sources.list.d/ros.sources": "Types: deb\nURIs: http://packages.ros.org/ros/ubuntu\nSuites: xenial\n"
        "Components: main\nSigned-By: /usr/share/keyrings/ros.gpg\n",
        "sources.list.d/gone.sources": "Types: deb\nURIs: http://gone.example.org/packages\nSuites: xenial\n"
        "Components: main\n",
        "sources.list.d/kept.list": "deb http://kept.example.org/packages xenial main\n",
    },
}
"""What the base names: the archive's old places, ROS's own source, one that is gone, one that answers."""


@pytest.fixture(scope="module")
def keys(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Signer]:
    """Return the keys: of Ubuntu, of ROS as it expired, of ROS's snapshots."""
    folder = tmp_path_factory.mktemp("keys")
    names = ("ubuntu", "ros", "snapshots")
    return {name: Signer.make(folder / name, expired=name == "ros") for name in names}


@pytest.fixture(scope="module")
def proxy(keys: dict[str, Signer], tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Serve the world as it is after the end: yields the address that stands before all of it."""
    folder = tmp_path_factory.mktemp("debs")
    files: dict[str, bytes] = {}

    def put(url: str, signer: str, *names: str) -> None:
        suite = release(keys[signer], "xenial", {name: deb(name, folder) for name in names})
        files.update({f"{url}/{path}": data for path, data in suite.items()})

    put("http://old-releases.ubuntu.com/ubuntu", "ubuntu", "robot-tool")
    put("http://packages.ros.org/ros/ubuntu", "ros")
    put(SNAPSHOT, "snapshots", "ros-kinetic-pose", "ros-kinetic-catkin", "ros-kinetic-roscpp")
    put("http://kept.example.org/packages", "ubuntu", "kept-tool")
    with serving(files) as address:
        yield address


def base(lab: Laboratory, folder: Path, lists: Mapping[str, str], keys: dict[str, Signer], proxy: str) -> str:
    """Make a base as such an image is today; its ROS is the stand-in's."""
    name = f"repro-lab/ended-{folder.name.replace('_', '-').lower()}:base"
    files = {**{f"apt/{path}": text for path, text in lists.items()}}
    files["apt/apt.conf.d/zz-lab"] = f'Acquire::http::Proxy "{proxy}";\nAcquire::Retries "0";\n'
    place = write(folder / "base", files)
    (place / "ubuntu.gpg").write_bytes(keys["ubuntu"].public(armour=False))
    (place / "ros.gpg").write_bytes(keys["ros"].public(armour=False))
    (place / "Dockerfile").write_text(
        "FROM ros:kinetic-ros-base\nRUN rm -rf /etc/apt/sources.list /etc/apt/sources.list.d /var/lib/apt/lists/*\n"
        "COPY apt/ /etc/apt/\nCOPY ubuntu.gpg /etc/apt/trusted.gpg.d/\nCOPY ros.gpg /usr/share/keyrings/\n"
    )
    docker(lab, "build", "--tag", name, ".", cwd=place)
    return name


def docker(lab: Laboratory, *arguments: str, cwd: Path, succeeds: bool = True) -> str:
    """Run docker; return all it said."""
    command = ["docker", *arguments]
    answer = subprocess.run(
        command, env=dict(lab.environment), cwd=cwd, capture_output=True, text=True, timeout=1800, check=False
    )
    said = answer.stdout + answer.stderr
    assert (answer.returncode == 0) == succeeds, said[-6000:]
    return said


def generated(folder: Path, name: str, keys: dict[str, Signer]) -> str:
    """Return the Dockerfile of the repository, on the base, with the lab's key in the place of ROS's."""
    text = dockerfile(plan_repository(folder).plan)
    assert len(re.findall(r"^FROM ros:kinetic-ros-base(?: AS \w+)?$", text, re.MULTILINE)) == 1
    real, own = key("ros-snapshots"), keys["snapshots"].public(armour=True).decode()
    assert text.count(real.rstrip()) == 1, "nobody here can sign as ROS's snapshots do"
    return text.replace("FROM ros:kinetic-ros-base", f"FROM {name}").replace(real.rstrip(), own.rstrip())


@pytest.mark.parametrize("form", LISTS)
def test_the_image_of_an_ended_base_builds(
    lab: Laboratory, tmp_path: Path, keys: dict[str, Signer], proxy: str, form: str
) -> None:
    name = base(lab, tmp_path, LISTS[form], keys, proxy)
    place = write(tmp_path / "robot", REPOSITORY)
    (place / "Dockerfile").write_text(generated(place, name, keys))
    image = name.replace(":base", ":image")
    said = docker(lab, "build", "--network", "host", "--progress", "plain", "--tag", image, ".", cwd=place)
    assert "roslab: this release is taken from its archive" in said
    test = (
        "cat /usr/share/ros-kinetic-pose /usr/share/robot-tool; cat /usr/local/share/roslab/left-out.txt; "
        "grep -rhE 'kept|gone|old-releases|snapshots' /etc/apt/sources.list* | sort"
    )
    seen = docker(lab, "run", "--rm", image, "bash", "-c", test, cwd=place)
    assert "ros-kinetic-pose" in seen
    assert "source http://gone.example.org/packages" in seen
    assert f"deb [signed-by=/usr/share/keyrings/roslab-ros-snapshots.gpg] {SNAPSHOT} xenial main" in seen
    assert "\ndeb http://kept.example.org/packages xenial main" in seen, "a source that answers is kept"
    assert "old-releases.ubuntu.com/ubuntu" in seen
    docker(lab, "image", "rm", "--force", image, name, cwd=place)


def test_without_that_step_it_does_not_build(
    lab: Laboratory, tmp_path: Path, keys: dict[str, Signer], proxy: str
) -> None:
    name = base(lab, tmp_path, LISTS["one-line"], keys, proxy)
    place = write(tmp_path / "robot", REPOSITORY)
    lines = generated(place, name, keys).splitlines(keepends=True)
    (step,) = [number for number, line in enumerate(lines) if line.startswith(" && renew-package-sources ")]
    assert lines[step - 1] == "    create-user \\\n"
    (place / "Dockerfile").write_text("".join([*lines[: step - 1], "    create-user\n", *lines[step + 1 :]]))
    command = ["build", "--network", "host", "--progress", "plain", "--tag", "repro-lab/never:image", "."]
    said = docker(lab, *command, cwd=place, succeeds=False)
    assert "EXPKEYSIG" in said
    assert "does not have a Release file" in said
    docker(lab, "image", "rm", "--force", name, cwd=place)
