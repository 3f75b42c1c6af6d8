"""Classes with shared methods do what the standard library's do."""

from __future__ import annotations

import copy
import dataclasses
import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType
from typing import Any, ClassVar

import pytest

from roslab.values import dataclass as quick


def classes(module: ModuleType) -> tuple[type, type, type, type]:
    decorator: Any = module.dataclass
    field: Any = module.field

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

    @decorator
    class Pair:
        left: int
        kind: ClassVar[str] = "pair"
        right: int = 0

    return Point, Named, Growing, Pair


@pytest.fixture(params=[dataclasses, quick], ids=["standard", "shared"])
def made(request: pytest.FixtureRequest) -> tuple[Any, Any, Any, Any]:
    """Return the classes as each of the two makes them: one description holds for both."""
    return classes(request.param)


def test_fields_defaults_and_properties(made: tuple[Any, Any, Any, Any]) -> None:
    point, named, growing, _ = made
    one = named(x=1, name="a")
    assert (one.x, one.y, one.name, one.sum, one.seen) == (1, 2, "a", 3, [])
    assert one.seen is not named(x=1).seen
    assert [each.name for each in dataclasses.fields(named)] == ["x", "y", "names", "secret", "name", "seen"]
    assert dataclasses.asdict(point(x=1)) == {"x": 1, "y": 2, "names": (), "secret": ""}
    assert growing(found={"a": 1}).count == 1


def test_replace_and_copy(made: tuple[Any, Any, Any, Any]) -> None:
    point, named, *_ = made
    assert dataclasses.replace(named(x=1, name="a"), x=5) == named(x=5, name="a")
    assert copy.copy(point(x=1)) == copy.deepcopy(point(x=1)) == point(x=1)
    with pytest.raises(TypeError):
        dataclasses.replace(point(x=1), z=5)


def test_equality_and_hash(made: tuple[Any, Any, Any, Any]) -> None:
    point, named, growing, _ = made
    assert point(x=1, secret="a") == point(x=1, secret="b")
    assert point(x=1) != point(x=2)
    assert point(x=1) != named(x=1)
    assert hash(point(x=1, secret="a")) == hash(point(x=1, secret="b"))
    assert len({point(x=1), point(x=1), point(x=2)}) == 2
    assert growing(found={"a": 1}) == growing(found={"a": 1})
    with pytest.raises(TypeError):
        hash(growing())


def test_what_is_frozen_stays(made: tuple[Any, Any, Any, Any]) -> None:
    point, _, growing, _ = made
    one = point(x=1)
    with pytest.raises(dataclasses.FrozenInstanceError):
        one.x = 2
    with pytest.raises(dataclasses.FrozenInstanceError):
        del one.x
    assert one.x == 1
    other = growing()
    other.count = 4
    assert other.count == 4


def test_what_is_shown(made: tuple[Any, Any, Any, Any]) -> None:
    point, *_ = made
    assert repr(point(x=1, secret="hidden")).endswith("Point(x=1, y=2, names=())")


@pytest.mark.parametrize("given", [{}, {"y": 1}, {"x": 1, "z": 2}])
def test_missing_and_unknown_fields(made: tuple[Any, Any, Any], given: dict[str, int]) -> None:
    point, *_ = made
    with pytest.raises(TypeError):
        point(**given)
    with pytest.raises(TypeError):
        point(1)


def test_fields_by_position(made: tuple[Any, Any, Any, Any]) -> None:
    pair = made[3]
    assert pair(1, 2) == pair(1, right=2) == pair(left=1, right=2)
    assert dataclasses.asdict(pair(1)) == {"left": 1, "right": 0}
    assert pair.kind == "pair"
    for words, named in (((1, 2, 3), {}), ((1,), {"left": 1}), ((), {"right": 1})):
        with pytest.raises(TypeError):
            pair(*words, **named)


def test_a_default_that_could_be_changed_is_refused() -> None:
    for module in (dataclasses, quick):
        decorator: Any = module.dataclass
        with pytest.raises(ValueError, match="default_factory"):

            @decorator
            class Shared:
                names: list[str] = []  # noqa: RUF012 - what is tried


def test_own_functions_answer_as_the_standard_ones() -> None:
    point, named, growing, _ = classes(quick)
    one: Any = named(x=1, name="a", seen=["b"])
    within: Any = growing(found={"one": one, "more": [(one,)]})
    assert quick.asdict(within) == dataclasses.asdict(within)
    assert quick.replace(one, x=5) == dataclasses.replace(one, x=5) != one
    for kind in (point, named, growing):
        described = [
            [(f.name, f.type, f.init, f.repr, f.compare) for f in m.fields(kind)] for m in (quick, dataclasses)
        ]
        assert described[0] == described[1]


def test_a_plan_starts_without_what_few_repositories_need() -> None:
    """The standard dataclasses import ``inspect``, with what reads source code; ``html`` has a table of all names."""
    slow = {"dataclasses", "html", "inspect"}
    code = f"import sys; import roslab.cli.planning; sys.exit(sorted({slow} & sys.modules.keys()) or 0)"
    here = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    assert subprocess.run([sys.executable, "-c", code], env=here, check=False).returncode == 0


def test_a_plan_ends_without_the_standard_fields(tmp_path: Path) -> None:
    """What asks a class for its standard fields, if only whether it has them, imports them and makes them."""
    (tmp_path / "requirements.txt").write_text("numpy\n")
    code = f"import sys; from roslab.cli.main import main; sys.exit(main(['plan', {str(tmp_path)!r}])"
    code += " or sorted({'dataclasses', 'inspect'} & sys.modules.keys()) or 0)"
    here = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", code], env=here, check=False, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "")


def test_is_dataclass() -> None:
    point: Any = classes(quick)[0]
    assert [quick.is_dataclass(each) for each in (point, point(x=1), str, "text")] == [True, True, False, False]
