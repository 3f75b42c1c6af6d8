"""Packages of imports that may fail, where the code itself says how to install them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TRIED = (
    "try:\n    import gdown\nexcept ImportError:\n    gdown = None\n{more}\nif __name__ == '__main__':\n    main()\n"
)


@pytest.mark.parametrize(
    ("more", "guessed"),
    [
        ("assert gdown, 'pip install gdown to fetch the model'", ["gdown"]),
        ('raise ImportError("Run `pip install gdown==4.7.1`.")', ["gdown==4.7.1"]),
        ("print(\n    'No gdown, so `pip install -U gdown`')", ["gdown"]),
        ("raise ImportError('pip install wget')", []),
        ("# 'pip install gdown' for the models", []),
        ('"""pip install gdown for the models."""', []),
        ("gdown and gdown.download(URL)", []),
    ],
)
def test_an_import_that_may_fail_is_installed_where_the_code_says_how(
    tree: Tree, more: str, guessed: list[str]
) -> None:
    found = tree({"fetch.py": TRIED.format(more=more), "requirements.txt": "scipy\n"})
    assert [each.text for each in found.python.pip_guessed] == guessed


def test_the_place_that_says_it_may_come_after_another(tree: Tree) -> None:
    files = {"a.py": TRIED.format(more=""), "b.py": TRIED.format(more="raise OSError('pip install gdown')")}
    found = tree({**files, "requirements.txt": "scipy\n"})
    assert [(each.name, each.file) for each in found.python.pip_guessed] == [("gdown", "b.py")]


@pytest.mark.parametrize("test", ["tests/test_fetch.py", "pkg/tests/test_fetch.py"])
def test_a_test_that_imports_it_too_hides_it_from_nobody(tree: Tree, test: str) -> None:
    code = TRIED.format(more="raise OSError('pip install gdown')")
    found = tree({"pkg/fetch.py": code, test: "import gdown\n", "requirements.txt": "scipy\n"})
    assert [each.text for each in found.python.pip_guessed] == ["gdown"]


@pytest.mark.parametrize("imported", ["import gdown", "def load():\n    import gdown"])
def test_what_a_manifest_names_keeps_its_version(tree: Tree, imported: str) -> None:
    code = f"{imported}\nWHY = 'pip install gdown==4.0'\nif __name__ == '__main__':\n    main()\n"
    found = tree({"fetch.py": code, "requirements.txt": "gdown==4.7.1\n"})
    assert not found.python.pip_guessed


def test_a_second_framework_is_left_out(tree: Tree) -> None:
    code = TRIED.replace("gdown", "tensorflow").format(more="raise OSError('pip install tensorflow')")
    assert not tree({"fetch.py": code, "requirements.txt": "scipy\n"}).python.pip_guessed
