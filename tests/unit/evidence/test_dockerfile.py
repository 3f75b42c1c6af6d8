"""The author's Dockerfiles."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.facts import AuthorDockerfile
from roslab.evidence.prose import author_dockerfile as dockerfile
from roslab.repository.checkout import Repository


def read(tmp_path: Path, files: dict[str, str]) -> dict[str, AuthorDockerfile]:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return {authored.file: authored for authored in dockerfile.read(Repository.open(tmp_path))}


AUTHORED = """\
ARG DISTRO=noetic
FROM ros:${DISTRO}-ros-base AS base
RUN apt-get update && apt-get install -y --no-install-recommends \\
    libone-dev \\
    # the second
    ros-${ROS_DISTRO}-two \\
  && pip3 install "numpy==1.2"
# RUN apt-get install nothing
FROM base
COPY . /ws/src/me
RUN <<EOF
apt-get install -y libthree
catkin build
EOF
CMD ["roslaunch", "me", "it.launch"]
"""


def test_a_dockerfile_of_the_project(tmp_path: Path) -> None:
    authored = read(tmp_path, {"docker/Dockerfile": AUTHORED, "package.xml": "<package/>"})["docker/Dockerfile"]
    assert (authored.base, authored.base_line, authored.purpose) == ("ros:noetic-ros-base", 9, "project")
    assert [(d.namespace, d.name, d.line) for d in authored.dependencies] == [
        ("apt", "libone-dev", 4),
        ("apt", "ros-{distro}-two", 6),
        ("apt", "libthree", 12),
    ]
    assert [(asked.written, asked.line) for asked in authored.requirements] == [("numpy==1.2", 7)]
    assert (authored.copies_repository, authored.context) == (True, "")
    assert authored.command == ("roslaunch", "me", "it.launch")


@pytest.mark.parametrize(
    "path",
    ["Dockerfile", "Dockerfile.noetic", "Dockerfile_20_04", "full.Dockerfile", "x.dockerfile", "docker/dockerfile",
     ".docker/Dockerfile", ".devcontainer/Dockerfile", "Dockerfile/Dockerfile", "Containerfile"],
)  # fmt: skip
def test_usual_names(tmp_path: Path, path: str) -> None:
    assert path in read(tmp_path, {path: "FROM ubuntu:20.04\n"})


@pytest.mark.parametrize("path", ["Dockerfile.md", "dockerfile.py", "Dockerfile.j2", "docker/readme"])
def test_other_names(tmp_path: Path, path: str) -> None:
    assert read(tmp_path, {path: "FROM ubuntu:20.04\n"}) == {}


@pytest.mark.parametrize(
    ("path", "text", "purpose"),
    [
        ("docs/Dockerfile", "FROM ubuntu\n", "documentation"),
        ("third_party/x/Dockerfile", "FROM ubuntu\n", "vendored"),
        (".github/Dockerfile", "FROM ubuntu\n", "ci"),
        ("deploy/Dockerfile", "FROM nvcr.io/nvidia/l4t-base:r32\n", "deploy"),
        ("Dockerfile", "FROM ubuntu\nRNU x\n", "broken"),
        ("Dockerfile", "RUN x\n", "broken"),
        ("Dockerfile", "FROM ubuntu\nCOPY start\nRUN mv /start /usr/bin\n", "broken"),
        ("Dockerfile", "FROM ubuntu\nADD --chmod=755 start\n", "broken"),
        ("Dockerfile", 'FROM ubuntu\nCOPY ["a b","/b"]\n', "project"),
        ("Dockerfile", "FROM ubuntu\nCOPY <<EOF /a\nb\nEOF\n", "project"),
        ("Dockerfile", "# nothing\n", "broken"),
    ],
)
def test_purposes(tmp_path: Path, path: str, text: str, purpose: str) -> None:
    assert read(tmp_path, {path: text})[path].purpose == purpose


def test_context_is_where_everything_copied_lies(tmp_path: Path) -> None:
    text = "FROM ubuntu:20.04\nCOPY requirements.txt /\nCOPY node /node\n"
    files = {"ros1/docker/Dockerfile": text, "ros1/requirements.txt": "", "ros1/node/a.py": "", "requirements.txt": ""}
    authored = read(tmp_path, files)["ros1/docker/Dockerfile"]
    assert (authored.context, authored.copies_repository, authored.problem) == ("ros1", True, None)


def test_what_it_copies_must_be_there(tmp_path: Path) -> None:
    authored = read(tmp_path, {"Dockerfile": "FROM ubuntu:20.04\nCOPY . /x\nCOPY key.pem /\n"})["Dockerfile"]
    assert authored.problem == "line 3 copies key.pem, which the repository does not hold"
    assert authored.purpose == "project"


@pytest.mark.parametrize("above", ["..", "../", "../.."])
def test_nothing_lies_above_the_context(tmp_path: Path, above: str) -> None:
    files = {"docker/Dockerfile": f"FROM ubuntu:20.04\nWORKDIR /ws\nCOPY {above} /ws\nCOPY ../a.py /\n", "a.py": ""}
    authored = read(tmp_path, files)["docker/Dockerfile"]
    assert (authored.context, authored.copies_repository, authored.problem) == ("", True, None)
    assert authored.starts_in_source


@pytest.mark.parametrize(
    ("run", "problem"),
    [
        ("RUN rm -r build install log", True),
        ("RUN rm -r src/old && make", True),
        ("RUN rm -rf build install log", False),
        ("RUN rm -r build || true", False),
        ("RUN rm -r src", False),
        ("RUN rm -r /var/lib/apt/lists", False),
        ("RUN colcon build\nRUN rm -r build", False),
        ("WORKDIR /other\nRUN rm -r build", False),
    ],
)
def test_what_it_removes_must_be_there(tmp_path: Path, run: str, *, problem: bool) -> None:
    files = {"src/a.py": "", "Dockerfile": f"FROM ros:humble\nWORKDIR /ws\nCOPY . /ws\n{run}\n"}
    found = read(tmp_path, files)["Dockerfile"].problem
    assert ("which the repository does not hold, and stops there" in (found or "")) is problem


@pytest.mark.parametrize(
    ("copies", "starts", "problem"),
    [
        ("COPY src/fixes /tmp/fixes", 'CMD /bin/bash -c "uv run scripts/serve.py $ARGS"', True),
        ("COPY src /app/src", 'ENTRYPOINT ["python", "scripts/serve.py"]', True),
        ("COPY src /app/src\nCOPY scripts /app/scripts", 'ENTRYPOINT ["python", "./scripts/serve.py"]', False),
        ("COPY . /app", "CMD python scripts/serve.py", False),
        ("COPY src /app", 'CMD ["python", "fixes/a.py"]', False),
    ],
)
def test_what_it_starts_must_be_in_the_image(tmp_path: Path, copies: str, starts: str, *, problem: bool) -> None:
    files = {"src/fixes/a.py": "", "scripts/serve.py": "", "Dockerfile": f"FROM ubuntu:22.04\n{copies}\n{starts}\n"}
    found = read(tmp_path, files)["Dockerfile"].problem
    assert ("starts scripts/serve.py and does not copy it" in (found or "")) is problem


def test_a_dockerfile_that_clones_itself(tmp_path: Path) -> None:
    folder = tmp_path / "thing"
    authored = read(folder, {"Dockerfile": "FROM ubuntu:20.04\nRUN git clone https://github.com/me/thing.git\n"})[
        "Dockerfile"
    ]
    assert (authored.clones_itself, authored.copies_repository) == (True, True)


def test_private_tokens_are_noticed(tmp_path: Path) -> None:
    text = "FROM ubuntu:20.04\nARG T\nRUN git clone https://me:${T_TOKEN}@github.com/a/b\n"
    assert "private" in (read(tmp_path, {"Dockerfile": text})["Dockerfile"].problem or "")


def test_an_argument_without_default_stays(tmp_path: Path) -> None:
    assert read(tmp_path, {"Dockerfile": "ARG D\nFROM ros:${D}-ros-core\n"})["Dockerfile"].base == "ros:${D}-ros-core"


def test_what_a_container_starts_with_is_that_of_its_last_stage(tmp_path: Path) -> None:
    text = """\
