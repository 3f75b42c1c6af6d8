"""The port of a program that serves pages is open where the command starts it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
APP = "from flask import Flask\napp = Flask(__name__)\nif __name__ == '__main__':\n    {}\n"
PAGE = "# Tool\n## Usage\n```\npython web/app.py\n```\n"


@pytest.mark.parametrize(
    ("call", "ports"),
    [
        ("app.run(debug=True, host='0.0.0.0', port=5001)", ("5001",)),
        ("app.run(\n        host='0.0.0.0',\n        port=5001,\n    )", ("5001",)),
        ("app.run(host='0.0.0.0')", ("5000",)),
        ("uvicorn.run(app, host='0.0.0.0')", ("8000",)),
        ("demo.launch(server_name='0.0.0.0', server_port=7860)", ("7860",)),
        ("app.run(host='0.0.0.0', port=port)", ()),
        ("app.run(port=5001)", ()),  # nothing outside of the container reaches it
        ("# app.run(host='0.0.0.0', port=5001)\n    pass", ()),
        ("robot.connect('0.0.0.0', port=5001)", ()),
    ],
)
def test_its_number_is_read(tree: Tree, call: str, ports: tuple[str, ...]) -> None:
    decision = tree({"web/app.py": APP.format(call), "README.md": PAGE})
    assert decision.command == ("python", "web/app.py")
    assert decision.ports == ports


def test_another_command_opens_none(tree: Tree) -> None:
    files = {"web/app.py": APP.format("app.run(host='0.0.0.0', port=5001)"), "main.py": "print(1)\n"}
    decision = tree({**files, "README.md": PAGE.replace("web/app.py", "main.py")})
    assert decision.ports == ()
