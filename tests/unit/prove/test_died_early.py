"""A node that dies at once is explained, however much the others say after it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import ProofGoals, ProofLimits
from roslab.plan.proof import Proof
from roslab.prove.containers import KEPT_OUTPUT, prove

ENGINE = """\
#!/bin/bash
# Prints what a launch of two nodes does, of which one dies, in the place of a container of that number
case "$1" in
  run)
    for word; do
      if [ "$before" = --cidfile ]; then echo $$ >"$word"; fi
      before="$word"
    done
    echo "[a-1] ModuleNotFoundError: No module named 'yaml'"
    echo "[ERROR] [a-1]: process has died [pid 7, exit code 1, cmd 'a']."
    seq -f '[b-2] %.0f' 1 40000
    ;;
  rm) kill "${@: -1}" ;;
esac
"""


def test_its_last_words_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "docker").write_text(ENGINE)
    (tmp_path / "docker").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    proof = Proof(name="a", command=("ros2", "launch"), rung=1, may_run_on=True)
    goals = ProofGoals(seconds=5)
    (outcome,) = prove("a", "linux/amd64", (proof,), limits=ProofLimits(), goals=goals, screenshots=tmp_path)
    assert not outcome.held
    assert outcome.output.startswith("[a-1] ModuleNotFoundError: No module named 'yaml'\n[ERROR] [a-1]: ")
    assert outcome.output.endswith("\n[b-2] 40000\n")
    assert len(outcome.output) < 3 * KEPT_OUTPUT


def test_what_is_not_long_is_kept_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "docker").write_text(ENGINE.replace("40000", "8000"))
    (tmp_path / "docker").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=":")
    proof = Proof(name="a", command=("ros2", "launch"), rung=1, may_run_on=True)
    limits, goals = ProofLimits(), ProofGoals(seconds=5)
    (outcome,) = prove("a", "linux/amd64", (proof,), limits=limits, goals=goals, screenshots=tmp_path)
    assert len(outcome.output) > KEPT_OUTPUT
    assert [line.partition("] ")[2] for line in outcome.output.splitlines()[2:]] == [str(at) for at in range(1, 8001)]
