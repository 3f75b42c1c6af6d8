"""An author's Dockerfile on a base that has ended builds without a line changed: on a laptop, and by the action."""

from __future__ import annotations

import gzip
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from lab import caller, doors
from lab.act import run_workflow
from lab.home import CHECKOUT
from lab.laboratory import Laboratory
from lab.old_world import Signer, deb, release, serving

SNAPSHOT = "http://snapshots.ros.org/kinetic/final/ubuntu"
ROSDISTRO = "http://raw.githubusercontent.com/ros/rosdistro"
TAG = "kinetic/2021-05-11"
INDEX = """\
%YAML 1.1
---
distributions:
  kinetic:
    distribution: [kinetic/distribution.yaml]
    distribution_cache: {cache}
    distribution_status: end-of-life
    distribution_type: ros1
    python_version: 2
type: index
version: 4
"""
DISTRIBUTION = """\
%YAML 1.1
---
release_platforms: {debian: [bookworm], ubuntu: [xenial]}
repositories:
  pose:
    release: {tags: {release: "release/{package}/{version}"}, url: "http://example.org/pose.git", version: 1.0.0-0}
type: distribution
version: 2
"""
APT = """\
FROM {base}
RUN apt-get update && apt-get install -y ros-kinetic-pose robot-tool
COPY . /source
"""
ROSDEP = """\
FROM {base}
RUN rm -f /etc/ros/rosdep/sources.list.d/*.list && rosdep init && rosdep update
COPY . /source
RUN apt-get update && rosdep install -y --rosdistro kinetic --from-paths /source --ignore-src
"""
STAGES = """\
FROM {base} AS build
RUN apt-get update && apt-get install -y ros-kinetic-pose
FROM {base}
RUN apt-get update && apt-get install -y robot-tool
COPY --from=build /usr/share/ros-kinetic-pose /usr/share/
COPY . /source
"""
KINDS = {"apt": APT, "rosdep": ROSDEP, "stages": STAGES}
PACKAGE = """\
<package format="2">
  <name>robot</name><version>1.0.0</version><description>x</description>
  <maintainer email="a@example.org">a</maintainer><license>MIT</license>
  <buildtool_depend>catkin</buildtool_depend><depend>pose</depend><depend>robot_tool</depend>
</package>
"""
CONFIG = "format: 3\nname: lab-mended\nkind: ros1\nbase: {ros: kinetic}\ndockerfile: Dockerfile\ntest: TEST\n"
TEST = "cat /usr/share/ros-kinetic-pose /usr/share/robot-tool"


@pytest.fixture(scope="module")
def keys(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Signer]:
    """Return the keys: of Ubuntu, of ROS as it expired, of ROS's snapshots."""
    folder = tmp_path_factory.mktemp("keys")
    return {name: Signer.make(folder / name, expired=name == "ros") for name in ("ubuntu", "ros", "snapshots")}


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
    put(SNAPSHOT, "snapshots", "ros-kinetic-pose", "ros-kinetic-catkin")
    cache = f"{ROSDISTRO}/kinetic-cache.yaml.gz"
    known = {"robot_tool": {"debian": ["robot-tool"], "ubuntu": ["robot-tool"]}, "catkin": {"debian": [], "ubuntu": []}}
    for ref, table in (("master", {}), (TAG, known)):
        files[f"{ROSDISTRO}/{ref}/index-v4.yaml"] = INDEX.format(cache=cache).encode()
        files[f"{ROSDISTRO}/{ref}/kinetic/distribution.yaml"] = DISTRIBUTION.encode()
        lines = "".join(f"{key}: {value}\n" for key, value in table.items()) or "other: {debian: [other]}\n"
        files[f"{ROSDISTRO}/{ref}/rosdep/base.yaml"] = lines.encode()
    listed = f"yaml {ROSDISTRO}/master/rosdep/base.yaml\n"
    files[f"{ROSDISTRO}/master/rosdep/sources.list.d/20-default.list"] = listed.encode()
    files[cache] = gzip.compress(
        f"distribution_file:\n- {DISTRIBUTION.partition('---')[2].strip().replace(chr(10), chr(10) + '  ')}\n"
        "name: kinetic\nrelease_package_xmls: {}\nsource_repo_package_xmls: {}\ntype: cache\nversion: 3\n".encode()
    )
    with serving(files) as address:
        yield address


