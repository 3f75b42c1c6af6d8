"""Steps of an author's Dockerfile that read files of the build context which a clean checkout does not hold."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.prose import author_dockerfile
from roslab.repository.checkout import Repository

TREE = ("main.py", "present.repos", "requirements.txt", "scripts/setup.sh", "config/a.yaml", "models.tar.gz")


def problem(tmp_path: Path, steps: str) -> str | None:
    for path in ("Dockerfile", *TREE):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text("")
    (tmp_path / "Dockerfile").write_text(f"FROM ros:humble\n{steps}\n")
    return author_dockerfile.read(Repository.open(tmp_path))[0].problem


@pytest.mark.parametrize(
    ("steps", "path", "line"),
    [
        (
            "COPY . /ws/demo\nRUN cd ws && \\\n    apt update && \\\n    cd demo && vcs import < gone.repos",
            "gone.repos",
            5,
        ),
        ("WORKDIR /ws/src/demo\nCOPY . .\nRUN vcs import --input gone.repos ..", "gone.repos", 4),
        ("COPY . /app\nRUN pip install -r /app/gone.txt", "/app/gone.txt", 3),
        ("COPY . /app\nWORKDIR /app\nRUN pip install torch\nRUN pip install --requirement=gone.txt", "gone.txt", 5),
        ("COPY . /app\nWORKDIR /app\nRUN conda env create -f gone.yml", "gone.yml", 4),
        ("COPY . /app\nRUN cd app && bash scripts/gone.sh", "scripts/gone.sh", 3),
        ("COPY . /app\nWORKDIR /app\nRUN chmod +x scripts/setup.sh gone.sh", "gone.sh", 4),
        ("COPY . /app\nWORKDIR /app\nRUN python3 setup.py install", "setup.py", 4),
        ("COPY . /app\nWORKDIR /app\nRUN cp config/gone.yaml /etc/", "config/gone.yaml", 4),
        ("COPY config /app/config\nCOPY main.py /app/\nRUN cp /app/config/b.yaml /etc/", "/app/config/b.yaml", 4),
        (
            "COPY . /app\nWORKDIR /tmp\nRUN git clone https://a.b/c && cd c && make\nRUN sh /app/gone.sh",
            "/app/gone.sh",
            5,
        ),
        ('COPY [".", "/app"]\nWORKDIR /app\nRUN xargs apt-get install -y < gone.txt', "gone.txt", 4),
        ("COPY . /app\nCOPY --from=other /uv /bin/\nRUN sh /app/gone.sh", "/app/gone.sh", 4),
        ("COPY . /app\nWORKDIR /app\nRUN --mount=type=cache,target=/c pip install -r gone.txt", "gone.txt", 4),
        ("FROM ros:humble AS base\nCOPY . /app\nFROM base\nRUN sh /app/gone.sh", "/app/gone.sh", 5),
    ],
)
def test_a_build_stops_where_a_step_reads_what_the_tree_lacks(tmp_path: Path, steps: str, path: str, line: int) -> None:
    assert problem(tmp_path, steps) == f"line {line} reads {path}, which the repository does not hold, and stops there"


@pytest.mark.parametrize(
    "steps",
    [
        "COPY . /ws/demo\nRUN cd /ws/demo && vcs import < present.repos",
        "COPY . /app\nWORKDIR /app\nRUN pip install -r requirements.txt && bash scripts/setup.sh",
        # Another step made it, or may have
        "WORKDIR /app\nRUN wget https://a.b/gone.txt\nCOPY . .\nRUN pip install -r gone.txt",
        "COPY . /app\nWORKDIR /app\nRUN echo numpy > gone.txt && pip install -r gone.txt",
        "COPY . /app\nWORKDIR /app\nRUN python3 main.py\nRUN pip install -r gone.txt",
        "COPY . /app\nRUN git clone https://a.b/c /app/c\nRUN sh /app/gone.sh",
        "COPY . /app\nWORKDIR /app\nRUN <<END\nmake\nEND\nRUN sh gone.sh",
        "COPY . /app\nCOPY --from=other /gone.sh /app/\nRUN sh /app/gone.sh",
        "COPY . /app\nWORKDIR /app\nCOPY --from=other /out .\nRUN chmod +x gone.sh",
        "COPY . /app\nWORKDIR /app\nADD https://a.b/c.git /app\nRUN sh gone.sh",
        "COPY . /app\nWORKDIR /app\nADD models.tar.gz .\nRUN cp gone.pt /opt/",
        "COPY . /app\nWORKDIR /app\nRUN pip download numpy && cp gone.whl /opt/",
        "COPY . /app\nWORKDIR /app\nRUN conda env export -f gone.yml",
        # It lies in a folder that the tree does not have: a build made that
        "COPY . /ws/src/demo\nWORKDIR /ws/src/demo\nRUN . install/setup.sh",
        "COPY . /ws/src/demo\nWORKDIR /ws\nRUN colcon build\nRUN . install/setup.sh",
        # The step goes on without it
        "COPY . /app\nWORKDIR /app\nRUN pip install -r gone.txt || true",
        "COPY . /app\nWORKDIR /app\nRUN cp gone.txt /etc/; true",
        "COPY . /app\nWORKDIR /app\nRUN if [ -e gone.txt ]; then pip install -r gone.txt; fi",
        "COPY . /app\nWORKDIR /app\nRUN [ -e gone.txt ] && pip install -r gone.txt",
        # Nobody knows where, or the tree is not there
        "COPY . /app\nRUN cd $SOMEWHERE && vcs import < gone.repos",
        "COPY . /app\nWORKDIR /opt\nRUN pip install -r gone.txt",
        "COPY . /app\nWORKDIR /app\nRUN chmod +x *.bash && pip install -r $LIST",
        "COPY . /app\nWORKDIR /app\nRUN --mount=type=bind,source=.,target=/app pip install -r gone.txt",
        "COPY . /app\nWORKDIR /app\nRUN --mount=from=other,target=/app sh gone.sh",
        # A stage that the image does not come from
        "COPY . /app\nRUN sh /app/gone.sh\nFROM ros:humble\nCOPY . /app",
    ],
)
def test_what_is_there_or_may_be_made_stops_nothing(tmp_path: Path, steps: str) -> None:
    assert problem(tmp_path, steps) is None
