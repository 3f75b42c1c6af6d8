"""Inputs, secrets and outputs in tables, as the YAML says them. ``REPRO_REFRESH=1 pytest tests/golden`` writes them."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
STARTERS = ROOT / "workflows/README.md"
PAGES = [ROOT / "README.md", STARTERS]
TABLE = re.compile(r"(<!-- (?P<what>[a-z]+) of (?P<door>[a-z ]+) -->\n)(?:\n(?:\|.*\n)+)?")
OWN = {"clean", "drift"}
"""Workflows that build no image to be published, with tables of their own."""
NEEDS = {"inputs": 4, "secrets": 2, "outputs": 2}
"""The columns of a table of several workflows."""


def action() -> dict[str, Any]:
    found: dict[str, Any] = yaml.safe_load((ROOT / "action.yml").read_text())
    return found


def workflows() -> dict[str, dict[str, Any]]:
    """Return ``workflow_call`` of each workflow that builds images, by name, the whole one first."""
    paths = [*(ROOT / ".github/workflows").glob("[a-z]*.yml")]
    found = {path.stem: yaml.safe_load(path.read_text()) for path in sorted(paths)}
    # PyYAML reads the key ``on`` as true
    called = {name: each[True]["workflow_call"] for name, each in found.items() if name not in OWN}
    return {name: called[name] for name in sorted(called, key=lambda name: (name != "image", name))}


def _default(entry: dict[str, Any]) -> str:
    said = entry.get("default", "")
    return "" if said == "" or str(said).startswith("${{") else f"`{said}`"


def _row(*cells: str) -> str:
    return f"| {' | '.join(cell.replace('|', '&#124;') for cell in cells)} |".replace("|  |", "| |") + "\n"


def table(what: str, door: str) -> str:
    """Return one table: of the action, of all workflows that build images, or of a workflow of its own."""
    if door == "the workflows":
        return _of_workflows(what)
    found = action() if door == "the action" else _called(door)
    single, wide = what.removesuffix("s"), what == "inputs"
    head = _row(single, "what it says", *(["default"] if wide else [])) + _row(*["---"] * (3 if wide else 2))
    return head + "".join(
        _row(f"`{name}`", entry["description"], *([_default(entry)] if wide else []))
        for name, entry in found[what].items()
    )


def _called(door: str) -> dict[str, Any]:
    found: dict[str, Any] = yaml.safe_load((ROOT / f".github/workflows/{door}.yml").read_text())[True]["workflow_call"]
    return found


def _of_workflows(what: str) -> str:
    found = workflows()
    wide = what == "inputs"
    head = ["input", "in", "what it says", "default"] if wide else [what.removesuffix("s"), "what it says"]
    text = _row(*head) + _row(*["---"] * NEEDS[what])
    for name, entry in found["image"][what].items():
        holders = [door for door, called in found.items() if name in called[what]]
        held = "all" if len(holders) == len(found) else ", ".join(holders)
        text += _row(f"`{name}`", *([held] if wide else []), entry["description"], *([_default(entry)] if wide else []))
    return text


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_the_tables_are_made_from_the_yaml(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    made = TABLE.sub(lambda match: f"{match[1]}\n{table(match['what'], match['door'])}", text)
    if os.environ.get("REPRO_REFRESH") == "1":
        page.write_text(made, encoding="utf-8")
        text = made
    assert TABLE.search(text)
    assert text == made, f"{page.name} is behind the YAML: REPRO_REFRESH=1 pytest tests/golden, and read the diff"


def test_every_door_has_its_tables() -> None:
    found = {(match["what"], match["door"]) for page in PAGES for match in TABLE.finditer(page.read_text())}
    assert {("inputs", "the action"), ("outputs", "the action")} <= found
    assert {("inputs", name) for name in OWN} <= found
    assert {(what, "the workflows") for what in NEEDS} <= found
    said = {name for called in workflows().values() for what in NEEDS for name in called[what]}
    assert all(f"| `{name}` |" in STARTERS.read_text() for name in said)


def test_what_all_workflows_have_says_the_same_in_each() -> None:
    """One row stands for all of them."""
    found = workflows()
    for name, called in found.items():
        for what in ("inputs", "secrets"):
            for key, entry in called[what].items():
                whole = dict(found["image"][what][key])
                if not all(key in each[what] for each in found.values()):
                    whole["description"] = entry["description"]  # such as the one word of ROS 1
                assert entry == whole, f"{name}: {key}"
        assert list(called["outputs"]) == list(found["image"]["outputs"])
        for key, entry in called["outputs"].items():
            assert entry["description"] == found["image"]["outputs"][key]["description"], f"{name}: {key}"
