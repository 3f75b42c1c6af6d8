"""The port at which a page has its reader open what it starts."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
RUN = "```\npython run.py\n```\n"


@pytest.mark.parametrize(
    ("page", "ports"),
    [
        (f"## Run\n{RUN}Open `http://<host>:5055`.\n", ("5055:5055",)),
        ("## Run\n```\npython run.py  # http://localhost:8050/live\n```\n", ("8050:8050",)),
        (f"## Run\n{RUN}## Other\nOpen http://localhost:5055\n", ()),
        (f"## Run\n{RUN}Open http://localhost:5055, the other is http://localhost:5056\n", ()),  # of two programs
        (f"## Run\n{RUN}See https://example.org:8443/a\n", ()),
        (f"## Run\n{RUN}Then open this in your browser:\n\n```\nhttp://localhost:5055\n```\n", ("5055:5055",)),
        (f"## Run\n{RUN}The page is available at\n<http://127.0.0.1:5055>.\n", ("5055:5055",)),
        (f"## Run\n{RUN}Start the model first. It listens at http://localhost:5055.\n", ()),
        (f"## Run\n{RUN}Open another shell. The model has to be at http://localhost:5055.\n", ()),
        (f"## Run\n```\nexport SERVER=http://localhost:5055\n```\n{RUN}", ()),
        (f"## Run\n{RUN}Open http://<robot-ip>:8080, the page of the robot.\n", ()),
        (f"## Run\n{RUN}Open http://localhost:6006 for the curves.\n", ()),
    ],
)
def test_the_port_of_the_section(tree: Tree, page: str, ports: tuple[str, ...]) -> None:
    found = tree(
        {"run.py": "import flask\n\nif __name__ == '__main__':\n    print(1)\n", "README.md": f"# Demo\n{page}"}
    )
    assert found.command == ("python", "run.py")
    assert found.ports == ports


def test_an_address_that_the_command_is_given_is_of_another_server(tree: Tree) -> None:
    page = "# Demo\n## Run\n```\npython run.py --server http://localhost:8000/v1\n```\nOpen http://localhost:8000.\n"
    assert tree({"run.py": "import flask\n", "README.md": page}).ports == ()
