"""Imports that nothing brings are told with their lines; what may come from elsewhere is not."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PAGE = {"README.md": "# Run\n```\npython play.py\n```\n"}


def test_a_package_behind_a_login_is_told_where_the_code_imports_it(tree: Tree) -> None:
    code = "import numpy\nimport isaacgym\nfrom isaacgym import gymapi\n"
    found = tree({"play.py": code, "setup.py": "from setuptools import setup\nsetup(install_requires=['numpy'])\n"})
    assert [(w.file, w.line) for w in found.warnings if "isaacgym" in w.message] == [("play.py", 2)]


@pytest.mark.parametrize(
    ("files", "names"),
    [
        ({"play.py": "import numpy\nimport acme_arm\nimport acme_hand\n"}, "acme_arm, acme_hand"),
        ({"play.py": "try:\n    import acme_arm\nexcept ImportError:\n    pass\n"}, ""),
        ({"play.py": "import acme_arm\n", "requirements.txt": "numpy\n"}, ""),
        ({"tests/test_play.py": "import acme_arm\n"}, ""),
        ({"play.py": "import acme_arm\n", "README.md": "```\npip install acme-arm\n```\n"}, ""),
        (
            {
                "play.py": "import translate\n",
                ".gitmodules": '[submodule "down"]\n\tpath = down\n\turl = https://github.com/a/down.git\n',
            },
            "",
        ),
    ],
)
def test_a_module_of_no_table_is_told_once_where_nothing_is_declared(
    tree: Tree, files: dict[str, str], names: str
) -> None:
    said = [w.message for w in tree({**PAGE, "play.py": "import numpy\n", **files}).warnings if "no table" in w.message]
    assert len(said) == bool(names)
    assert not names or f"brings it: {names}; " in said[0]
