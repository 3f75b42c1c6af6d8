"""A step of the author's Dockerfile that starts every compiler at once is told with its line."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from trees import decided

Tree = Callable[[dict[str, str]], Decision]
FILES = {"requirements.txt": "numpy\n", "main.py": "import numpy\n\nif __name__ == '__main__':\n    print(numpy)\n"}
DOCKERFILE = """FROM ubuntu:22.04
RUN apt-get update && apt-get install -y git cmake g++ python3-numpy
RUN git clone https://github.com/lab/lib && cd lib \\
 && cmake . \\
 && {}
COPY . /app
WORKDIR /app
CMD ["python3", "main.py"]
"""


def told(decision: Decision) -> list[tuple[str, int]]:
    return [(each.file or "", each.line or 0) for each in decision.warnings if "every compiler at once" in each.message]


@pytest.mark.parametrize(
    "line",
    [
        "make -j && make install",
        "make install -j",
        "make -j; make install",
        "make --jobs install",
        "cmake --build . -j",
        "cmake --build . --parallel --target install",
        "cmake --build . -- -j",
    ],
)
def test_no_number_is_told(tree: Tree, line: str) -> None:
    assert told(tree({**FILES, "Dockerfile": DOCKERFILE.format(line)})) == [("Dockerfile", 5)]


@pytest.mark.parametrize(
    "line",
    [
        "make -j4",
        "make -j 4",
        "make -j$(nproc)",
        "make -j $(nproc)",
        "make",
        "ninja -j",
        "cmake --build . -j 2",
        "make -j -l4",
        "cmake -G Ninja .. && cmake --build . -j",
        "git fetch -j",
    ],
)
def test_a_number_or_another_program_is_not(tree: Tree, line: str) -> None:
    assert told(tree({**FILES, "Dockerfile": DOCKERFILE.format(line)})) == []


def test_a_script_that_it_runs_is_read(tree: Tree) -> None:
    script = "#!/bin/bash\nset -e\ncd /lib\nmake -j\n"
    files = {"build/deps.sh": script, "other.sh": script, "Dockerfile": DOCKERFILE.format("bash build/deps.sh")}
    assert told(tree({**FILES, **files})) == [("build/deps.sh", 4)]


def test_a_dockerfile_that_roslab_yaml_names_is_told_too(tmp_path: Path) -> None:
    mounted = "FROM ubuntu:22.04\nRUN apt-get update && apt-get install -y make\nRUN make -j\nWORKDIR /app\n"
    decision = decided(tmp_path, {**FILES, "Dockerfile": mounted}, config=Config(dockerfile="Dockerfile"))
    assert told(decision) == [("Dockerfile", 3)]
    (line,) = (each.line for each in decision.warnings if "copies nothing of the repository" in each.message)
    assert line == 1
    copied = decided(tmp_path, {"Dockerfile": f"{mounted}COPY . /app\n"}, config=Config(dockerfile="Dockerfile"))
    assert not [each for each in copied.warnings if "copies nothing" in each.message]
