"""C and C++ that a Makefile of the author's compiles, without CMake."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
MADE = "CXX = g++\nTARGET = slam\n\nall: $(TARGET)\n\n$(TARGET): main.o map.o\n\t$(CXX) -o $@ $^ -lfftw3 -lpthread\n"
CODE = {"main.cpp": "#include <Eigen/Dense>\nint main() {}\n", "map.cpp": "#include <vector>\n"}
SCRIPT = {"scripts/plot.py": "import numpy\nif __name__ == '__main__':\n    show()\n"}
PAGE = {"README.md": "```\nmake\n./slam data/00\n```\n"}


def test_a_makefile_is_run_and_helper_scripts_make_no_python_repository(tree: Tree) -> None:
    decision = tree({**CODE, **SCRIPT, **PAGE, "Makefile": MADE})
    assert (decision.kind, decision.build_tool, decision.command) == ("cpp", "none", ("./slam", "data/00"))
    assert [(script.folder, script.command) for script in decision.scripts] == [("", "make")]
    assert {"libeigen3-dev", "libfftw3-dev"} <= {*decision.apt, *decision.apt_guessed}


def test_make_runs_in_the_image(tmp_path: Path) -> None:
    for path, text in (CODE | PAGE | {"Makefile": MADE}).items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    plan = plan_repository(tmp_path).plan
    assert "build-essential" in plan.apt
    text = dockerfile(plan)
    assert "make" in text
    assert "{ make || echo" not in text


OPENCV = "CC = g++\nEXECUTABLE = filter.bin\nLDFLAGS = $(shell pkg-config opencv --libs)\nall: $(EXECUTABLE)\n"
LINKS = "\t$(CC) *.cpp $(LDFLAGS) -o $@\n"


@pytest.mark.parametrize(
    ("files", "command", "required"),
    [
        ({"Makefile": f"{OPENCV}$(EXECUTABLE):\n{LINKS}"}, ("./filter.bin",), True),
        ({"Makefile": f"{OPENCV}BIN = other\n$(EXECUTABLE):\n{LINKS}"}, ("bash",), True),
        ({"Makefile": f"{OPENCV}\t$(CC) a.cpp -o tool\n"}, ("bash",), True),
        ({"Makefile": f"{OPENCV.replace('filter.bin', 'libfilter.so')}{LINKS}"}, ("bash",), True),
        ({"Makefile": f"{OPENCV.replace('EXECUTABLE', 'MAIN')}$(MAIN): $(OBJS)\n{LINKS}"}, ("./filter.bin",), True),
        ({"a/Makefile": f"{OPENCV}{LINKS}", "b/Makefile": f"{OPENCV}{LINKS}"}, ("bash",), False),
    ],
    ids=["one", "two", "named-in-a-line", "library", "another-variable", "folders"],
)
def test_the_makefile_that_is_the_project(
    tree: Tree, files: dict[str, str], command: tuple[str, ...], *, required: bool
) -> None:
    decision = tree({**CODE, **files})
    assert decision.command == command
    assert {script.required for script in decision.scripts} == {required}
    assert ("libopencv-dev" in decision.apt) is required
    assert "libopencv-dev" in {*decision.apt, *decision.apt_guessed}


@pytest.mark.parametrize(
    ("rules", "call", "command"),
    [
        ("$(MAIN): main.o\n\t$(CXX) main.o -o $@\n", "./swing", ("./swing",)),
        ("$(MAIN): main.o\n\t$(CXX) main.o -o $@\nrun: $(MAIN)\n\t./$(MAIN)\n", "make run", ("./swing",)),
        ("all: main.o\n\t$(CXX) main.o -o $(OUT)/$(MAIN) -lm\n", "./bin/swing --fast", ("./bin/swing", "--fast")),
        ("$(NONE): main.o\n\t$(CXX) main.o -o $@\n", "./swing", ("bash",)),
    ],
)
def test_a_program_whose_name_is_a_variable(tree: Tree, rules: str, call: str, command: tuple[str, ...]) -> None:
    page = {"README.md": f"# Swing\n\nTo start it:\n```\nmake\n{call}\n```\n"}
    assert tree({**CODE, **page, "Makefile": f"MAIN := swing\nOUT = bin\n{rules}"}).command == command


def test_makefiles_of_folders_are_run_where_the_root_has_none(tree: Tree) -> None:
    files = {f"{folder}/{path}": text for folder in ("front", "back") for path, text in CODE.items()}
    made = {"front/Makefile": MADE, "back/Makefile": MADE.replace("slam", "solve")}
    page = {"README.md": "```\ncd back\nmake\n./solve\n```\n"}
    decision = tree({**files, **made, **page})
    assert [script.folder for script in decision.scripts] == ["back", "front"]
    assert (decision.kind, decision.command) == ("cpp", ("./back/solve",))


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"Makefile": "docs:\n\tsphinx-build . out\n"}, "python"),
        ({"Makefile": "test:\n\tpytest\n"}, "python"),
        ({"Makefile": MADE, "a.py": "import os\n", "b.py": "import os\n", "c.py": "import os\n"}, "python"),
        ({"Makefile": MADE, "setup.py": "from setuptools import setup\nsetup(name='demo')\n"}, "python"),
        ({"Makefile": MADE, "CMakeLists.txt": "project(demo)\nadd_executable(demo main.cpp)\n"}, "cpp"),
        ({"third_party/odd/Makefile": MADE}, "python"),
    ],
)
def test_what_is_no_makefile_of_the_project(tree: Tree, files: dict[str, str], kind: str) -> None:
    decision = tree({**CODE, **SCRIPT, **files})
    assert (decision.kind, decision.scripts) == (kind, ())


@pytest.mark.parametrize(
    ("rule", "command"),
    [
        ("build/%: %.cpp\n\t$(CXX) -o $@ $<\n", ("./build/show-map", "data/00")),
        (
            "SOURCES = $(wildcard *.cpp)\nall:\n\tfor f in $(SOURCES); do $(CXX) $$f; done\n",
            ("./build/show-map", "data/00"),
        ),
        ("all:\n\t$(CXX) -o build/other other.cpp\n", ("bash",)),
    ],
    ids=["rule", "list", "another"],
)
def test_a_rule_for_any_file_makes_the_programs_that_have_a_main(
    tree: Tree, rule: str, command: tuple[str, ...]
) -> None:
    page = {"README.md": "# Run\n```\nmake\n./build/show-map data/00\n./build/library\n```\n"}
    files = {"show-map.cpp": CODE["main.cpp"], "library.cpp": CODE["map.cpp"], "Makefile": rule}
    assert tree({**files, **page}).command == command


RULES = {
    "Mk/rules.mk": "$(OBJS): %.o: %.cpp\n\t$(CXX) -c $< -o $@\n$(TARGET): $(OBJS)\n\t$(CXX) -o $@ $(OBJS) $(LIBS)\n"
}
INCLUDING = "include Mk/libs.mk\nOBJS=main.o map.o\nTARGET=slam\ninclude Mk/rules.mk\n"


def test_what_a_makefile_includes_is_its_own(tree: Tree) -> None:
    below = {"solver/Makefile": MADE.replace("slam", "solve"), "solver/main.cpp": "int main() {}\n"}
    decision = tree({**CODE, **RULES, **below, "Makefile": INCLUDING, "Mk/libs.mk": "LIBS += -lfftw3\n"})
    assert [(script.folder, script.required) for script in decision.scripts] == [("", True)]
    assert decision.command == ("./slam",)
    assert "libfftw3-dev" in {*decision.apt, *decision.apt_guessed}


def test_an_included_file_that_calls_cmake_for_a_library_does_not_make_it_another_builder(tree: Tree) -> None:
    rules = {"Mk/rules.mk": RULES["Mk/rules.mk"] + "flann:\n\tcd lib/flann; cmake ..; make\n"}
    decision = tree({**CODE, **rules, "Makefile": INCLUDING})
    assert [script.command for script in decision.scripts] == ["make slam"]  # its first target is an object


def test_a_program_that_reads_above_is_started_where_it_is_made(tree: Tree) -> None:
    files = {f"sources/{path}": text for path, text in {**CODE, "Makefile": MADE}.items()}
    page = {"README.md": "```\n./slam --map=../data/a.txt\n```\n", "data/a.txt": ""}
    assert tree({**files, **page}).command == "cd sources && exec ./slam --map=../data/a.txt"


MODULE = {".gitmodules": '[submodule "crl"]\n\tpath = crl\n\turl = https://github.com/comrob/crl.git\n'}


@pytest.mark.parametrize(("script", "commands"), [("install.sh", ["bash install.sh", "make"]), ("start.sh", ["make"])])
def test_scripts_of_a_submodule_run_before_make(tree: Tree, script: str, commands: list[str]) -> None:
    page = f"# Demo\nCompile the submodule<br />\n`cd crl ; ./{script} ; cd ..`<br />\n\nRun<br />\n`./slam`\n"
    decision = tree({**CODE, **MODULE, "Makefile": MADE, "README.md": page})
    assert [each.command for each in decision.scripts] == commands
    assert decision.scripts[-1].required
    assert decision.command == ("./slam",)


def test_the_image_says_that_make_is_the_build_where_the_script_of_a_submodule_comes_first(tree: Tree) -> None:
    page = "# Demo\nCompile the submodule<br />\n`cd crl ; ./install.sh ; cd ..`<br />\n\nRun<br />\n`./slam`\n"
    decision = tree({**CODE, **MODULE, "Makefile": MADE, "README.md": page})
    assert [script.required for script in decision.scripts] == [False, True]
    text = dockerfile(make_plan(decision, Config(), folder_name="demo", ignore=()))
    assert "# What the script of the repository compiles\n" in text
    assert "# What is compiled beside the program" not in text


WINDOWS = "CXX = g++\nOBJECTS = $(patsubst %.cpp,%.o,$(wildcard *.cpp))\nsim.exe: $(OBJECTS)\n\t$(CXX) -o $@ $^\n"


@pytest.mark.parametrize(
    ("folder", "argv"),
    [("design/sim", ("./design/sim/sim.exe",)), ("a/b/c", ("./a/b/c/sim.exe",)), ("a/b/c/d", ("bash",))],
)
def test_a_makefile_further_down_where_no_other_is(tree: Tree, folder: str, argv: tuple[str, ...]) -> None:
    files = {f"{folder}/{path}": text for path, text in CODE.items()}
    decision = tree({**files, f"{folder}/Makefile": WINDOWS})
    assert (decision.kind, decision.command) == ("cpp", argv)
    assert [script.folder for script in decision.scripts] == ([folder] if argv != ("bash",) else [])
    assert any("nothing shows how it is compiled" in each.message for each in decision.warnings) is (argv == ("bash",))


def test_one_further_down_does_not_count_beside_one_that_is_near(tree: Tree) -> None:
    decision = tree({**CODE, "app/Makefile": MADE, "app/parts/inner/Makefile": WINDOWS})
    assert [script.folder for script in decision.scripts] == ["app"]


def test_a_makefile_that_compiles_for_windows_is_none_of_linux(tree: Tree) -> None:
    assert tree({**CODE, "Makefile": WINDOWS.replace("g++", "x86_64-w64-mingw32-g++")}).scripts == ()


def test_the_name_for_windows_is_none_beside_that_of_linux(tree: Tree) -> None:
    both = "CXX = g++\nifdef COMSPEC\nTARGET = sim.exe\nelse\nTARGET = sim\nendif\n$(TARGET):\n\t$(CXX) *.cpp -o $@\n"
    page = {"README.md": "```\nmake\n./sim\n./sim.exe\n```\n"}
    assert tree({**CODE, **page, "Makefile": both}).command == ("./sim",)


def test_what_the_tree_holds_is_made_anew(tree: Tree) -> None:
    old = {"design/sim/sim.exe": "MZ", "design/sim/main.cpp": CODE["main.cpp"], "design/sim/Makefile": WINDOWS}
    assert [script.command for script in tree(old).scripts] == ["make --always-make"]


def test_c_and_cpp_alone_are_no_python(tree: Tree) -> None:
    decision = tree({"firmware/main.c": "#include <odd/motor.h>\nint main(void) {}\n"})
    assert (decision.kind, decision.build_tool, decision.scripts) == ("cpp", "none", ())
    assert "python3-venv" not in decision.apt
    assert any("nothing shows how it is compiled" in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("more", "told"), [({}, "mex compiles it"), ({"b.cpp": "#include <odd/motor.h>\n"}, "nothing shows")]
)
def test_what_matlab_compiles_is_no_code_without_a_build(tree: Tree, more: dict[str, str], told: str) -> None:
    decision = tree(
        {"utils/read.cpp": '#include "mex.h"\nvoid mexFunction() {}\n', "utils/make.m": "mex read.cpp", **more}
    )
    assert [told in each.message for each in decision.warnings if "nothing is compiled" in each.message] == [True]


def test_a_makefile_is_something_to_build_whatever_the_code_includes(tmp_path: Path) -> None:
    for name, text in {"main.c": "#include <stdio.h>\nint main(void) {}\n", "Makefile": MADE}.items():
        (tmp_path / name).write_text(text)
    assert plan_repository(tmp_path).decision.kind == "cpp"


def test_files_that_include_each_other_without_end_are_read_so_far(tree: Tree) -> None:
    chain = {f"a{number}.mk": f"include a{number + 1}.mk\n" for number in range(400)}
    decision = tree({**CODE, **PAGE, **chain, "Makefile": f"include a0.mk\n{MADE}"})
    assert [(script.folder, script.command) for script in decision.scripts] == [("", "make")]


BELOW = {"lib/Makefile": MADE, **{f"lib/{path}": text for path, text in CODE.items()}}


@pytest.mark.parametrize(
    "rule",
    [
        "all:\n\tcd lib && make all\n",
        "all:\n\tcd ./lib; $(MAKE)\n",
        "all:\n\tmake -C lib all\n",
        "all:\n\t$(MAKE) --directory=lib\n",
        "DIRS = lib other\nall:\n\tfor d in $(DIRS); do make -C $$d; done\n",
        "all:\n\tfor d in lib other; do \\\n\t  (cd $${d} && make); \\\n\tdone\n",
        "all:\n\tcd middle && make\n",
    ],
)
def test_a_makefile_that_calls_those_of_folders_builds_the_tree(tree: Tree, rule: str) -> None:
    middle = {"middle/Makefile": "all:\n\tcd ../lib && make\n"}
    decision = tree({**BELOW, **middle, "Makefile": rule, "README.md": "```\nmake\n./lib/slam\n```\n"})
    assert [(each.folder, each.command, each.required) for each in decision.scripts] == [("", "make", True)]
    assert decision.command == ("./lib/slam",)
    assert "libfftw3-dev" in {*decision.apt, *decision.apt_guessed}


@pytest.mark.parametrize("rule", ["all:\n\tcd 3rdparty && make\n", "all:\n\tcd none && make\n", "all:\n\techo make\n"])
def test_a_makefile_that_calls_no_other_of_the_tree_builds_nothing(tree: Tree, rule: str) -> None:
    decision = tree({**CODE, "Makefile": rule, "3rdparty/Makefile": MADE})
    assert decision.scripts == ()


def test_a_library_that_lies_in_the_tree_with_its_configure_is_no_build_of_the_tree(tree: Tree) -> None:
    vendored = {"3rdparty/matio/configure": "#!/bin/sh\n", "3rdparty/other/CMakeLists.txt": "project(other)\n"}
    assert [each.command for each in tree({**CODE, "Makefile": MADE, **vendored}).scripts] == ["make"]
    assert tree({**CODE, "Makefile": MADE, "configure": "#!/bin/sh\n"}).scripts == ()


@pytest.mark.parametrize(
    ("page", "scripts"),
    [
        ("cd sources\nmake all", [("sources", "make all")]),
        ("git clone https://github.com/a/demo\ncd demo/sources\nmake -j4 fast", [("sources", "make fast")]),
        ("cd sources/apps/deep\nmake all", [("sources/apps/deep", "make all"), ("sources", "make")]),
        ("cd sources\nmake test", [("sources", "make")]),
        ("cd other\nmake all", [("sources", "make")]),
        ("cd sources\nmake clean all", [("sources", "make")]),
    ],
)
def test_the_folder_and_the_target_of_the_page(tree: Tree, page: str, scripts: list[tuple[str, str]]) -> None:
    files = {f"sources/{path}": text for path, text in {**CODE, "Makefile": MADE}.items()}
    deep = {"sources/apps/deep/Makefile": MADE, "sources/apps/deep/main.cpp": CODE["main.cpp"]}
    decision = tree({**files, **deep, "README.md": f"# Build\n```\n{page}\n```\n"})
    assert [(each.folder, each.command) for each in decision.scripts] == scripts


def test_a_folder_in_which_another_makefile_calls_make_is_built_by_that_one(tree: Tree) -> None:
    decision = tree({**BELOW, "all/Makefile": "all:\n\tmake -C ../lib\n"})
    assert [each.folder for each in decision.scripts] == ["all"]
