"""Submodules that are not checked out are cloned in the image, at the commits that the repository records."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import linked

Tree = Callable[[dict[str, str]], Decision]
COMMIT = "0dbfc6e1cb0bd7fc209bee6de83c01b49ac9398a"
PACKAGE = (
    "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>catkin_simple</depend></package>"
)
MODULES = """\
[submodule "planner"]
\tpath = third_party/planner
\turl = git@github.com:lab/planner.git
[submodule "simple"]
\tpath = catkin_simple
\turl = https://github.com/catkin/catkin_simple.git
"""
FILES = {
    "package.xml": PACKAGE,
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED COMPONENTS catkin_simple)\n",
    ".gitmodules": MODULES,
}


def test_they_are_cloned_once_and_by_https(tree: Tree) -> None:
    decision = tree(FILES)
    assert [(s.name, s.repo, s.ref) for s in decision.submodules] == [
        ("third_party/planner", "https://github.com/lab/planner.git", None),
        ("catkin_simple", "https://github.com/catkin/catkin_simple.git", None),
    ]
    assert decision.source == ()  # not cloned a second time, as a sister


def test_what_is_checked_out_is_not_cloned(tree: Tree) -> None:
    there = {"third_party/planner/a.txt": "", "catkin_simple/src/a.txt": ""}
    assert tree({**FILES, **there}).submodules == ()


@pytest.mark.parametrize("path", ["../planner", "a/../../b", "a b"])
def test_no_path_leads_out_of_the_repository(tree: Tree, path: str) -> None:
    modules = f'[submodule "a"]\n\tpath = {path}\n\turl = https://github.com/lab/planner.git\n'
    assert tree({**FILES, ".gitmodules": modules}).submodules == ()


def test_the_recorded_commit_is_cloned(tmp_path: Path) -> None:
    linked(tmp_path, FILES, COMMIT, "third_party/planner")
    text = dockerfile(plan_repository(tmp_path).plan)
    folder = f"ws/src/{plan_repository(tmp_path).plan.name}/third_party/planner"
    assert f"git clone https://github.com/lab/planner.git /home/${{NB_USER}}/{folder}" in text
    assert f"checkout-commit /home/${{NB_USER}}/{folder} {COMMIT}" in text
    assert "COPY --from=scripts /checkout-commit " in text
    said = [w.message for w in plan_repository(tmp_path).plan.warnings if w.file == ".gitmodules"]
    assert [("planner" in message, "catkin_simple" in message) for message in said] == [(True, False), (False, True)]
    assert ["git submodule update" in message for message in said] == [True, False]
    assert text.index(COMMIT) < text.index(" && install-rosdep-keys") < text.index("\nCOPY --chown")


@pytest.mark.parametrize("lost", ["ycb", ""])
def test_the_advice_names_what_has_an_address_where_git_would_stop_at_another(tmp_path: Path, lost: str) -> None:
    linked(tmp_path, FILES, COMMIT, *filter(None, ("third_party/planner", lost)))
    said = next(w.message for w in plan_repository(tmp_path).plan.warnings if "git submodule update" in w.message)
    command = said.partition("git submodule update --init --recursive")[2]
    named = " third_party/planner (.gitmodules has no address for ycb, which stays empty)"
    assert command == (named if lost else "")


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("git clone https://github.com/lab/planner", [("src/planner", "https://github.com/lab/planner", COMMIT)]),
        ("git clone https://github.com/lab/planner other", []),
        ("git clone https://github.com/lab/core", []),  # the tree has it
        ("git clone https://github.com/lab/more", []),
    ],
)
def test_a_commit_without_an_address_is_of_what_a_page_clones(
    tmp_path: Path, line: str, found: list[tuple[str, str, str]]
) -> None:
    package = {
        "src/core/package.xml": PACKAGE.replace("catkin_simple", "acme_msgs"),
        "src/core/CMakeLists.txt": FILES["CMakeLists.txt"].replace("catkin_simple", "acme_msgs"),
        "src/core/README.md": f"ROS Noetic\n\n    cd src\n    {line}\n",
    }
    linked(tmp_path, package, COMMIT, "src/planner", "extra/src/planner")
    plan = plan_repository(tmp_path).plan
    assert [
        (each.name, (each.repo or "").removesuffix(".git"), each.ref) for each in plan.workspace.submodules
    ] == found
    assert not (found and any("not cloned" in each.message for each in plan.warnings))


@pytest.mark.parametrize(
    ("recorded", "cloned"),
    [
        (("src/planner",), [("src/planner", COMMIT)]),
        (("old/planner", "src/planner"), [("old/planner", COMMIT)]),
        (("src/planner", "lib/planner"), [("old/planner", None)]),
        (("src/other",), [("old/planner", None)]),
    ],
)
def test_a_submodule_that_was_moved_keeps_its_address(
    tmp_path: Path, recorded: tuple[str, ...], cloned: list[tuple[str, str | None]]
) -> None:
    modules = '[submodule "planner"]\n\tpath = old/planner\n\turl = https://github.com/lab/planner.git\n'
    linked(tmp_path, {**FILES, ".gitmodules": modules}, COMMIT, *recorded)
    for path in recorded:
        (tmp_path / path).mkdir(parents=True)
    plan = plan_repository(tmp_path).plan
    assert [(each.name, each.ref) for each in plan.workspace.submodules] == cloned
    told = " ".join(each.message for each in plan.warnings)
    assert ("nothing tells its address" in told) == (len(recorded) + (cloned[0][1] is None) > 1)
    first = f"git config -f .gitmodules submodule.planner.path {cloned[0][0]} && git submodule update --init"
    assert (first in told) == (cloned[0][1] is not None and cloned[0][0] != "old/planner")


def test_a_library_that_a_submodule_links_is_built(tree: Tree) -> None:
    url = "https://github.com/Livox-SDK/livox_ros_driver"
    modules = f'[submodule "a"]\n\tpath = third_party/livox_ros_driver\n\turl = {url}\n'
    decision = tree({**FILES, "README.md": "ROS Noetic", ".gitmodules": modules})
    assert "livox-sdk" in [source.name for source in decision.source]
    modules = modules.replace("Livox-SDK", "somebody-else")
    assert "livox-sdk" not in [source.name for source in tree({**FILES, ".gitmodules": modules}).source]


MAIN = "if __name__ == '__main__':\n    pass\n"


@pytest.mark.parametrize(
    ("module", "line", "places"),
    [
        ("main.py", "sys.path.append('Net/src')", ["Net"]),
        ("src/main.py", "sys.path.append('../Net/src/heads')", ["Net"]),
        ("src/main.py", "sys.path.insert(0, os.path.join(os.path.dirname(__file__), 'libs', 'Net'))", ["src/libs/Net"]),
        ("src/main.py", "sys.path.append('third_party/Net')", ["third_party/Net"]),
        ("main.py", "sys.path.append('../Net')", []),
        ("main.py", "sys.path.append('/home/me/code/Net')", []),
        ("main.py", "sys.path.insert(0, '~/Net')", []),
        ("main.py", "sys.path.append(ROOT + '/Net/src')", ["Net"]),
        ("main.py", "sys.path.append('Network/src')", []),
        ("main.py", "print('Net/src')", []),
    ],
)
def test_what_a_page_clones_where_the_code_imports_it(tree: Tree, module: str, line: str, places: list[str]) -> None:
    page = "# Install\n```\ngit clone https://github.com/lab/Net\n```\n"
    files = {module: f"import os, sys\n{line}\n{MAIN}", "requirements.txt": "numpy\n", "README.md": page}
    assert [source.name for source in tree(files).submodules] == places
    there = {f"{place}/readme.txt": "" for place in places}
    assert not places or tree({**files, **there}).submodules == ()


@pytest.mark.parametrize("start", ["Clone this repository:\n", ""])
def test_the_repository_is_not_cloned_into_itself(tree: Tree, start: str) -> None:
    origin = {".git/config": '[remote "origin"]\n\turl = https://github.com/lab/Net.git\n'} if not start else {}
    page = f"# Install\n{start}```\ngit clone https://github.com/lab/Net\n```\n"
    files = {"main.py": f"import sys\nsys.path.append('Net/src')\n{MAIN}", "requirements.txt": "numpy\n"}
    assert tree({**files, **origin, "README.md": page}).submodules == ()


CARRIES = '[submodule "a"]\n\tpath = deps/yaml-cpp\n\turl = https://github.com/lab/yaml-cpp.git\n'
TOP = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\n{}add_executable(a a.cpp)\n"


@pytest.mark.parametrize(
    ("cmake", "more", "told"),
    [
        ("find_package(PkgConfig REQUIRED)\npkg_check_modules(YAML REQUIRED yaml-cpp)\n", {}, True),
        ("find_package(yaml-cpp REQUIRED)\n", {}, True),
        ("find_package(yaml-cpp)\n", {}, False),
        ("find_package(Eigen3 REQUIRED)\n", {}, False),
        (
            "add_subdirectory(deps/yaml-cpp)\nfind_package(yaml-cpp REQUIRED)\n",
            {"deps/yaml-cpp/CMakeLists.txt": "project(YAML_CPP)\nadd_library(yaml-cpp y.cpp)\n"},
            False,
        ),
        ("add_subdirectory(deps/yaml-cpp)\nfind_package(yaml-cpp REQUIRED)\n", {}, False),  # not checked out
        ("add_subdirectory(${CMAKE_SOURCE_DIR}/deps/yaml-cpp yaml)\nfind_package(yaml-cpp REQUIRED)\n", {}, False),
        ("add_subdirectory(deps/yaml)\nfind_package(yaml-cpp REQUIRED)\n", {}, True),
    ],
)
def test_the_distributions_library_in_place_of_a_submodule_is_told(
    tree: Tree, cmake: str, more: dict[str, str], *, told: bool
) -> None:
    files = {".gitmodules": CARRIES, "CMakeLists.txt": TOP.format(cmake), "a.cpp": "int main() {}\n"}
    warnings = [w.message for w in tree(files | more).warnings if "as the submodule deps/yaml-cpp" in w.message]
    assert bool(warnings) == told


PLAY = {"play.py": f"import numpy\nfrom brumby.utils import load\n{MAIN}", "requirements.txt": "numpy\n"}


@pytest.mark.parametrize(
    "url",
    [
        "git@github.com:lab/brumby_control.git",
        "ssh://git@github.com/lab/brumby_control.git",
        "git://github.com/lab/brumby_control.git",
        "https://github.com/lab/brumby_control.git",
    ],
)
def test_an_address_of_ssh_is_cloned_by_https(tmp_path: Path, url: str) -> None:
    page = f"# Install\n```\ngit clone {url}\n```\n# Run\n```\npython play.py\n```\n"
    linked(tmp_path, {"README.md": page, **PLAY}, COMMIT, "brumby_control")
    plan = plan_repository(tmp_path).plan
    modules = [(each.name, each.repo, each.ref) for each in plan.workspace.submodules]
    assert modules == [("brumby_control", "https://github.com/lab/brumby_control.git", COMMIT)]
    (told,) = [each for each in plan.warnings if "is called like it" in each.message]
    assert (told.file, told.line) == ("play.py", 2)
    assert told.message.startswith(
        "brumby is imported, and brumby_control, which is not checked out, is called like it"
    )
    text = dockerfile(plan)  # what it holds is unknown: the package may lie at its top, or in its own folder
    for folder in ("brumby_control", "brumby_control/brumby"):
        assert f"--editable ./{folder} || echo 'roslab: left out: pip cannot install {folder}'; \\\n" in text
        assert f"if [ -e ./{folder}/setup.py ] || [ -e ./{folder}/pyproject.toml ]; then" in text


@pytest.mark.parametrize(
    ("code", "page", "folders"),
    [
        ("import brumby_control", "", ("brumby_control", "brumby_control/brumby_control")),
        ("import brumby", "pip install -e brumby_control/brumby\n", ("brumby_control/brumby",)),  # the page says where
        ("import control", "", ()),  # the end of its name, and a package of pip's index
        ("try:\n    import brumby\nexcept ImportError:\n    pass", "", ()),
        ("import brumbys", "", ()),
    ],
)
def test_a_submodule_is_installed_where_the_code_imports_it(
    tree: Tree, code: str, page: str, folders: tuple[str, ...]
) -> None:
    modules = '[submodule "a"]\n\tpath = brumby_control\n\turl = https://github.com/lab/brumby_control.git\n'
    files = {"play.py": f"import numpy\n{code}\n{MAIN}", "requirements.txt": "numpy\n", ".gitmodules": modules}
    python = tree({**files, "README.md": f"# Run\n```\n{page}python play.py\n```\n"}).python
    assert python.projects == python.unseen == folders
    assert python.imported == (() if page else folders)


@pytest.mark.parametrize("names", [("one", "two"), ("one", "two", "three")])
def test_of_several_submodules_that_a_page_installs_one_may_fail(tree: Tree, names: tuple[str, ...]) -> None:
    modules = "".join(f'[submodule "{n}"]\n\tpath = {n}\n\turl = https://github.com/lab/{n}.git\n' for n in names)
    page = "# Run\n```\n" + "".join(f"pip install -e {name}\n" for name in names) + "python play.py\n```\n"
    python = tree({**PLAY, "README.md": page, ".gitmodules": modules}).python
    assert python.projects == python.unseen == names
    assert python.imported == (names if len(names) > 2 else ())


def test_a_submodule_that_cannot_be_cloned_is_told(tree: Tree) -> None:
    modules = '[submodule "a"]\n\tpath = planner\n\turl = ../planner.git\n'  # of an origin that nothing tells
    decision = tree({**PLAY, ".gitmodules": modules})
    assert decision.submodules == ()
    (told,) = [each for each in decision.warnings if "is empty in the image" in each.message]
    assert told.message.startswith("planner is empty in the image, and what needs it stops: ../planner.git is no addr")
    assert (told.file, told.line) == (".gitmodules", 3)


@pytest.mark.parametrize(
    ("more", "cloned"),
    [
        ({}, False),
        ({"README.md": "Weights are in training/brumby_net/last.pth.\n"}, False),
        ({"README.md": "```\npip install -e training/brumby_net\n```\n"}, True),
        ({"CMakeLists.txt": "project(a)\nadd_subdirectory(training/brumby_net)\n"}, True),
        ({"play.py": f"import sys\nsys.path.append('training/brumby_net')\nimport numpy\n{MAIN}"}, True),
    ],
)
def test_an_entry_that_the_commit_has_no_more_is_cloned_where_it_is_needed(
    tmp_path: Path, more: dict[str, str], *, cloned: bool
) -> None:
    modules = '[submodule "a"]\n\tpath = training/brumby_net\n\turl = https://github.com/lab/brumby_net.git\n'
    files = {"play.py": f"import numpy\n{MAIN}", "requirements.txt": "numpy\n", ".gitmodules": modules}
    linked(tmp_path, {**files, **more}, COMMIT, "other")
    plan = plan_repository(tmp_path).plan
    assert [each.name for each in plan.workspace.submodules] == ["training/brumby_net"] * cloned
    (said,) = [each.message for each in plan.warnings if "no submodule in this commit" in each.message]
    assert said.endswith("the image clones its newest state" if cloned else "nothing names it, and it is left out")


@pytest.mark.parametrize(
    ("url", "step", "cloned"),
    [
        ("https://github.com/lab/Net", "cd net && pip install -e .", ["libs/net"]),
        ("https://github.com/lab/Net", "cd old/net && pip install -e .", ["libs/net", "old/net"]),
        ("https://github.com/lab/other.git", "cd net && pip install -e .", ["libs/net", "old/net"]),
    ],
)
def test_an_entry_is_left_over_where_the_commit_has_its_repository_elsewhere(
    tmp_path: Path, url: str, step: str, cloned: list[str]
) -> None:
    modules = f'[submodule "a"]\n\tpath = old/net\n\turl = {url}\n'
    modules += '[submodule "b"]\n\tpath = libs/net\n\turl = https://github.com/lab/net.git\n'
    files = {"play.py": f"import numpy\n{MAIN}", "requirements.txt": "numpy\n", ".gitmodules": modules}
    linked(tmp_path, {**files, "README.md": f"```\n{step}\n```\n"}, COMMIT, "libs/net")
    plan = plan_repository(tmp_path).plan
    assert sorted(each.name for each in plan.workspace.submodules) == cloned
    said = [each.message for each in plan.warnings if "no submodule in this commit" in each.message]
    ends = "libs/net is of the same repository, and it is left out" if len(cloned) == 1 else "clones its newest state"
    assert [each.endswith(ends) for each in said] == [True]


def test_no_clone_is_promised_of_what_cannot_be_cloned(tmp_path: Path) -> None:
    modules = '[submodule "a"]\n\tpath = libs/net\n\turl = /home/me/net\n'
    modules += '[submodule "b"]\n\tpath = libs/arm\n\turl = https://github.com/lab/arm.git\n'
    page = "```\npip install -e libs/net -e libs/arm\n```\n"
    files = {"play.py": f"import numpy\n{MAIN}", "requirements.txt": "numpy\n", ".gitmodules": modules}
    linked(tmp_path, {**files, "README.md": page}, COMMIT, "other")
    plan = plan_repository(tmp_path).plan
    assert [each.name for each in plan.workspace.submodules] == ["libs/arm"]
    said = [each.message for each in plan.warnings if "no submodule in this commit" in each.message]
    ends = ("libs/net; the image cannot clone it either", "libs/arm; the image clones its newest state")
    assert [one.endswith(end) for one, end in zip(said, ends, strict=True)] == [True, True]
    assert any(each.message.startswith("libs/net is empty in the image") for each in plan.warnings)


def test_quotation_marks_around_a_path_and_an_address_are_none_of_them(tree: Tree) -> None:
    modules = '[submodule "a"]\n\tpath = "libs/net"\n\turl = "https://github.com/lab/net.git"\n\tbranch = "devel"\n'
    decision = tree({**PLAY, ".gitmodules": modules})
    (module,) = decision.submodules
    assert (module.name, module.repo, module.ref) == ("libs/net", "https://github.com/lab/net.git", "devel")
    assert module.place is not None
    assert module.place.line == 3
