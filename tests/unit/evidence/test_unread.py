"""Which files at the top of a repository no compilation reads: only those that no build file can mean."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest

from roslab.evidence.native import unread
from roslab.repository.checkout import Repository

PAGES = {"README.md": "", "LICENSE": "", "docs/index.md": "", "demo.ipynb": "", "src/node.cpp": "", "roslab.yaml": ""}


def names(root: Path, files: Mapping[str, str]) -> tuple[str, ...]:
    for path, text in files.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    return unread.names(Repository.open(root))


def test_pages_notebooks_and_settings(tmp_path: Path) -> None:
    found = names(tmp_path, {**PAGES, "CMakeLists.txt": "add_executable(node src/node.cpp)\n"})
    assert found == ("LICENSE", "README.md", "demo.ipynb", "docs", "roslab.yaml")


@pytest.mark.parametrize(
    ("path", "text", "read"),
    [
        ("setup.py", 'long_description=open("README.md").read()', "README.md"),
        ("pyproject.toml", 'readme = "README.md"', "README.md"),
        ("a/CMakeLists.txt", "install(FILES ../LICENSE DESTINATION share/a)", "LICENSE"),
        ("CMakeLists.txt", "add_subdirectory(docs)", "docs"),
        ("CMakeLists.txt", "file(GLOB books *.ipynb)", "demo.ipynb"),
    ],
)
def test_what_a_build_file_names_is_read(tmp_path: Path, path: str, text: str, read: str) -> None:
    found = names(tmp_path, {**PAGES, path: text})
    assert read not in found
    assert len(found) == 4


@pytest.mark.parametrize(
    "text",
    [
        "install(DIRECTORY . DESTINATION share/a)",
        "install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION share/a)",
        'file(GLOB_RECURSE everything "*")',
    ],
)
def test_a_build_that_takes_the_whole_folder_reads_all(tmp_path: Path, text: str) -> None:
    assert names(tmp_path, {**PAGES, "CMakeLists.txt": text}) == ()


def test_a_name_that_is_no_word_of_a_dockerfile_is_left_alone(tmp_path: Path) -> None:
    assert names(tmp_path, {"read me.md": "", "a$b.md": "", "CMakeLists.txt": ""}) == ()


@pytest.mark.parametrize("file", ["package.xml", "setup.py", "pyproject.toml"])
def test_a_folder_with_a_package_is_read(tmp_path: Path, file: str) -> None:
    files = {f"tests/sync_test/{file}": "", "docs/index.md": "", "core/package.xml": ""}
    assert names(tmp_path, files) == ("docs",)