FROM ubuntu:22.04 AS first
WORKDIR /code
COPY . /code/
ENTRYPOINT ["/ros_entrypoint.sh"]
CMD ["./serve"]
FROM first AS second
WORKDIR build
FROM first
CMD ["bash"]
"""
    authored = read(tmp_path, {"Dockerfile": text, "a.py": ""})["Dockerfile"]
    assert (authored.entrypoint, authored.command, authored.command_line) == (("/ros_entrypoint.sh",), ("bash",), 9)
    assert authored.starts_in_source
    other = read(tmp_path, {"Dockerfile": text.replace("FROM first\n", "FROM ubuntu:22.04\nCOPY . /x\n")})["Dockerfile"]
    assert (other.entrypoint, other.command, other.starts_in_source) == ((), ("bash",), False)


@pytest.mark.parametrize(
    ("base", "text", "problem"),
    [
        ("osrf/ros:noetic-desktop-full", "COPY . /ws/src/me\nRUN rm -rf /var/lib/apt/lists/*", True),
        (
            "osrf/ros:noetic-desktop",
            "ENV W=/ws\nRUN make install\nCOPY . $W/src/me\nRUN rosdep install --from-paths .",
            True,
        ),
        ("ros:humble", "COPY . /ws/src/me\nRUN . /opt/ros/humble/setup.sh && colcon build", False),
        ("ros:humble", "COPY . /ws/src/me\nRUN bash /ws/src/me/compile.sh", False),
        ("ros:humble", "COPY . /ws/src/me\nRUN chmod +x /ws/src/me/tools.sh && bash /ws/src/me/tools.sh", True),
        ("ros:humble", "COPY . /ws/src/me\nRUN bash tools.sh && bash gone.sh", False),
        ("ros:humble", "COPY . /ws/src/me\nRUN bash all.sh", False),
        ("ros:humble", "COPY . /ws/src/me\nRUN <<EOF\napt-get install -y nano\ncolcon build\nEOF", False),
        (
            "ubuntu:22.04",
            "RUN apt-get install -y \\\n  cmake\nCOPY . /me\nRUN apt-get install -y \\\n  ninja-build",
            True,
        ),
        ("ros:humble", 'COPY . /ws/src\nENTRYPOINT ["/ws/src/start.sh"]', False),
        ("ros:humble", "COPY . /opt/me", True),
        ("ros:humble", 'COPY . /opt/me\nCMD ["python3", "/opt/me/a.py"]', False),
        ("ros:humble", "COPY ./package.xml ./\nWORKDIR /ws\n#RUN . /opt/ros/humble/setup.sh && colcon build", True),
        ("ros:humble", "COPY . /opt/me\nCOPY start.sh /\nRUN . /opt/ros/humble/setup.sh && colcon build", False),
        ("ros:humble", "COPY . /opt/me\nRUN colcon build\nCOPY start.sh /\nCMD bash", False),
        ("ubuntu:22.04", "RUN make\nCOPY . /opt/me", True),
        ("ubuntu:22.04", "COPY . /opt/me\nRUN g++ /opt/me/a.cpp", False),
        ("ubuntu:22.04", "COPY start.sh /opt/me/", False),
        ("python:3.11", "COPY . /usr/src/app", False),
    ],
)
def test_copied_packages_are_built(tmp_path: Path, base: str, text: str, *, problem: bool) -> None:
    files = {
        "Dockerfile": f"FROM {base}\n{text}\n",
        "package.xml": "<package/>",
        "compile.sh": "colcon build\n",
        "start.sh": "",
    }
    files |= {"tools.sh": "apt-get install -y nano\npip install setuptools==58.2.0\n"}
    files |= {"all.sh": "apt-get install -y nano\ncolcon build\n"}
    files |= {"CMakeLists.txt": "project(me)\n"} if base.startswith("ubuntu") else {}
    found = read(tmp_path, files)["Dockerfile"].problem
    assert (found is not None and "builds none of them" in found) is problem


@pytest.mark.parametrize(
    ("files", "problem"),
    [
        ({"CMakeLists.txt": "project(me)\n"}, True),
        ({"CMakeLists.txt": "project(me)\n", "setup.py": ""}, False),
        ({"tools/CMakeLists.txt": "project(me)\n", "a.py": ""}, False),
    ],
)
def test_a_project_without_packages_is_built_on_a_base_of_ros(
    tmp_path: Path, files: dict[str, str], *, problem: bool
) -> None:
    found = read(tmp_path, {"Dockerfile": "FROM ros:melodic-robot\nCOPY . /me\n", **files})["Dockerfile"].problem
    assert (found is not None and "builds none of them" in found) is problem


GAPS = """\
FROM ubuntu:20.04
RUN apt-get install -y libone-dev && \\

