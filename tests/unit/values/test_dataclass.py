"""Classes with shared methods do what the standard library's do."""

from __future__ import annotations

import copy
import dataclasses
from collections.abc import Callable
from dataclasses import field
from typing import Any

import pytest

from roslab.values import dataclass as quick

Decorator = Callable[..., Callable[[type], type]]


def classes(decorator: Decorator) -> tuple[type, type, type]:
    @decorator(frozen=True, kw_only=True, slots=True)
    class Point:
        """A value."""

        x: int
        y: int = 2
        names: tuple[str, ...] = ()
        secret: str = field(default="", repr=False, compare=False)

        @property
        def sum(self) -> int:
            return self.x + self.y

    @decorator(frozen=True, kw_only=True, slots=True)
    class Named(Point):
        name: str = "origin"
        seen: list[str] = field(default_factory=list, compare=False)

    @decorator(kw_only=True, slots=True)
    class Growing:
        found: dict[str, int] = field(default_factory=dict)
        count: int = field(default=0, init=False)

        def __post_init__(self) -> None:
            self.count = len(self.found)

    return Point, Named, Growing


@pytest.fixture(params=[dataclasses.dataclass, quick.dataclass], ids=["standard", "shared"])
def made(request: pytest.FixtureRequest) -> tuple[Any, Any, Any]:
    """Return the classes as each of the two makes them: one description holds for both."""
    return classes(request.param)


def test_fields_defaults_and_properties(made: tuple[Any, Any, Any]) -> None:
    point, named, growing = made
    one = named(x=1, name="a")
    assert (one.x, one.y, one.name, one.sum, one.seen) == (1, 2, "a", 3, [])
    assert one.seen is not named(x=1).seen
    assert [each.name for each in dataclasses.fields(named)] == ["x", "y", "names", "secret", "name", "seen"]
    assert dataclasses.asdict(point(x=1)) == {"x": 1, "y": 2, "names": (), "secret": ""}
    assert growing(found={"a": 1}).count == 1


def test_replace_and_copy(made: tuple[Any, Any, Any]) -> None:
    point, named, _ = made
    assert dataclasses.replace(named(x=1, name="a"), x=5) == named(x=5, name="a")
    assert copy.copy(point(x=1)) == copy.deepcopy(point(x=1)) == point(x=1)
    with pytest.raises(TypeError):
        dataclasses.replace(point(x=1), z=5)


def test_equality_and_hash(made: tuple[Any, Any, Any]) -> None:
    point, named, growing = made
    assert point(x=1, secret="a") == point(x=1, secret="b")
    assert point(x=1) != point(x=2)
    assert point(x=1) != named(x=1)
    assert hash(point(x=1, secret="a")) == hash(point(x=1, secret="b"))
    assert len({point(x=1), point(x=1), point(x=2)}) == 2
    assert growing(found={"a": 1}) == growing(found={"a": 1})
    with pytest.raises(TypeError):
        hash(growing())


def test_what_is_frozen_stays(made: tuple[Any, Any, Any]) -> None:
    point, _, growing = made
    one = point(x=1)
    with pytest.raises(dataclasses.FrozenInstanceError):
        one.x = 2
    with pytest.raises(dataclasses.FrozenInstanceError):
        del one.x
    assert one.x == 1
    other = growing()
    other.count = 4
    assert other.count == 4


def test_what_is_shown(made: tuple[Any, Any, Any]) -> None:
    point, *_ = made
    assert repr(point(x=1, secret="hidden")).endswith("Point(x=1, y=2, names=())")


@pytest.mark.parametrize("given", [{}, {"y": 1}, {"x": 1, "z": 2}])
def test_missing_and_unknown_fields(made: tuple[Any, Any, Any], given: dict[str, int]) -> None:
    point, *_ = made
    with pytest.raises(TypeError):
        point(**given)
    with pytest.raises(TypeError):
        point(1)


def test_fields_by_position_are_refused() -> None:
    decorator: Any = quick.dataclass
    with pytest.raises(TypeError, match="position"):
        decorator(frozen=True)
