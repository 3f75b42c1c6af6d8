"""A package that the README runs programs of and nothing brings may lie in what the README clones."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>planner</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(planner)\nfind_package(catkin REQUIRED)\nadd_executable(plan a.cpp)\ncatkin_package()\n",
    "a.cpp": "int main() {}\n",
    "launch/plan.launch": '<launch><node pkg="planner" type="plan" name="plan"/></launch>\n',
    ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/planner.git\n',
    ".git/HEAD": "ref: refs/heads/main\n",
}
RUN = "## Run\n\n```\nroslaunch planner plan.launch\n```\n\n```\nroslaunch {} air.launch\n```\n"


def page(*clones: str, package: str = "sightest", said: str = "") -> str:
    lines = "\n".join(f"git clone https://github.com/{each}.git" for each in ("lab/planner", *clones))
    build = f"## Build\n\n{said}\n\n```\ncd ${{WORK}}/src\n{lines}\n```\n\n"
    return f"# Planner\n\nTested with ROS Noetic.\n\n{build}{RUN.format(package)}"


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (page("mia/Sight-Fusion"), {"Sight-Fusion": ("sightest",)}),
        (page("mia/Sight-Fusion", "mia/sightest_ros"), {"sightest_ros": ("sightest",)}),
        (page("mia/a1", "mia/a2", "mia/a3"), dict.fromkeys(("a1", "a2", "a3"), ("sightest",))),
        (page("mia/a1", "mia/a2", "mia/a3", "mia/a4"), {}),
        (page("mia/Sight-Fusion", package="your_package"), {}),
        (page("mia/Sight-Fusion", package="planner"), {}),
        (page("mia/Sight-Fusion", package="rviz"), {}),
        (page("mia/Sight-Fusion", package="carl_bringup"), {"Sight-Fusion": ("carl_bringup",)}),
        (page("mia/Sight-Fusion", said="Optional:"), {}),
        (page(), {}),
        (page(said="It needs [this](https://github.com/mia/sightest)."), {"sightest": ("sightest",)}),
        (page(said="It needs [this](https://github.com/mia/sightest_ros)."), {}),  # that may be anything
        (
            page("mia/sightest_ros", said="It needs [this](https://github.com/mia/sightest)."),
            {"sightest_ros": ("sightest",)},
        ),
    ],
)
def test_where_it_is_looked_for(tree: Tree, text: str, found: dict[str, tuple[str, ...]]) -> None:
    decision = tree({**FILES, "README.md": text})
    assert {each.name: each.holding for each in decision.source if each.holding} == found
    told = [each.message for each in decision.warnings]
    assert any("runs programs of sightest: nothing is known" in each for each in told) == (
        "sightest air" in text and not found
    )
    not_cloned = [each.split(",")[0].rpartition("/")[2] for each in told if each.startswith("not cloned")]
    assert found.keys().isdisjoint(name.removesuffix(".git") for name in not_cloned)


@pytest.mark.parametrize(
    ("build", "libraries", "sought"),
    [
        ("cmake .\nmake\nsudo make install\n", ["libwheels"], ["pad_driver"]),
        ("make\nsudo make install\n", ["libwheels"], ["pad_driver"]),
        ("", [], ["pad_driver"]),  # it is cloned beside the others, and may hold anything
    ],
    ids=["cmake", "make", "not-installed"],
)
def test_what_a_page_installs_by_hand_holds_no_package(
    tree: Tree, build: str, libraries: list[str], sought: list[str]
) -> None:
    files = {
        **FILES,
        "package.xml": FILES["package.xml"].replace("</package>", "<exec_depend>pad_driver</exec_depend></package>"),
        "CMakeLists.txt": FILES["CMakeLists.txt"] + "target_link_libraries(plan libwheels)\n",
        "README.md": "# Planner\n\nFor ROS Noetic.\n\n```\ncd ~/library\ngit clone https://github.com/lab/libwheels\n"
        f"cd libwheels/\n{build}```\n",
    }
    decision = tree(files)
    assert [source.name for source in decision.source if source.build == "cmake"] == libraries
    assert [source.name for source in decision.source if source.holding] == sought
