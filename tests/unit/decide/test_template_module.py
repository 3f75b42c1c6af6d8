"""A template of CPython's own sources, which editors import in place of what was meant."""

from __future__ import annotations

from collections.abc import Callable

from roslab.decide.decision import Decision


def test_no_package_of_its_name_is_tried(tree: Callable[[dict[str, str]], Decision]) -> None:
    code = "from xxlimited import Str\nimport numpy\nif __name__ == '__main__':\n    print(Str)\n"
    decision = tree({"main.py": code, "README.md": "# A\n```\npython main.py\n```\n"})
    assert [each.key for each in decision.python.pip_guessed] == ["numpy"]
    assert not [each for each in decision.warnings if "xxlimited" in each.message]
