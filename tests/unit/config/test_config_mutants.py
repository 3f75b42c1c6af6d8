"""Whatever happens to a file, the answer is a configuration or problems with places: never another exception."""

import dataclasses
import functools
import os
import pathlib
import unicodedata
from typing import Any

import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from hanging import ends
from roslab.config import Config, read
from roslab.config.migrate import comparable, migrate
from roslab.errors import ConfigurationError, Problem

ROOT = pathlib.Path(__file__).resolve().parents[3]
TIMES = int(os.environ.get("REPRO_MUTANTS", "800")) / 800
"""How many more files a campaign tries than a run of the tests."""
MUTANTS = settings(
    max_examples=int(600 * TIMES),
    derandomize=True,
    deadline=None,
    database=None,
    suppress_health_check=list(HealthCheck),
)


@functools.cache
def texts() -> tuple[str, ...]:
    """Return this repository's files, and the real ones where they lie beside it."""
    folder = pathlib.Path(os.environ.get("REPRO_SHARED") or ROOT.parent / "shared") / "roslab-yaml"
    files = [*sorted(folder.glob("*.yaml")), *sorted((ROOT / "tests" / "data" / "config" / "good").glob("*.yaml"))]
    return tuple(file.read_text(encoding="utf-8") for file in files)


def strings(value: Any) -> list[str]:
    """Return every text in a model."""
    if isinstance(value, str):
        return [value]
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return [text for field in dataclasses.fields(value) for text in strings(getattr(value, field.name))]
    return [text for item in value for text in strings(item)] if isinstance(value, tuple) else []


UNSEEN = {"Cc", "Cs", "Zl", "Zp"}
"""Categories of characters that end a line or move a cursor."""
BIDI = {chr(c) for c in (0x61C, *range(0x200B, 0x2010), *range(0x202A, 0x202F), *range(0x2060, 0x2070), 0xAD, 0xA0)}
"""Characters that cannot be seen, or turn the order of those that can."""


def answer(text: str | bytes) -> tuple[Config | None, tuple[Problem, ...]]:
    try:
        return read(text), ()
    except ConfigurationError as error:
        return None, error.problems


def survives(text: str) -> Config | None:
    with ends():
        config, problems = answer(text)
    if config is None:
        assert problems
        assert all(p.hint and p.file == "roslab.yaml" and len(str(p).splitlines()) == 1 for p in problems)
        return None
    said = dataclasses.replace(config, origins=(), warnings=())
    assert not [c for found in strings(said) for c in found if unicodedata.category(c) in UNSEEN or c in BIDI]
    assert all(len(message.splitlines()) == 1 for message, _ in config.warnings)
    return config


SCALARS = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-1, 99_999),
    st.floats(0, 30, allow_nan=False),
    st.text(max_size=12),
    st.sampled_from(["git", "16.04", "a; rm -rf ~", "../x", "-x", "linux/amd64", "noetic", "https://h.org/a", "a\nb"]),
)
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.dictionaries(st.sampled_from(["name", "repo", "commands", "host_path", "ros", "x"]), inner, max_size=3),
    ),
    max_leaves=5,
)


def spots(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    inside = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    return [spot for key, value in inside for spot in [(*path, key), *spots(value, (*path, key))]]


@st.composite
def changed_data(draw: st.DrawFn) -> str:
    """Return a file in which a value was deleted, replaced, wrapped or renamed, or another file's key was added."""
    data = yaml.safe_load(draw(st.sampled_from(texts())))
    for _ in range(draw(st.integers(1, 2))):
        found = spots(data)
        if not found:
            break
        path = draw(st.sampled_from(found))
        holder = data
        for key in path[:-1]:
            holder = holder[key]
        operation = draw(st.sampled_from(["delete", "replace", "replace", "wrap", "nest", "rename", "add"]))
        if operation == "delete":
            del holder[path[-1]]
        elif operation == "replace":
            holder[path[-1]] = draw(VALUES)
        elif operation == "wrap":
            holder[path[-1]] = [holder[path[-1]]]
        elif operation == "nest":
            holder[path[-1]] = {"name": holder[path[-1]]}
        elif operation == "rename" and isinstance(holder, dict):
            holder[draw(SCALARS.filter(lambda key: not isinstance(key, float)))] = holder.pop(path[-1])
        elif operation == "add":
            other = yaml.safe_load(draw(st.sampled_from(texts())))
            data.update(dict([draw(st.sampled_from(sorted(other.items(), key=lambda item: str(item[0]))))]))
    return str(yaml.safe_dump(data, default_flow_style=draw(st.sampled_from([None, True, False]))))


@st.composite
def changed_text(draw: st.DrawFn) -> str:
    """Return a text that was cut off, in which lines were repeated, moved or lost, or characters strewn."""
    text = draw(st.sampled_from(texts()))
    for _ in range(draw(st.integers(1, 3))):
        lines = text.splitlines(keepends=True) or [""]
        at = draw(st.integers(0, len(lines) - 1))
        operation = draw(st.sampled_from(["cut", "repeat", "lose", "indent", "dedent", "strew", "join", "swap"]))
        if operation == "cut":
            text = text[: draw(st.integers(0, len(text)))]
            continue
        if operation == "repeat":
            lines.insert(draw(st.integers(0, len(lines))), lines[at])
        elif operation == "lose":
            del lines[at]
        elif operation == "indent":
            lines[at] = draw(st.sampled_from([" ", "  ", "\t", "- "])) + lines[at]
        elif operation == "dedent":
            lines[at] = lines[at].lstrip()
        elif operation == "swap":
            other = draw(st.integers(0, len(lines) - 1))
            lines[at], lines[other] = lines[other], lines[at]
        elif operation == "join":
            lines[at] = lines[at].rstrip("\n")
        else:
            column = draw(st.integers(0, len(lines[at])))
            character = draw(
                st.one_of(st.sampled_from(list("\t:-#&*!|>'\"%@`{}[],?\x00\ufeff\u2028\ud800~<=")), st.characters())
            )
            lines[at] = lines[at][:column] + character + lines[at][column:]
        text = "".join(lines)
    return text


@MUTANTS
@given(changed_data())
def test_changed_data(text: str) -> None:
    survives(text)


@settings(MUTANTS, max_examples=int(800 * TIMES))
@given(changed_text())
def test_changed_text(text: str) -> None:
    survives(text)


@settings(MUTANTS, max_examples=int(300 * TIMES))
@given(st.one_of(st.text(max_size=200), st.binary(max_size=200)))
def test_noise(noise: str | bytes) -> None:
    config, problems = answer(noise)
    assert (config is None) == bool(problems)


@settings(MUTANTS, max_examples=int(300 * TIMES))
@given(st.one_of(changed_data(), changed_text()))
def test_what_is_read_is_migrated_to_the_same(text: str) -> None:
    config = survives(text)
    if config is not None:
        migrated = read(migrate(text).text)
        assert migrated.generation == "today"
        assert comparable(migrated) == comparable(config)


@pytest.mark.parametrize("kind", ["file", "line by line"])
def test_every_beginning_of_every_file(kind: str) -> None:
    for text in texts():
        lines = text.splitlines(keepends=True)
        for end in range(len(lines)) if kind == "file" else ():
            survives("".join(lines[:end]))
        for leave in range(len(lines)) if kind == "line by line" else ():
            survives("".join(lines[:leave] + lines[leave + 1 :]))
