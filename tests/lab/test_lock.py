"""A lock holds while the repositories move on, and what it holds no more is named before the build."""

from __future__ import annotations

import json
import subprocess
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from subprocess import CompletedProcess
from typing import Any

import pytest

from roslab.github import locking
from roslab.knowledge.tools import NEWEST
from roslab.plan.lock import digest

from . import doors, registry
from .act import Result, run_workflow
from .doors import write
from .kept_artifacts import artifacts
from .laboratory import Laboratory
from .moving import World, moving_world
from .old_world import serving

Roslab = Callable[..., CompletedProcess[str]]
BASE = "repro-lab/moving:base"
IMAGE = "lab-moving"
ROOM_GB = 20
"""Free on the builder's disk, from which on pip keeps what it downloads."""
REPOSITORY = {
    "roslab.yaml": f"format: 3\nkind: python\nname: {IMAGE}\nbase: {{image: '{BASE}'}}\n"
    "apt: [robot-tool]\npip: [robot-lib]\ntest: python3 -c 'import robot_lib, robot_core'\n",
    "main.py": "print('hello')\n",
}


@pytest.fixture
def world(lab: Laboratory, tmp_path: Path) -> Iterator[World]:
    """Serve a world of the first day to the engine's containers, and a base that knows nothing else."""
    command = ["docker", "network", "inspect", "bridge", "--format", "{{(index .IPAM.Config 0).Gateway}}"]
    gateway = docker(lab, *command[1:]).strip()
    (tmp_path / "world").mkdir()
    with moving_world(gateway, tmp_path / "world") as running:
        running.add_deb("robot-tool", "1.0", "robot-data")
        running.add_deb("robot-data", "1.0")
        running.add_wheel("robot-lib", "1.0", "robot-core")
        running.add_wheel("robot-core", "1.0")
        running.add_real(*NEWEST)
        host = gateway.partition(":")[0]
        files = {"sources.list": running.sources}
        files["Dockerfile"] = (
            "FROM python:3.12\nRUN rm -rf /etc/apt/sources.list.d /var/lib/apt/lists/*\n"
            f"COPY sources.list /etc/apt/\nENV PIP_INDEX_URL={running.index} PIP_TRUSTED_HOST={host}\n"
        )
        docker(lab, "build", "--tag", BASE, str(write(tmp_path / "base", files)))
        yield running
        docker(lab, "image", "rm", "--force", BASE)


def docker(lab: Laboratory, *arguments: str) -> str:
    answer = subprocess.run(
        ["docker", *arguments], env=dict(lab.environment), capture_output=True, text=True, timeout=1800, check=False
    )
    assert answer.returncode == 0, answer.stderr[-6000:]
    return answer.stdout


