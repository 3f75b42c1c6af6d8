"""Pages in AsciiDoc are read as Markdown that says the same."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.prose.asciidoc import as_markdown

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("= Robot\n\n=== Usage", "# Robot\n\n### Usage"),
        ("Robot\n=====\n\nUsage\n~~~~~\n", "# Robot\n\n\n### Usage\n\n"),
        ("Usage:\n-----\n", "## Usage:\n\n"),
        ("Build:\n----\nmake\n----\n", "Build:\n```\nmake\n```\n"),
        ("[source,bash]\n----\nmake\n----\n", "\n```bash\nmake\n```\n"),
        ("[source,bash]\n.Compile it\n----\nmake\n----\n", "\nCompile it\n```bash\nmake\n```\n"),
        ("[,python]\n----\nrun()\n----\n", "\n```python\nrun()\n```\n"),
        ("....\ncolcon build\n----\n....\n", "```\ncolcon build\n----\n```\n"),
        ("```sh\nmake\n```\n----\nmake\n----\n", "```sh\nmake\n```\n```\nmake\n```\n"),
        ("Compile:\n\n $ make \\\n   all\n\nText\n and more", "Compile:\n\n    $ make \\\n    all\n\nText\n and more"),
        ("\n * item\n - other\n", "\n * item\n - other\n"),
        (". Build\n+\n.. Twice\n* Run\n** Once", "1. Build\n\n   1. Twice\n* Run\n  * Once"),
        ("// no\n:toc:\n[[here]]\n[NOTE]\nimage::a.png[]\nifdef::x[]", "\n\n\n\n\n"),
        ("////\nmake\n////\nText", "\n\n\nText"),
        ("/////\nmake\n////\n/////\n//// Text", "\n\n\n\n//// Text"),
        (":base: b\n:path: {base}/c\n\n{path}", "\n\n\nb/c"),
        (":distro: humble\n\nROS {distro}, {other}", "\n\nROS humble, {other}"),
        (
            "See link:docs/a.adoc[the guide] or https://ros.org[ROS].",
            "See [the guide](docs/a.adoc) or [ROS](https://ros.org).",
        ),
        ("a\n--\n| x\n|===\n", "a\n--\n| x\n|===\n"),
    ],
)
def test_it_says_the_same_on_the_same_lines(text: str, found: str) -> None:
    assert as_markdown(text) == found
    assert found.count("\n") == text.count("\n")


PACKAGE = {
    "package.xml": '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<export><build_type>ament_cmake</build_type></export></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\nadd_executable(talker a.cpp)\n"
    "install(TARGETS talker DESTINATION lib/demo)\n",
    "a.cpp": "int main() {}\n",
}
GUIDE = "= Guide\n\n== Usage\n\nROS 2 Foxy\n\n....\nros2 run demo talker --rate 2\n....\n"
RUNS = ("ros2", "run", "demo", "talker", "--rate", "2")


@pytest.mark.parametrize(
    "files",
    [
        {"README.adoc": GUIDE},
        {"README.asciidoc": GUIDE},
        {"README.adoc": "= Demo\n\nSee link:docs/UserGuide.adoc[the guide].\n", "docs/UserGuide.adoc": GUIDE},
        {
            "README.md": "# Demo\n\nSee the [Developer's guide](docs/DeveloperGuide.adoc).\n",
            "docs/DeveloperGuide.adoc": GUIDE,
        },
    ],
)
def test_a_page_in_it_says_what_to_run_and_on_what(tree: Tree, files: dict[str, str]) -> None:
    decision = tree({**PACKAGE, **files})
    assert (decision.command, decision.base_image) == (RUNS, "ros:foxy-ros-base")


@pytest.mark.parametrize(
    "page",
    [
        "# Demo\n\n```\ncolcon build\n```\n\nSee the [guide](docs/UserGuide.adoc).\n",
        "# Demo\n\nSee the [guide to contributing](docs/UserGuide.adoc).\n",
    ],
)
def test_a_manual_beside_a_page_with_code_is_not_read(tree: Tree, page: str) -> None:
    assert tree({**PACKAGE, "README.md": page, "docs/UserGuide.adoc": GUIDE}).command != RUNS
