"""What a page makes beside a workspace, and programs for one processor that code of the workspace starts."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.decide.platforms import AMD64, ARM64
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
CMAKE = "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(demo a.cpp)\n"
STARTS = '#include <cstdlib>\nint main() { return system("cd /tmp && ./salesman problem.par"); }\n'
MAKEFILE = "all:\n\t$(MAKE) -C src all\n"
PAGE = "# Demo\nROS Noetic\n\n## Installation\n```\ngit clone https://github.com/lab/demo.git\ncd demo\ncatkin_make\n"
MADE = "cd planner/salesman\nmake\n"


def _files(*, page: str = MADE, code: str = STARTS, makefile: str = MAKEFILE) -> dict[str, str]:
    files = {"package.xml": PACKAGE, "CMakeLists.txt": CMAKE, "a.cpp": code, "README.md": f"{PAGE}{page}```\n"}
    return files | ({"planner/salesman/Makefile": makefile} if makefile else {})


def _program(folder: Path, *, machine: bytes = b"\x3e\x00", kind: bytes = b"\x03\x00") -> None:
    path = folder / "planner/salesman/salesman"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(b"\x7fELF\x02\x01\x01" + bytes(9) + kind + machine + bytes(5000))


@pytest.mark.parametrize(
    ("page", "makefile", "command"),
    [
        (MADE, MAKEFILE, "make"),
        (MADE.replace("planner", "demo/planner"), MAKEFILE, "make"),
        ("cd planner/salesman && make -j4 solver\n", "solver: a.o\n\tg++ -o solver a.o\n", "make solver"),
        ("cd planner/salesman\nmake clean\n", MAKEFILE, ""),
        ("cd planner/salesman\nmake serve\n", "all: a\na: a.c\n\tgcc -o a a.c\nserve: a\n\t./a\n", ""),
        ("cd planner/salesman\nmake tour\n", "all: a\na: a.c\n\tgcc -o a a.c\ntour: a\n\t./a\n", ""),
        ("cd planner/salesman\nmake tour\n", "tour: a.c\n\tgcc -o a a.c\n\t./a\n", ""),
        ("cd planner/salesman\nmake tour\n", "tour: a b\na b: a.c\n\tgcc -o $@ a.c\n", "make tour"),
        ("cd planner/salesman\nmake a\n", "NAME = a\n$(NAME): a.c\n\tgcc -o $@ a.c\n", "make a"),
        ("cd planner/salesman\nmake sim\n", "sim: a.c\n\tgcc -o a a.c\n", ""),
        (MADE, "all:\n\tcmake .. && make\n", ""),
        (MADE, "", ""),
        ("make\n", MAKEFILE, ""),
    ],
    ids=[
        *("below", "above", "target", "clean", "serve", "started", "compiled and started", "of others"),
        *("by a variable", "sim", "CMake", "no Makefile", "root"),
    ],
)
def test_a_folder_that_the_page_makes_is_made(tree: Tree, page: str, makefile: str, command: str) -> None:
    decision = tree(_files(page=page, makefile=makefile))
    found = [(each.folder, each.command, each.after, each.required) for each in decision.scripts]
    assert found == ([("planner/salesman", command, True, False)] if command else [])


def test_it_is_made_once_the_workspace_is_built(tmp_path: Path) -> None:
    tree_of(tmp_path, _files())
    text = dockerfile(plan_repository(tmp_path).plan)
    made = text.index("/planner/salesman \\\n && { make || echo")
    assert text.index("headers-first catkin_make") < made


def test_a_program_that_is_there_already_is_made_anew(tree: Tree, tmp_path: Path) -> None:
    _program(tmp_path)
    decision = tree(_files())
    assert [each.command for each in decision.scripts] == ["make --always-make"]
    assert decision.platforms == (AMD64, ARM64)


@pytest.mark.parametrize(
    ("code", "refused"),
    [
        (STARTS, True),
        (STARTS.replace("./salesman", "planner/salesman/salesman"), True),
        (STARTS.replace('"cd /tmp && ./', 'folder + "/'), True),
        (STARTS.replace('system("cd', 'system(line.c_str()); line = ("cd'), True),
        (STARTS.replace("./salesman", "/usr/bin/other"), False),
        (STARTS.replace("./salesman", "/usr/bin/salesman"), False),
        (f'{STARTS.replace("./salesman", "ls")}const char *topic = "/planner/salesman";\n', False),
        (STARTS.replace("system", "printf"), False),
        (f"#ifdef __aarch64__\n#endif\n{STARTS}", False),
    ],
    ids=["here", "by its path", "joined", "variable", "another", "system", "other text", "not started", "chooses"],
)
def test_a_program_for_amd64_that_the_code_starts_rules_out_arm64(
    tree: Tree, tmp_path: Path, code: str, *, refused: bool
) -> None:
    _program(tmp_path)
    decision = tree(_files(page="", code=code))
    assert (decision.platforms == (AMD64,)) is refused
    if refused:
        said = "the code starts planner/salesman/salesman, which is compiled for amd64 only"
        assert dict(decision.platforms_refused)[ARM64].startswith(said)


@pytest.mark.parametrize(("machine", "kind"), [(b"\xb7\x00", b"\x03\x00"), (b"\x3e\x00", b"\x01\x00")])
def test_a_program_for_another_processor_and_an_object_do_not(
    tree: Tree, tmp_path: Path, machine: bytes, kind: bytes
) -> None:
    _program(tmp_path, machine=machine, kind=kind)
    assert tree(_files(page="")).platforms == (AMD64, ARM64)


def test_a_program_that_cmake_makes_does_not(tree: Tree, tmp_path: Path) -> None:
    _program(tmp_path)
    files = _files(page="")
    files["CMakeLists.txt"] += "add_executable(salesman b.cpp)\n"
    assert tree(files | {"b.cpp": "int main() {}\n"}).platforms == (AMD64, ARM64)