def test_with_the_lock_nothing_moves(lab: Laboratory, roslab: Roslab, world: World, tmp_path: Path) -> None:
    tree = write(tmp_path / "tree", REPOSITORY)

    def run(*words: str, code: int = 0) -> CompletedProcess[str]:
        answer = roslab(*words, env=lab.environment, timeout=1800)
        assert answer.returncode == code, answer.stderr[-8000:]
        return answer

    def moved(old: str, new: str) -> dict[str, tuple[str | None, str | None]]:
        found = json.loads(run("diff", old, new, "--format", "json").stdout)
        packages = [c for c in found["changes"] if c["kind"] not in ("base", "env")]
        assert found["moved"] == len(packages)
        return {f"{c['kind']} {c['name']}": (c["old"], c["new"]) for c in packages}

    run("build", str(tree), "--tag", "first")
    run("lock", str(tree), "--tag", "first")
    lock = json.loads((tree / "roslab.lock").read_text())
    assert lock["base"]["digest"].startswith("sha256:")
    (machine,) = lock["platforms"].values()
    apt = {row["name"]: row for row in machine["apt"]}
    assert apt["robot-data"] == {
        "name": "robot-data", "version": "1.0", "architecture": "all", "source": "robot-data",
        "origin": f"{world.address}/apt ./", "step": "packages",
    }  # fmt: skip
    assert apt["dpkg"]["step"] == "base"
    pip = {row["name"]: row for row in machine["pip"]["image"]}
    assert {"pip", "robot-core", "robot-lib"} <= set(pip)
    assert all(row["hashes"] for row in pip.values()), pip

    for name in ("robot-data", "robot-tool"):
        world.add_deb(name, "2.0", "robot-data" if name == "robot-tool" else "")
    world.add_wheel("robot-core", "2.0")
    run("build", str(tree), "--tag", "locked", "--no-cache")
    assert moved(f"{IMAGE}:first", f"{IMAGE}:locked") == {}

    run("build", str(tree), "--tag", "today", "--no-cache", "--no-lock")
    assert moved(f"{IMAGE}:first", f"{IMAGE}:today") == {
        "apt robot-data": ("1.0", "2.0"),
        "apt robot-tool": ("1.0", "2.0"),
        "pip robot-core": ("1.0", "2.0"),
    }
    assert "can still be had" in run("lock", str(tree), "--check").stdout

    world.add_deb("robot-data", "3.0")
    world.add_wheel("robot-core", "3.0")
    del world.debs["robot-data", "1.0"], world.wheels["robot-core", "1.0"]
    told = [
        "apt: robot-data 1.0 can no longer be had; the nearest left is 2.0",
        "pip: robot-core 1.0 can no longer be had; the nearest left is 2.0",
    ]
    checked = run("lock", str(tree), "--check", code=5)
    assert all(line in checked.stderr for line in told), checked.stderr
    assert checked.stderr.count("can no longer be had") == 2
    built = run("build", str(tree), "--tag", "vanished")
    named = [built.stderr.index(line) for line in told]
    assert max(named) < built.stderr.index('pip install "$(pip-cache)" robot-lib'), "it is named before the build"
    assert set(moved(f"{IMAGE}:first", f"{IMAGE}:vanished")) == {"apt robot-data", "pip robot-core"}
    docker(lab, "image", "rm", "--force", *(f"{IMAGE}:{tag}" for tag in ("first", "locked", "today", "vanished")))


def test_another_package_downloads_no_earlier_one_again(
    lab: Laboratory, roslab: Roslab, world: World, tmp_path: Path
) -> None:
    """pip keeps its downloads in a mount where the builder's disk has room for that too."""
    ask = ["run", "--rm", "--entrypoint", "df", BASE, "--output=avail", "--block-size=1G", "/"]
    room = int(docker(lab, *ask).split()[-1]) >= ROOM_GB
    tree = write(tmp_path / "tree", REPOSITORY)
    world.add_wheel("robot-more", "1.0")
    for asked in ("[robot-lib]", "[robot-lib, robot-more]"):
        (tree / "roslab.yaml").write_text(REPOSITORY["roslab.yaml"].replace("[robot-lib]", asked))
        answer = roslab("build", tree, "--tag", "downloads", env=lab.environment, timeout=1800)
        assert answer.returncode == 0, answer.stderr[-8000:]
    counted = Counter(path for path in world.asked if path.startswith("/files/robot_"))
    again = 1 if room else 2
    assert counted == {
        "/files/robot_lib-1.0-py3-none-any.whl": again,
        "/files/robot_core-1.0-py3-none-any.whl": again,
        "/files/robot_more-1.0-py3-none-any.whl": 1,
    }
    assert sum(path == "/apt/robot-tool_1.0.deb" for path in world.asked) == 1, "the step of apt is not repeated"
    docker(lab, "image", "rm", "--force", f"{IMAGE}:downloads")


