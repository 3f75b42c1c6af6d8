"""The slim image of the action and of the workflows: its own proof decides on its own tags, and on nothing else."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from . import doors, registry
from .act import Result, run_workflow
from .laboratory import Laboratory

FILES = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.10)\nproject(robot CXX)\nadd_executable(robot main.cpp)\n"
    "install(TARGETS robot DESTINATION bin)\n",
    "main.cpp": '#include <cstdio>\nint main() { std::puts("it drives"); }\n',
}
RECIPE = "format: 3\nname: robot\nkind: cpp\nslim: true\ntest: {test}\ntags: {{suffix: -arm}}\n"


def pushed(lab: Laboratory, folder: Path, door: Callable[..., Path], test: str) -> tuple[str, Result]:
    """Run a caller whose roslab.yaml asks for a slim image; return the repository in the registry, and the run."""
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    repository = f"{doors.OWNER}/{name}"
    inputs = {"registry": lab.registry, "image": repository, "platforms": "linux/amd64", "cache": "none"}
    caller = door(folder, inputs, {"roslab.yaml": RECIPE.format(test=test)}, base=FILES)
    return repository, run_workflow(lab, caller, "push", doors.payload(name), env=doors.builder(lab))


def test_it_gets_its_own_tags_beside_the_whole_images(lab: Laboratory, tmp_path: Path) -> None:
    repository, ran = pushed(lab, tmp_path, doors.through_workflow, "robot")
    assert ran.exit_code == 0, ran.log
    tags = {name for name in registry.tags(repository) if not name.startswith("sha-")}
    assert tags == {"main-arm", "main-arm-slim", "latest-arm", "latest-arm-slim"}
    commits = sorted(name for name in registry.tags(repository) if name.startswith("sha-"))
    assert commits == [commits[0], f"{commits[0]}-slim"]
    slim = registry.digest(f"{repository}:main-arm-slim")
    assert slim == registry.digest(f"{repository}:{commits[1]}")
    assert ran.output("digest") == registry.digest(f"{repository}:main-arm") != slim
    assert "-slim" not in ran.output("tags")
    told = r"Published too: .*`main-arm-slim`.*\n\n- `linux/amd64`: ✅ .*; ([\d.]+) MB in the place of ([\d.]+) MB"
    said = re.search(told, ran.summary)
    assert said, ran.summary
    assert float(said[1]) < 0.6 * float(said[2])


def test_one_that_fails_withholds_its_own_tags_alone(lab: Laboratory, tmp_path: Path) -> None:
    repository, ran = pushed(lab, tmp_path, doors.through_action, "g++ --version")
    assert ran.exit_code == 0, ran.log
    assert {name for name in registry.tags(repository) if not name.startswith("sha-")} == {"main-arm", "latest-arm"}
    assert not any(name.endswith("-slim") for name in registry.tags(repository))
    assert "It got no tag: the whole image is published without it." in ran.summary
