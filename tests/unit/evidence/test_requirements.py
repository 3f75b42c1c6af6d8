"""Requirements files, as people write them."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.facts import RequirementFile
from roslab.evidence.gather import gather
from roslab.evidence.python import requirements
from roslab.repository.checkout import Repository
from trees import tree_of


def read(tmp_path: Path, files: dict[str, str]) -> dict[str, RequirementFile]:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return {file.file: file for file in requirements.read(Repository.open(tmp_path))}


@pytest.mark.parametrize(
    ("line", "name", "role"),
    [
        ("numpy", "numpy", ""),
        ("numpy == 2.3.5", "numpy==2.3.5", ""),
        ('"numpy == 2.3.5"', "numpy==2.3.5", "repaired"),
        ("torch>=1.7, <2", "torch>=1.7,<2", ""),
        ("absl-py>=0.7.0  # flags", "absl-py>=0.7.0", ""),
        ("hydra-core[all]~=1.1", "hydra-core[all]~=1.1", ""),
        ("numpy=1.19.5", "numpy==1.19.5", "repaired"),
        ("certifi=2020.6.20=py37_0", "certifi==2020.6.20", "repaired"),
        ("certifi @ file:///tmp/build/certifi", "certifi", "repaired"),
        ("clip @ git+https://github.com/openai/CLIP.git", "clip @ git+https://github.com/openai/CLIP.git", ""),
        ("git+https://github.com/a/b.git@v1#egg=b", "git+https://github.com/a/b.git@v1#egg=b", ""),
        ("-e git+https://github.com/a/b.git#egg=b", "git+https://github.com/a/b.git#egg=b", "editable"),
        ("-e .", ".", "project"),
        ("./third_party/gym", "./third_party/gym", "project"),
        ("torch==1.10.0+cu113", "torch==1.10.0+cu113", ""),
        ("six==1.16.0 --hash=sha256:abc", "six==1.16.0", ""),
    ],
)
def test_a_line_means_what_its_author_meant(tmp_path: Path, line: str, name: str, role: str) -> None:
    (asked,) = read(tmp_path, {"requirements.txt": f"\n{line}\n"})["requirements.txt"].requirements
    assert (asked.written, asked.role, asked.line) == (name, role, 2)


def test_lines_that_pip_refuses_are_told(tmp_path: Path) -> None:
    lines = (
        "Requirements:",
        "numpy",
        "Python 3",
        "lib/a",
        "a/b c",
        "$HOME/a",
        "--odd",
        "six == new or so",
        "",
        "os ->",
    )
    file = read(tmp_path, {"requirements.txt": "\n".join(lines)})["requirements.txt"]
    assert [each.written for each in file.requirements] == ["numpy"]
    assert file.unread == (1, 3, 8)


def test_markers_are_read(tmp_path: Path) -> None:
    found = read(tmp_path, {"requirements.txt": "pywin32; sys_platform == 'win32'\n"})
    assert str(found["requirements.txt"].requirements[0].marker) == 'sys_platform == "win32"'


def test_options_includes_and_constraints(tmp_path: Path) -> None:
    text = "--extra-index-url https://e.org/whl\n-f https://f.org\n-r base.txt\n-c pins/c.txt\n-r ../outside.txt\n"
    found = read(
        tmp_path,
        {"requirements/all.txt": text, "requirements/base.txt": "six\n-r all.txt\n", "requirements/pins/c.txt": ""},
    )
    file = found["requirements/all.txt"]
    assert file.options == ("--extra-index-url https://e.org/whl", "--find-links https://f.org")
    assert file.includes == ("requirements/base.txt", "outside.txt")
    assert file.constraints == ("requirements/pins/c.txt",)
    assert found["requirements/base.txt"].includes == ("requirements/all.txt",)


def test_several_packages_in_one_line(tmp_path: Path) -> None:
    text = (
        "torch==1.10.1+cu111 torchvision==0.11.2+cu111 -f https://wheels.example/whl/torch.html\n"
        "jax -f https://wheels.example/jax.html\n"
        "# tqdm scipy\ninstall these first\n"
    )
    file = read(tmp_path, {"requirements.txt": text})["requirements.txt"]
    assert [(each.written, each.role, each.line) for each in file.requirements] == [
        ("torch==1.10.1+cu111", "repaired", 1),
        ("torchvision==0.11.2+cu111", "repaired", 1),
        ("jax", "repaired", 2),
    ]
    assert file.options == (
        "--find-links https://wheels.example/whl/torch.html",
        "--find-links https://wheels.example/jax.html",
    )


@pytest.mark.parametrize(
    ("path", "purpose"),
    [
        ("requirements.txt", "run"),
        ("requirement.txt", "run"),
        ("python/requirements-gpu.txt", "run"),
        ("docs/requirements.txt", "docs"),
        ("requirements-dev.txt", "dev"),
        ("test_requirements.txt", "test"),
        ("third_party/pybind11/requirements.txt", "vendored"),
    ],
)
def test_purpose_is_told_by_the_path(tmp_path: Path, path: str, purpose: str) -> None:
    assert read(tmp_path, {path: "six\n"})[path].purpose == purpose


@pytest.mark.parametrize("name", ["apt-requirements.txt", "conda-requirements.txt", "CMakeLists.txt", "data.txt"])
def test_other_lists_are_left_alone(tmp_path: Path, name: str) -> None:
    assert read(tmp_path, {name: "libfoo-dev\n", "other": ""}) == {}


def test_utf_16_and_stray_bytes(tmp_path: Path) -> None:
    (tmp_path / "requirements.txt").write_bytes("numpy==1.2\r\nscipy\r\n".encode("utf-16"))
    (tmp_path / "requirements-b.txt").write_bytes(b"six\n\xff\xfe\xfa\nyaml\n")
    first, second = requirements.read(Repository.open(tmp_path))
    names = sorted(asked.written for file in (first, second) for asked in file.requirements)
    assert names == ["numpy==1.2", "scipy", "six", "yaml"]


def test_a_giant_file_is_read_as_far_as_a_person_writes(tmp_path: Path) -> None:
    with (tmp_path / "requirements.txt").open("wb") as stream:
        stream.write(b"numpy\n" * 1000)
        stream.truncate(2 * 1024**3)
    (file,) = requirements.read(Repository.open(tmp_path))
    assert len(file.requirements) <= requirements.MAX_LINES


def test_a_list_of_another_tool_is_not_pips(tmp_path: Path) -> None:
    files = {
        "requirements.txt": "# for cget\nnlohmann/json@v3.8.0\n",
        "dev/requirements.txt": "# none yet\n",
        "a/requirements.txt": "owner/name@tag\nnumpy\n",
        "wide/requirements.txt": "",
    }
    assert sorted(read(tmp_path, files)) == ["a/requirements.txt", "dev/requirements.txt", "wide/requirements.txt"]


def test_a_list_in_two_bytes_a_letter_is_pips(tmp_path: Path) -> None:
    (tmp_path / "requirements.txt").write_bytes("numpy\n".encode("utf-16"))
    assert [file.file for file in requirements.read(Repository.open(tmp_path))] == ["requirements.txt"]


@pytest.mark.parametrize(
    ("name", "read_as_one"),
    [
        ("non_rosdep_requirements.txt", True),
        ("non-conda-requirements.txt", True),
        ("my_non_rosdep_requirements.txt", True),
        ("requirements_not_conda.txt", True),
        ("nano_system_requirements.txt", False),
        ("arduino-apt-requirements.txt", False),
        ("nano_requirements.txt", True),
        ("rosdep_requirements.txt", False),
        ("requirements_conda.txt", False),
    ],
)
def test_a_list_of_what_is_not_another_tool_s_is_pip_s(tmp_path: Path, name: str, *, read_as_one: bool) -> None:
    assert (name in read(tmp_path, {name: "networkx>=2.8.4\n"})) is read_as_one


@pytest.mark.parametrize(
    ("path", "text", "is_list"),
    [
        ("requirments.txt", "numpy==1.19\nscipy\n", True),
        ("Requirments", "numpy\nscipy\n# more\n", True),
        ("requierments.txt", "numpy\n", True),
        ("requirements", "torch>=1.8\nsome-package\n", True),
        ("src/reqirements.txt", "numpy\n", True),
        ("data/requirments.txt", "numpy\n", False),  # beside no code
        ("third_party/requirments.txt", "numpy\n", False),
        ("requirments.txt", "numpy==1.19\nInstall ROS first.\n", False),
        ("requirements", "libeigen3-dev\nlibopencv-dev\n", False),
        ("requirments.txt", "", False),
        ("requirments.md", "numpy\n", False),
        ("retirement.txt", "- numpy\n- scipy\n", False),
        ("recruitment.txt", "numpy\n", False),
        ("environment/requirements-pip", "numpy\npyglet==1.5.0\n", True),
        ("environment/requirements-conda", "numpy\npyglet==1.5.0\n", False),
        ("third_party/requirements-pip", "numpy\npyglet==1.5.0\n", False),
    ],
)
def test_a_list_whose_name_is_misspelt_holds_nothing_else(
    tmp_path: Path, path: str, text: str, *, is_list: bool
) -> None:
    files = {path: text, "main.py": "", "src/main.py": "", "third_party/main.py": ""}
    assert [*read(tmp_path, files)] == ([path] if is_list else [])


@pytest.mark.parametrize(("name", "is_list"), [("packages", True), ("packages.req", True), ("packages.yaml", False)])
def test_a_list_that_a_page_gives_to_pip_needs_no_ending(tmp_path: Path, name: str, *, is_list: bool) -> None:
    page = f"# Arm\n\n## Install\n\n```\npip install -r setup/{name}\n```\n"
    files = {"README.md": page, f"setup/{name}": "numpy==1.20\n", "main.py": "import numpy\n"}
    tree_of(tmp_path, files)
    found = [file.file for file in gather(Repository.open(tmp_path)).requirements]
    assert found == ([f"setup/{name}"] if is_list else [])