def test_an_authors_dockerfile_takes_the_same_images_and_files_again(
    lab: Laboratory, roslab: Roslab, tmp_path: Path
) -> None:
    """Its base moves to another image, and the file that it downloads changes; no line of it does."""
    base, name = "repro-lab/authored:base", "lab-authored"

    def make(text: str) -> None:
        files = {"Dockerfile": f"FROM ubuntu:24.04\nRUN echo {text} >/base\n"}
        docker(lab, "build", "--tag", base, str(write(tmp_path / text, files)))

    served = {"/data": b"first\n"}
    with serving(served) as address:
        own = f'FROM {base}\nADD --chmod=644 {address}/data /data\nCMD ["true"]\n'
        config = f"format: 3\nname: {name}\nkind: cpp\ndockerfile: Dockerfile\ntest: cat /base /data\n"
        tree = write(tmp_path / "tree", {"Dockerfile": own, "roslab.yaml": config})

        def run(*words: str, code: int = 0) -> CompletedProcess[str]:
            answer = roslab(*words, env=lab.environment, timeout=1800)
            assert answer.returncode == code, answer.stderr[-8000:]
            return answer

        make("one")
        docker(lab, "tag", base, "repro-lab/authored:kept")  # as a registry keeps it by its digest
        run("build", str(tree), "--tag", "first")
        run("lock", str(tree), "--tag", "first")
        lock = json.loads((tree / "roslab.lock").read_text())
        assert [each["source"] for each in lock["materials"]] == [
            f"docker-image://docker.io/{base}",
            f"{address}/data",
        ]
        make("two")
        run("build", str(tree), "--tag", "locked", "--no-cache")
        assert docker(lab, "run", "--rm", f"{name}:locked", "cat", "/base", "/data") == "one\nfirst\n"
        run("build", str(tree), "--tag", "today", "--no-cache", "--no-lock")
        assert docker(lab, "run", "--rm", f"{name}:today", "cat", "/base", "/data") == "two\nfirst\n"
        served["/data"] = b"second\n"
        # BuildKit still has the file of the lock; another one under the same address is not taken
        run("build", str(tree), "--tag", "locked", "--no-cache")
        assert docker(lab, "run", "--rm", f"{name}:locked", "cat", "/base", "/data") == "one\nfirst\n"
    tags = [f"{name}:first", f"{name}:locked", f"{name}:today", base, "repro-lab/authored:kept"]
    docker(lab, "image", "rm", "--force", *tags)


DOORS = pytest.mark.parametrize("door", [doors.through_action, doors.through_workflow], ids=["action", "image"])
GENERATED = {
    "roslab.yaml": "format: 3\nname: robot\nkind: python\nlock: true\ntest: python3 main.py\n",
    "requirements.txt": "",
    "main.py": "print('hello')\n",
}
OWN = {**doors.FILES, "roslab.yaml": f"{doors.RECIPE}lock: true\n"}


@DOORS
def test_a_run_keeps_the_lock_of_its_image_and_offers_it(
    lab: Laboratory, tmp_path: Path, door: Callable[..., Path]
) -> None:
    """Of a generated Dockerfile and of an author's own; with the lock in the repository nothing is offered again."""
    own = door is doors.through_workflow
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    github: dict[str, Any] = {"proposed": [], "contents": {}}

    def push(folder: str, files: Mapping[str, str]) -> tuple[Result, dict[str, bytes]]:
        given = {"files": {**OWN, **files}} if own else {"base": {**GENERATED, **files}}
        inputs = {"registry": lab.registry, "image": f"{doors.OWNER}/{name}", "platforms": "linux/amd64"}
        caller = door(tmp_path / f"{folder}-caller", inputs, **given)
        environment = {**doors.builder(lab), "ACTIONS_ID_TOKEN_REQUEST_URL": "http://127.0.0.1:9/"}
        place = tmp_path / folder
        ran = run_workflow(lab, caller, "push", doors.payload(name), env=environment, place=place, github=github)
        assert ran.exit_code == 0, ran.log
        return ran, artifacts(place)

    first, kept = push("first", {})
    (text,) = [data.decode() for file, data in kept.items() if file.endswith("/roslab.lock")]
    lock = json.loads(text)
    index, _ = registry.manifest(f"{doors.OWNER}/{name}:main")
    assert index["annotations"][locking.ANNOTATION] == digest(text)
    assert "Main Attach the lock to the image" in first.log
    assert list(lock["platforms"]) == ["linux/amd64"]
    assert bool(lock.get("materials")) == own
    assert github["contents"] == {"roslab.lock": text}
    (pull,) = github["proposed"]
    assert (pull["base"], pull["head"]) == ("main", {"ref": "roslab/lock"})

    second, _ = push("second", {"roslab.lock": text})
    assert "roslab.lock holds what was published" in second.log
    assert len(github["proposed"]) == 1
    used = json.loads(text)["materials"][0]["digest"] if own else lock["base"]["digest"]
    assert used in second.log
