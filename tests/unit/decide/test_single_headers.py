"""Libraries of one header that a page fetches and puts where every compiler looks."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision, Download
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
URL = "https://raw.githubusercontent.com/lab/trace/master/trace.hpp"
CODE = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(demo a.cpp)\n",
    "a.cpp": '#include "trace.hpp"\nint main() {}\n',
}


def page(commands: str) -> dict[str, str]:
    return CODE | {"README.md": f"ROS Noetic\n## Installation\n```\n{commands}\n```\n"}


@pytest.mark.parametrize(
    ("commands", "path"),
    [
        (f"wget {URL}\nsudo mv trace.hpp /usr/include", "usr/include/trace.hpp"),
        (f"wget {URL} && sudo cp trace.hpp /usr/local/include/trace/", "usr/local/include/trace/trace.hpp"),
        (f"cd /tmp\ncurl -LO {URL}\nsudo install -m 644 /tmp/trace.hpp /usr/include/tr.h", "usr/include/tr.h"),
        (f"sudo wget -P /usr/local/include {URL}", "usr/local/include/trace.hpp"),
        (f"sudo wget {URL} -O /usr/include/lab/t.hpp", "usr/include/lab/t.hpp"),
        (f"sudo curl -o /usr/include/trace.hpp {URL}", "usr/include/trace.hpp"),
        (f"wget {URL}\nmv trace.hpp include/", ""),
        (f"wget {URL}\nsudo mv other.hpp /usr/include", ""),
        ("sudo mv trace.hpp /usr/include", ""),
        (f"wget -O trace.txt {URL}\nsudo mv trace.txt /usr/include", ""),
    ],
)
def test_a_header_for_every_compiler(tree: Tree, commands: str, path: str) -> None:
    decision = tree(page(commands))
    assert decision.downloads == ((Download(url=URL, path=path, system=True),) if path else ())
    assert [f"puts it to /{path}" in each.reason for each in decision.reasons if each.question == "downloads"] == (
        [True] if path else []
    )


def test_what_another_page_fetches_is_not_moved(tree: Tree) -> None:
    other = {"docs/other.md": f"# Installation\n```\nwget {URL}\n```\n"}
    assert tree(page("sudo mv trace.hpp /usr/include") | other).downloads == ()


def test_it_lies_there_before_the_code_is_compiled(tree: Tree) -> None:
    decision = tree(page(f"wget {URL}\nsudo mv trace.hpp /usr/include"))
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    assert f"fetch-optional \\\n      {URL} \\\n      /fetched-system/usr/include/trace.hpp\n" in text
    assert text.index("COPY --from=downloads /fetched-system/ /\n") < text.rindex(" catkin_make ")
