"""A list of repositories that lies in another repository is read there, for what is missing."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package format='3'><name>demo</name><export><build_type>ament_cmake</build_type></export>{}</package>"
LISTS = "https://github.com/lab/lists.git"
CLONE = "RUN git clone --branch lab/tool https://github.com/lab/lists.git $HOME/lists\n"
OLD = "https://raw.github.com/lab/lists"
RAW_LAB = "https://gitlab.com/lab/lists/-/raw"
IMAGE = "FROM ros:humble\nARG FILE=tool.https.rosinstall\n{}RUN wstool merge {}\nRUN wstool up\n"


def _lists(tree: Tree, image: str, needs: str = "<depend>tool_msgs_x</depend>") -> list[tuple[str | None, str | None]]:
    files = {
        "package.xml": PACKAGE.format(needs),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "Dockerfile.tool": image,
    }
    found = [each for each in tree(files).source if each.prepare]
    assert all("! -path ./tool.https.rosinstall -delete" in each.prepare and each.unasked for each in found)
    return [(each.repo, each.ref) for each in found]


@pytest.mark.parametrize(
    ("image", "found"),
    [
        (IMAGE.format(CLONE, "$HOME/lists/$FILE"), [(LISTS, "lab/tool")]),
        (
            IMAGE.format(CLONE, "${H}/lists/tool.https.rosinstall"),
            [(LISTS, "lab/tool")],
        ),
        (
            IMAGE.format("", "https://raw.githubusercontent.com/lab/lists/v1/tool.https.rosinstall"),
            [(LISTS, "v1")],
        ),
        (IMAGE.format("", "$HOME/lists/$FILE"), []),
        (IMAGE.format(CLONE, "$HOME/other/$FILE"), []),
        (IMAGE.format(CLONE, "$HOME/lists/$OTHER"), []),
    ],
)
def test_the_list_of_another_repository(tree: Tree, image: str, found: list[tuple[str, str]]) -> None:
    assert _lists(tree, image) == found


@pytest.mark.parametrize(
    ("path", "text", "found"),
    [
        (
            ".travis.yml",
            f"install:\n  - export ROS_DISTRO=humble\n  - wstool merge {OLD}/$ROS_DISTRO-devel/ci/a.rosinstall\n",
            [(LISTS, "humble-devel")],
        ),
        (
            ".github/workflows/a.yml",
            f"env:\n  ROS_DISTRO: humble\njobs:\n  a:\n  - run: vcs import src < {RAW_LAB}/$ROS_DISTRO/a.repos\n",
            [("https://gitlab.com/lab/lists.git", "humble")],
        ),
        (
            "bitbucket-pipelines.yml",
            "run: wstool merge https://raw.github.com/lab/lists/v1/tool.rosinstall\n",
            [(LISTS, "v1")],
        ),
        (".github/more/a.yml", "run: wstool merge https://raw.github.com/lab/lists/v1/tool.rosinstall\n", []),
        (
            "README.md",
            "    wget https://raw.githubusercontent.com/lab/lists/v1/tool.repos\n    vcs import src < tool.repos\n",
            [(LISTS, "v1")],
        ),
        (
            "README.md",
            "    curl -sSL https://bitbucket.org/lab/lists/raw/v1/tool.repos | vcs import src\n",
            [("https://bitbucket.org/lab/lists.git", "v1")],
        ),
        ("README.md", "    wget https://raw.github.com/ros2/ros2/humble/ros2.repos\n    vcs import < ros2.repos\n", []),
        ("README.md", "    wget https://raw.github.com/lab/lists/v1/a.repos\n    vcs import src < tool.repos\n", []),
    ],
)
def test_a_list_that_ci_takes_or_a_page_fetches(tree: Tree, path: str, text: str, found: list[tuple[str, str]]) -> None:
    files = {
        "package.xml": PACKAGE.format("<depend>tool_msgs_x</depend>"),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        path: f"# ROS 2 Humble\n{text}",
    }
    decision = tree(files)
    assert [(each.repo, each.ref) for each in decision.source if each.prepare] == found
    assert any("not imported" in each.message for each in decision.warnings) is (not found and path == "README.md")


@pytest.mark.parametrize(
    ("page", "found"),
    [
        ("git clone https://github.com/lab/treep_lab.git\ntreep --clone ARM\ncolcon build\n", True),
        ("git clone git@github.com:lab/treep_lab.git\ntreep --clone-https ARM\n", True),
        ("git clone https://github.com/lab/treep_lab.git\n", False),
        ("treep --clone ARM\n", False),
    ],
)
def test_a_list_of_treep_is_in_the_repository_that_a_page_clones_for_it(tree: Tree, page: str, found: bool) -> None:
    files = {
        "package.xml": PACKAGE.format("<depend>tool_msgs_x</depend>"),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "doc/installation.md": f"# ROS 2 Humble\n```bash\n{page}```\n",
    }
    listed = [each for each in tree(files).source if each.prepare]
    assert [each.name for each in listed] == (["treep_lab"] if found else [])


def test_a_list_brings_nothing_that_is_only_linked(tree: Tree) -> None:
    files = {
        "package.xml": PACKAGE.format("<depend>tool_msgs_x</depend>"),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\nadd_executable(a a.cpp)\n"
        "target_link_libraries(a EposCmd)\n",
        "a.cpp": "int main() {}\n",
        "Dockerfile.tool": IMAGE.format(CLONE, "$HOME/lists/$FILE"),
    }
    told = [each.message for each in tree(files).warnings]
    assert any("demo links EposCmd, which nothing" in each for each in told)
    assert any("has no key tool_msgs_x" in each and "cloned repositories may hold it" in each for each in told)


def test_a_list_comes_before_the_owners_repository_of_a_name(tree: Tree) -> None:
    files = {
        ".git/config": '[remote "origin"]\n\turl = https://github.com/maker/demo.git\n',
        ".git/HEAD": "ref: refs/heads/a\n",
        "package.xml": PACKAGE.format("<depend>tool_msgs_x</depend>"),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "README.md": "ROS 2 Humble\n",
    }
    assert [each.name for each in tree(files).source] == ["tool_msgs_x", "tool_msgs"]
    found = tree({**files, "Dockerfile.tool": IMAGE.format(CLONE, "$HOME/lists/$FILE")}).source
    assert [each.name for each in found] == ["lists"]


def test_none_is_read_where_nothing_is_missing(tree: Tree) -> None:
    assert _lists(tree, IMAGE.format(CLONE, "$HOME/lists/$FILE"), "<depend>rclcpp</depend>") == []


RAW = "https://raw.githubusercontent.com/{}/v1/{}.rosinstall"


def _named(tree: Tree, *lines: str) -> list[tuple[str, str | None, str]]:
    """Return the name, the address and the lists that are kept, of what a script takes lists from."""
    files = {
        "package.xml": PACKAGE.format("<depend>tool_msgs_x</depend>"),
        "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\n",
        "README.md": "ROS 2 Humble\n",
        "setup.sh": "".join(f"{line}\n" for line in lines),
    }
    found = [each for each in tree(files).source if each.prepare]
    return [(e.name, e.repo, e.prepare.partition("\\) ")[2].removesuffix(" -delete")) for e in found]


def test_all_lists_of_one_repository_are_kept(tree: Tree) -> None:
    lines = [f"wstool merge {RAW.format('lab/lists', name)}" for name in ("a", "b", "sub/c")]
    kept = "! -path ./a.rosinstall ! -path ./b.rosinstall ! -path ./sub/c.rosinstall"
    assert _named(tree, *lines) == [("lists", LISTS, kept)]
    lines = ["git clone https://github.com/lab/lists src/x", "wstool merge -t src src/x/a.rosinstall"]
    lines.append(f"wstool merge {RAW.format('lab/lists', 'b')}")
    found = _named(tree, *lines)
    assert [each[::2] for each in found] == [("lists", "! -path ./a.rosinstall ! -path ./b.rosinstall")]


def test_brackets_in_a_name_stand_for_two_lists(tree: Tree) -> None:
    lines = ["git clone https://github.com/lab/lists ~/x", "wstool merge ~/x/robot[-sim].rosinstall"]
    kept = "! -path ./robot.rosinstall ! -path ./robot-sim.rosinstall"
    assert _named(tree, *lines) == [("lists", LISTS.removesuffix(".git"), kept)]


def test_two_owners_of_one_name_have_folders_of_their_own(tree: Tree) -> None:
    found = _named(tree, *(f"wstool merge {RAW.format(owned, 'a')}" for owned in ("foo/ws", "baz/ws")))
    assert [each[:2] for each in found] == [
        ("ws", "https://github.com/foo/ws.git"),
        ("baz_ws", "https://github.com/baz/ws.git"),
    ]


@pytest.mark.parametrize("owned", ["upstream/demo", "upstream/Demo"])
def test_what_the_repository_is_a_fork_of_is_not_cloned_into_its_folder(tree: Tree, owned: str) -> None:
    assert _named(tree, f"wstool init src {RAW.format(owned, 'x')}") == []
    clone = f"git clone https://github.com/{owned}.git src/x"
    assert _named(tree, clone, "wstool merge -t src src/x/a.rosinstall") == []


@pytest.mark.parametrize("name", ["..", ".", ".git", ".hidden", "-x"])
def test_an_odd_name_is_no_folder(tree: Tree, name: str) -> None:
    assert _named(tree, f"wstool merge {RAW.format(f'lab/{name}', 'a')}") == []
    merged = "wstool merge -t src src/odd/a.rosinstall"
    assert _named(tree, f"git clone https://github.com/lab/{name} src/odd", merged) == []
    assert _named(tree, "git clone https://github.com/lab/plain src/odd", merged) != []
