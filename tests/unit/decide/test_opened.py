"""A file that the default command opens as soon as it is loaded, and that nothing brings, is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
OPENS = 'import json\n\nwith open("config/defaults.json") as file:\n    DEFAULTS = json.load(file)\n'
TRIES = "try:\n    with open('config/defaults.json') as a:\n        pass\nexcept OSError:\n    a = 1\n"
PAGE = "# Run\n```\npython demo.py\n```\n"
MAIN = "from jobs.job import DEFAULTS\n\nif __name__ == '__main__':\n    print(DEFAULTS)\n"


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"demo.py": MAIN, "jobs/job.py": OPENS}, True),
        ({"demo.py": OPENS}, True),
        ({"demo.py": MAIN.replace("jobs.job", "between"), "between.py": "from jobs.job import DEFAULTS\n",
          "jobs/job.py": OPENS}, True),
        ({"demo.py": MAIN, "jobs/job.py": OPENS, "config/defaults.json": "{}"}, False),
        ({"demo.py": "import numpy\n", "jobs/job.py": OPENS}, False),
        ({"demo.py": MAIN, "jobs/job.py": TRIES}, False),
        ({"demo.py": MAIN, "jobs/job.py": OPENS.replace("\nwith", "\ndef load():\n  with")}, False),
        ({"demo.py": MAIN, "jobs/job.py": OPENS.replace('.json"', '.json", "w"')}, False),
        ({"demo.py": MAIN, "jobs/job.py": OPENS, "make.py": "open('config/defaults.json', 'w').write('{}')\n"}, False),
        ({"demo.py": MAIN, "jobs/job.py": '"""Usage:\n\n' + OPENS + '"""\n'}, False),
        ({"demo.py": MAIN, "jobs/job.py": '"""Usage."""\n' + OPENS}, True),
        ({"demo.py": MAIN, "jobs/job.py": "run(['wget', 'http://a.org/defaults.json'])\n" + OPENS}, False),
    ],
)  # fmt: skip
def test_what_is_opened_at_once(tree: Tree, files: dict[str, str], told: bool) -> None:
    decision = tree({"README.md": PAGE, "requirements.txt": "numpy\n", **files})
    assert decision.command == ("python", "demo.py")
    found = [each.message for each in decision.warnings if "as soon as it is loaded" in each.message]
    assert len(found) == told
    assert all("config/defaults.json" in message for message in found)
