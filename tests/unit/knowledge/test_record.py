"""Rows of tables as values."""

from __future__ import annotations

import pytest

from roslab.knowledge.record import grouped, record
from roslab.values.dataclass import dataclass

ROW = {"name": "gym", "below": "", "needs": "numpy  scipy", "rank": "3", "source": "a page"}


@dataclass(frozen=True, kw_only=True, slots=True)
class Kind:
    name: str
    below: str | None
    needs: tuple[str, ...]
    rank: int


def test_cells_become_fields_of_their_names() -> None:
    made = record(Kind, ROW, rank=int(ROW["rank"]))
    assert made == Kind(name="gym", below=None, needs=("numpy", "scipy"), rank=3)
    assert record(Kind, {**ROW, "needs": "", "below": "2"}, rank=0, name="other") == Kind(
        name="other", below="2", needs=(), rank=0
    )


def test_what_no_column_and_nobody_gives_is_an_error() -> None:
    with pytest.raises(KeyError):
        record(Kind, ROW)  # a number is more than a cell
    with pytest.raises(KeyError, match="needs"):
        record(Kind, {name: cell for name, cell in ROW.items() if name != "needs"}, rank=3)


def test_values_of_a_key_keep_their_order() -> None:
    assert grouped([("b", 2), ("a", 1), ("b", 1)]) == {"b": (2, 1), "a": (1,)}