@pytest.fixture(scope="module")
def program(keys: dict[str, Signer], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a copy of the project with the lab's keys and addresses, for nobody here can sign as ROS does."""
    place = tmp_path_factory.mktemp("program") / "checkout"
    hidden = shutil.ignore_patterns(".git", ".*cache", "__pycache__", "tests", "benchmarks")
    shutil.copytree(CHECKOUT, place, ignore=hidden)
    knowledge = place / "scripts/roslab/knowledge"
    (knowledge / "keys/ros-snapshots.asc").write_bytes(keys["snapshots"].public(armour=True))
    bases = place / "scripts/roslab/render/bases.py"
    text = bases.read_text()
    assert text.count("https://raw.githubusercontent.com/ros/rosdistro") == 1
    bases.write_text(text.replace("https://raw.githubusercontent.com", "http://raw.githubusercontent.com"))
    return place


@pytest.fixture
def builder(lab: Laboratory, tmp_path: Path) -> dict[str, str]:
    """Return an environment whose buildx uses the lab's BuildKit, which reaches this machine's servers."""
    environment = {**lab.environment, "BUILDX_CONFIG": str(tmp_path / "buildx"), "BUILDX_BUILDER": "lab-mended"}
    create = ["docker", "buildx", "create", "--name", "lab-mended", "--driver", "remote", lab.buildkit]
    subprocess.run(create, env=environment, check=True, capture_output=True)
    return environment


@pytest.fixture
def base(lab: Laboratory, tmp_path: Path, keys: dict[str, Signer], proxy: str) -> str:
    """Push a base as such an image is today: a mirror that lacks its release, an expired key, rosdep's own tables."""
    files = {
        "apt/sources.list": "deb http://archive.ubuntu.com/ubuntu/ xenial main\n",
        "apt/sources.list.d/ros1-latest.list": "deb [signed-by=/usr/share/keyrings/ros.gpg] "
        "http://packages.ros.org/ros/ubuntu xenial main\n",
        "apt/apt.conf.d/zz-lab": f'Acquire::http::Proxy "{proxy}";\nAcquire::Retries "0";\n',
        "Dockerfile": "FROM ros:kinetic-ros-base\n"
        "RUN rm -rf /etc/apt/sources.list /etc/apt/sources.list.d /var/lib/apt/lists/* /root/.ros\n"
        "COPY apt/ /etc/apt/\nCOPY ubuntu.gpg /etc/apt/trusted.gpg.d/\nCOPY ros.gpg /usr/share/keyrings/\n"
        f"ENV http_proxy={proxy} ROSDISTRO_INDEX_URL={ROSDISTRO}/master/index-v4.yaml \\\n"
        f"    ROSDEP_SOURCE={ROSDISTRO}/master/rosdep/sources.list.d/20-default.list\n"
        # What `rosdep init` would fetch by https
        "RUN sed -i 's#https://raw.githubusercontent.com#http://raw.githubusercontent.com#' "
        "/usr/lib/python3/dist-packages/rosdep2/sources_list.py\n",
    }
    place = doors.write(tmp_path / "base", files)
    (place / "ubuntu.gpg").write_bytes(keys["ubuntu"].public(armour=False))
    (place / "ros.gpg").write_bytes(keys["ros"].public(armour=False))
    name = f"repro-lab/ros:kinetic-{tmp_path.name.replace('_', '-').lower()}"
    pushed = f"{lab.mirror}/{name}"
    environment = dict(lab.environment)
    subprocess.run(["docker", "build", "--tag", pushed, place], env=environment, check=True, capture_output=True)
    subprocess.run(["docker", "push", pushed], env=environment, check=True, capture_output=True)
    subprocess.run(["docker", "image", "rm", pushed], env=environment, check=True, capture_output=True)
    return name


def tree(folder: Path, kind: str, base: str, more: str = "") -> Path:
    config = CONFIG.replace("TEST", TEST) + more
    return doors.write(
        folder, {"Dockerfile": KINDS[kind].format(base=base), "package.xml": PACKAGE, "roslab.yaml": config}
    )


def build(program: Path, place: Path, environment: dict[str, str], *words: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-I", str(program / "scripts"), "build", str(place), "--tag", "lab", *words]
    return subprocess.run(
        command, env={**os.environ, **environment}, capture_output=True, text=True, timeout=1800, check=False
    )


@pytest.mark.parametrize("kind", KINDS)
def test_on_a_laptop(program: Path, builder: dict[str, str], base: str, tmp_path: Path, kind: str) -> None:
    place = tree(tmp_path / "robot", kind, base)
    before = (place / "Dockerfile").read_bytes()
    refused = build(program, tree(tmp_path / "kept", kind, base, "repair: false\n"), builder)
    assert refused.returncode == 5, refused.stderr[-6000:]
    built = build(program, place, builder)
    assert built.returncode == 0, built.stderr[-8000:]
    assert f"{base} is replaced, by base-1 of Dockerfile.bases" in built.stderr
    assert (place / "Dockerfile").read_bytes() == before
    subprocess.run(["docker", "image", "rm", "lab-mended:lab"], env=builder, check=True, capture_output=True)


@pytest.fixture
def action(program: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Have act take that copy for the action."""
    monkeypatch.setattr(caller, "CHECKOUT", program)


@pytest.mark.usefixtures("action")
@pytest.mark.parametrize("kind", KINDS)
def test_by_the_action(lab: Laboratory, base: str, tmp_path: Path, kind: str) -> None:
    repository = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    place = tree(tmp_path / "robot", kind, base, "platforms: [linux/amd64]\n")
    files = {path.name: path.read_text() for path in place.iterdir()}
    through = doors.through_action(tmp_path / "caller", {"registry": lab.registry}, files, base={})
    ran = run_workflow(lab, through, "push", doors.payload(repository), env=doors.builder(lab))
    assert ran.exit_code == 0, ran.log[-8000:]
    assert f"{base} is replaced, by base-1 of Dockerfile.bases" in ran.log
    assert f"the build replaces {base} and changes no line of the Dockerfile" in ran.summary.replace("\\", "")
    assert ran.output("digest").startswith("sha256:")
