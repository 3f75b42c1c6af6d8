"""A header that pages and scripts copy from a template of the tree is copied before the build."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "CMakeLists.txt": "project(a)\nadd_executable(a src/a.cpp)\n",
    "src/a.cpp": '#include "config.hpp"\nint main() {}\n',
    "src/config.example.hpp": "#define SPEED 1\n",
}
COPY = "cp src/config.example.hpp src/config.hpp"


@pytest.mark.parametrize(
    ("changed", "copied"),
    [
        ({"README.md": f"# A\n\n1. `{COPY}`\n2. Edit it\n"}, [COPY]),
        ({"README.md": f"# A\n```\n{COPY}\nmake\n```\n"}, [COPY]),
        ({"README.md": "# A\nCopy `src/config.example.hpp` to `src/config.hpp` and edit it.\n"}, [COPY]),
        ({"README.md": "# A\n```\ncd src\ncp config.example.hpp config.hpp\n```\n"}, [COPY]),
        ({"scripts/test.sh": f"#!/bin/sh\n{COPY}\nmake\n"}, [COPY]),
        ({".github/workflows/a.yml": f"jobs:\n  a:\n    steps:\n      - run: {COPY}\n"}, [COPY]),
        ({"README.md": f"# A\n`{COPY}`\n", "src/config.hpp": "#define SPEED 2\n"}, []),
        ({"README.md": f"# A\n`{COPY}`\n", "src/a.cpp": "int main() {}\n"}, []),
        ({"README.md": "# A\n`cp src/config.example.hpp /opt/a/config.hpp`\n"}, []),
        ({"README.md": "# A\n`cp src/gone.example.hpp src/config.hpp`\n"}, []),
        ({"README.md": "# A\nSee `src/config.example.hpp`.\n"}, []),
    ],
)
def test_what_the_code_includes_and_git_lacks(tree: Tree, changed: dict[str, str], copied: list[str]) -> None:
    decision = tree({**FILES, **changed})
    assert [script.command for script in decision.scripts] == copied


def test_before_a_workspace(tree: Tree) -> None:
    manifest = "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    decision = tree({**FILES, "package.xml": manifest, "README.md": f"# A\n`{COPY}`\n"})
    assert [(script.command, script.after) for script in decision.scripts] == [(COPY, False)]


def test_the_dockerfile_says_that_it_only_copies(tmp_path: Path) -> None:
    tree_of(tmp_path, {**FILES, "README.md": f"# A\n`{COPY}`\n"})
    assert "# What is copied or written before it is compiled" in dockerfile(plan_repository(tmp_path).plan)


def test_a_template_in_a_folder_whose_name_has_a_space(tree: Tree) -> None:
    files = {**FILES, "my code/config.example.hpp": FILES["src/config.example.hpp"]}
    del files["src/config.example.hpp"]
    decision = tree({**files, "README.md": "# A\n`cp config.example.hpp ../src/config.hpp`\n"})
    assert [script.command for script in decision.scripts] == ["cp 'my code/config.example.hpp' src/config.hpp"]
