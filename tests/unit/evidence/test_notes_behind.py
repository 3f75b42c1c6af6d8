"""A note behind a command, in the wide signs of Chinese and Japanese pages, is none of its words."""

from __future__ import annotations

import pytest

from roslab.evidence.prose.notes_behind import without_notes

NOTE = "\u542f\u52a8"
OPEN, CLOSE, COMMA, STOP = "\uff08", "\uff09", "\uff0c", "\u3002"
RUN = "roslaunch demo run.launch"
OF_LAUNCH = (f" {NOTE}", f" {OPEN}rviz{CLOSE}")
"""What is a note right behind a launch file alone."""


@pytest.mark.parametrize(
    "note",
    [
        f" {OPEN}{NOTE}{CLOSE}",
        f"{OPEN}{NOTE}{COMMA}run{CLOSE}",
        f" {OPEN}rviz{CLOSE}",
        STOP,
        f"{COMMA}{NOTE}",
        f"  //{NOTE}",
        f", {NOTE}",
        f" -- {NOTE}",
        f" \u2190 {NOTE}",
        f" {NOTE}",
        "\uff1b",
    ],
)
def test_a_note_ends_a_command(note: str) -> None:
    assert without_notes(RUN + note) == RUN
    assert without_notes(f"{RUN}{note}\n{RUN} rate:=5{note}") == f"{RUN}\n{RUN} rate:=5" or note in OF_LAUNCH


@pytest.mark.parametrize(
    "line",
    [
        RUN,
        f"{RUN} map:={OPEN}{NOTE}{CLOSE}",
        f"{RUN} bag:={NOTE}.bag",
        f"python say.py '{NOTE}{COMMA}{NOTE}'",
        f"python {NOTE}{OPEN}1{CLOSE}.py",
        f"python plot.py {NOTE}",
        f"python plot.py --map {OPEN}{NOTE}{CLOSE}",
        f"python plot.py --map {OPEN}hall \uff5c yard{CLOSE}",
        f"python plot.py {OPEN}hall{CLOSE}",
        "cd build\uff1bcmake ..",
        "roslaunch demo run.launch  // start it",
    ],
)
def test_names_values_and_quotations_stay(line: str) -> None:
    assert without_notes(line) == line


def test_a_line_goes_on_behind_its_note() -> None:
    assert without_notes(f"{RUN} {OPEN}{NOTE}{CLOSE} \\\n  a:=1") == f"{RUN} \\\n  a:=1"
