"""What an image of the author's Dockerfile has of the tree: what its last stage copies, and what Compose mounts."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.config.model import Config, Volume
from roslab.decide.decision import Decision
from roslab.plan.plan import make_plan

Tree = Callable[[dict[str, str]], Decision]
STAGES = """FROM ubuntu:22.04 AS builder
WORKDIR /demo
COPY . .
RUN cmake -B build -S . && cmake --install build
FROM ubuntu:22.04 AS runtime
WORKDIR /demo
COPY --from=builder /usr/local/ /usr/local/
{more}
FROM runtime AS evaluation
RUN apt-get update && apt-get install -y python3
"""
COMPOSE = """services:
  demo:
    build:
      context: ${SRC:-.}
      target: runtime
    volumes:
      - ./other:/other
  evaluation:
    build:
      context: ${SRC:-.}
      target: evaluation
    volumes:
      - /tmp/.X11-unix:/tmp/.X11-unix:rw
      - ${DATA:-./data}:/data:ro
      - ${RESULTS}:/results
      - named:/named
      - .:/demo
      - type: bind
        source: ./tools
        target: /demo/tools
        read_only: true
"""
PAGE = """# Demo

## Run

```
docker compose run --rm evaluation \\
  python3 tools/check.py --fast \\
    --all
docker compose run --rm evaluation \\
  python3 tools/check.py --slow
docker compose run --rm evaluation python3 scripts/show.py
```
"""
FILES = {
    "CMakeLists.txt": "project(demo CXX)\nadd_executable(demo a.cc)\ninstall(TARGETS demo)\n",
    "a.cc": "#include <Eigen/Core>\nint main() {}\n",
    "tools/check.py": "print(1)\n",
    "scripts/show.py": "print(1)\n",
    "config/a.yaml": "a: 1\n",
    "README.md": PAGE,
    "compose.yml": COMPOSE,
}


def scripts(decision: Decision) -> set[str]:
    return {word for argv in decision.command_candidates for word in argv if word.endswith(".py")}


@pytest.mark.parametrize(
    ("more", "found"),
    [
        ("", {"tools/check.py"}),
        ("COPY --from=builder /demo/config/ config/", {"tools/check.py"}),
        ("COPY --from=builder /demo/scripts/ scripts/", {"tools/check.py", "scripts/show.py"}),
        ("COPY --from=builder /demo/ /demo/", {"tools/check.py", "scripts/show.py"}),
        ("COPY scripts/ scripts/", {"tools/check.py", "scripts/show.py"}),
    ],
)
def test_a_script_that_the_last_stage_lacks_is_no_candidate(tree: Tree, more: str, found: set[str]) -> None:
    decision = tree({**FILES, "Dockerfile": STAGES.format(more=more)})
    assert decision.dockerfile == "Dockerfile"
    assert scripts(decision) == found


def test_calls_of_one_script_are_one_program(tree: Tree) -> None:
    decision = tree({**FILES, "Dockerfile": STAGES.format(more="")})
    assert ("python3", "tools/check.py", "--fast", "--all") in decision.command_candidates
    said = next(each.reason for each in decision.reasons if each.question == "command" and each.decisive)
    assert said.startswith("2 programs could be the default")


def test_the_folders_of_the_last_stages_service_are_mounted(tree: Tree) -> None:
    decision = tree({**FILES, "Dockerfile": STAGES.format(more="")})
    assert decision.volumes == (
        Volume(host_path="data", container_path="/data", options="ro", made=True),
        Volume(host_path="tools", container_path="/demo/tools", options="ro", made=True),
    )
    own = Volume(host_path="/mnt/kitti", container_path="/data")
    plan = make_plan(decision, Config(volume=(own,)), folder_name="demo")
    assert own in plan.run.volumes


@pytest.mark.parametrize("page", ["", "# Demo\n"])
def test_nobody_has_compose_start_it(tree: Tree, page: str) -> None:
    decision = tree({**FILES, "README.md": page, "Dockerfile": STAGES.format(more="")})
    assert decision.volumes == ()


@pytest.mark.parametrize("authored", [True, False])
def test_what_is_said_of_an_option_for_one_processor(tree: Tree, authored: bool) -> None:
    made = FILES["CMakeLists.txt"] + 'set(CMAKE_CXX_FLAGS "-O3 -march=native")\n'
    files = {**FILES, "CMakeLists.txt": made} | ({"Dockerfile": STAGES.format(more="")} if authored else {})
    said = next(each.message for each in tree(files).warnings if "-march=native" in each.message)
    assert ("a generated Dockerfile" in said) is not authored
    assert ("the author's, compiles with it" in said) is authored
