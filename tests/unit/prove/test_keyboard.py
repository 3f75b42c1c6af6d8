"""A program that asks for a key is not told that nobody will ever press one."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import ProofGoals, ProofLimits
from roslab.plan.proof import Proof
from roslab.prove.containers import prove

ENGINE = """\
#!/bin/bash
# Runs a program that waits for a line, in the place of a container of that number
case "$1" in
  run)
    for word; do
      if [ "$word" = --interactive ]; then given=yes; fi
      if [ "$before" = --cidfile ]; then echo $$ >"$word"; fi
      before="$word"
    done
    if [ -z "$given" ]; then exec </dev/null; fi
    read -r line || { echo 'EOFError: EOF when reading a line'; exit 1; }
    ;;
  rm) kill "${@: -1}" ;;
esac
"""


@pytest.mark.parametrize(
    ("proof", "held"),
    [
        (Proof(name="a", command=("python3", "ask.py"), rung=1, may_run_on=True), True),
        (Proof(name="a", command=("bash",), may_run_on=True), False),
    ],
)
def test_a_program_that_asks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, proof: Proof, held: bool) -> None:
    (tmp_path / "docker").write_text(ENGINE)
    (tmp_path / "docker").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    (outcome,) = prove(
        "a", "linux/amd64", (proof,), limits=ProofLimits(), goals=ProofGoals(seconds=2), screenshots=tmp_path
    )
    assert outcome.held is held


ASKED = """\
#!/bin/bash
# Fails as a program that clears the screen does where nobody says which it is
[ "$1" = run ] || exit 0
[[ " $* " == *" --env TERM=xterm "* ]] || { echo 'TERM environment variable not set.'; exit 1; }
"""


def test_a_program_that_clears_the_screen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "docker").write_text(ASKED)
    (tmp_path / "docker").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    proof = Proof(name="a", command=("python3", "menu.py"), rung=1, may_run_on=True)
    (outcome,) = prove(
        "a", "linux/amd64", (proof,), limits=ProofLimits(), goals=ProofGoals(seconds=2), screenshots=tmp_path
    )
    assert outcome.held