# the second
    apt-get install -y libtwo-dev && \\

    pip3 install \\

        numpy==1.2
RUN apt-get install -y \\
    libthree-dev \\

RUN apt-get install -y libfour-dev
"""


def test_an_empty_line_does_not_end_a_continued_instruction_but_the_next_instruction_does(tmp_path: Path) -> None:
    authored = read(tmp_path, {"Dockerfile": GAPS})["Dockerfile"]
    assert [(d.name, d.line) for d in authored.dependencies] == [
        ("libone-dev", 2), ("libtwo-dev", 5), ("libthree-dev", 11), ("libfour-dev", 13),
    ]  # fmt: skip
    assert [(asked.written, asked.line) for asked in authored.requirements] == [("numpy==1.2", 9)]
    assert not authored.problem


@pytest.mark.parametrize(
    ("text", "base", "names"),
    [
        ("ARG D=humble\nFROM ros:$D\nRUN apt install ros-${D}-a\n", "ros:humble", ["ros-humble-a"]),
        ("ARG D=humble\nFROM a:1\nARG D=jazzy\nRUN apt install ros-${D}-a\n", "a:1", ["ros-jazzy-a"]),
        ("FROM a:1\nARG D=humble\nFROM b:1\nARG D=jazzy\nRUN apt install lib$D\n", "b:1", ["libjazzy"]),
        ("FROM a:1 AS c\nARG D=humble\nFROM c\nRUN apt install lib$D\n", "a:1", ["libhumble"]),
        ("FROM a:1\nARG D=humble\nFROM b:1\nRUN apt install one lib$D\n", "b:1", ["one"]),
        ("FROM a:1\nENV D=humble\nARG D=jazzy\nRUN apt install lib$D\n", "a:1", ["libhumble"]),
        ("FROM a:1\nARG C=x D=jazzy\nRUN apt install lib$D\n", "a:1", ["libjazzy"]),
    ],
)
def test_the_default_of_an_argument_holds_in_its_stage(tmp_path: Path, text: str, base: str, names: list[str]) -> None:
    authored = read(tmp_path, {"Dockerfile": text})["Dockerfile"]
    assert (authored.base, [each.name for each in authored.dependencies]) == (base, names)


def test_a_copied_path_has_the_default_of_an_argument(tmp_path: Path) -> None:
    text = "FROM ros:humble\nARG PART=robot\nCOPY ${PART}/src /ws/src\n"
    assert read(tmp_path, {"Dockerfile": text, "robot/src/a.cpp": ""})["Dockerfile"].copied == ("robot/src",)


STAGES = """\
ARG TYPE=cpu
FROM ubuntu:22.04 AS cpu
RUN apt-get install -y libcpu-dev
FROM nvidia/cuda:12.4.1-devel-ubuntu22.04 AS gpu
RUN apt-get install -y libgpu-dev && pip3 install cupy
RUN git clone https://github.com/a/gpu_lib
FROM cpu AS builder
RUN apt-get install -y libbuild-dev
FROM ${TYPE} AS base
RUN apt-get install -y libbase-dev
FROM base AS ros2
RUN apt-get install -y libros-dev
FROM base AS final
COPY --from=builder /opt /opt
RUN apt-get install -y liblast-dev
"""


def test_stages_from_which_the_last_one_does_not_come_install_nothing(tmp_path: Path) -> None:
    authored = read(tmp_path, {"Dockerfile": STAGES})["Dockerfile"]
    names = [each.name for each in authored.dependencies]
    assert names == ["libcpu-dev", "libbuild-dev", "libbase-dev", "liblast-dev"]
    assert (authored.requirements, authored.clones) == ((), ())
    other = read(tmp_path, {"Dockerfile": STAGES.replace("TYPE=cpu", "TYPE=gpu").replace("=builder", "=2")})
    names = [each.name for each in other["Dockerfile"].dependencies]
    assert names == ["libcpu-dev", "libgpu-dev", "libbuild-dev", "libbase-dev", "liblast-dev"]
    assert [each.name for each in other["Dockerfile"].clones] == ["gpu_lib"]
