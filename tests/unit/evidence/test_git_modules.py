"""What a .gitmodules names is read as git reads it."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.evidence.gather import gather
from roslab.evidence.git_modules import entries
from roslab.evidence.ros.vcs import submodules
from roslab.repository.checkout import Repository

PLAIN = '[submodule "a"]\n\tpath = third/a\n\turl = https://host.test/a.git\n\tbranch = main\n'
TEXTS = (
    PLAIN,
    '[submodule "a"]\n\tpath = "third/a"\n\turl = "https://host.test/a.git"\n\tbranch = "main"\n',
    '[submodule "a"]\r\n\tPath = third/a ; where\r\n\tURL=https://host.test/a.git # which\r\n\tbranch = main\r\n',
    '# a\n[submodule "a"] path = third/a\nurl = old\nurl = https://host.test/a.git\nbranch = main\n[core]\npath=b\n',
    '[submodule "a"]\n\tpath = third/\\\na\n\turl = https://host.test/"a".git\n\tbranch = main\n',
)


@pytest.mark.parametrize("text", TEXTS)
def test_each_way_to_write_it_says_the_same(tmp_path: Path, text: str) -> None:
    (found,) = entries(text)
    assert (found.name, found.path, found.url, found.branch) == ("a", "third/a", "https://host.test/a.git", "main")
    file = tmp_path / ".gitmodules"
    file.write_text(text)
    for key, value in (("path", found.path), ("url", found.url)):  # git itself
        said = subprocess.run(
            ["git", "config", "--file", str(file), f"submodule.a.{key}"], capture_output=True, text=True, check=True
        )
        assert said.stdout.strip() == value


def test_the_line_is_that_of_the_address() -> None:
    text = f'{PLAIN}[submodule "b c"]\n\tpath = "b # c"\n\turl = https://host.test/b.git\n[submodule "n"]\n\turl = x\n'
    assert [(each.name, each.path, each.line) for each in entries(text)] == [("a", "third/a", 3), ("b c", "b # c", 7)]


CMAKE = """\
cmake_minimum_required(VERSION 3.5)
project(top)
find_package(fmt 8)
add_executable(run a.cpp)
target_link_libraries(run a::a)
install(DIRECTORY third/a/include/ DESTINATION include)
"""


@pytest.mark.parametrize("text", TEXTS)
def test_every_reader_knows_the_folder(tmp_path: Path, text: str) -> None:
    for name, written in {".gitmodules": text, "CMakeLists.txt": CMAKE, "a.cpp": "int main() {}\n"}.items():
        (tmp_path / name).write_text(written)
    repository = Repository.open(tmp_path)
    assert submodules(repository) == ("third/a",)
    (project,) = gather(repository).cmake
    assert project.not_there == ()
    assert not [each.target for each in project.dependencies if each.target]
