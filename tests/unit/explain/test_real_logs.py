"""Real failing logs, where a folder of them is at hand: how many are explained rightly, and how many wrongly."""

from __future__ import annotations

import csv
from collections import Counter
from pathlib import Path

import pytest
from benchmarks.explain import RIGHT, WRONG, verdict

from roslab.explain.answer import explain
from roslab.explain.words import text


def test_real_logs_are_explained(shared: Path) -> None:
    truth = shared / "logs" / "truth.tsv"
    if not truth.is_file():
        pytest.skip("no folder of real logs is here")
    counts: Counter[str] = Counter()
    with truth.open(encoding="utf-8", newline="") as stream:
        for row in csv.DictReader(stream, delimiter="\t", quoting=csv.QUOTE_NONE):
            with (truth.parent / row["file"]).open("rb") as log:
                answer = explain(log)
            assert "Traceback (most recent call last)" not in text(answer)
            assert len(answer.explanations) == 1
            counts[verdict(answer, row)] += 1
    total = sum(counts.values())
    assert counts["right"] >= RIGHT * total
    assert counts["wrong"] <= WRONG * total
