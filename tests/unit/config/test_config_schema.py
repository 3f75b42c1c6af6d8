"""The schema for editors and the reader accept and refuse the same, but for what no schema can say."""

import copy
import json
import pathlib
import random
import re
from collections.abc import Iterator
from typing import Any, get_args

import pytest
import yaml

from roslab.config import read, vocabulary
from roslab.config.model import BuildTool, Generation, Kind, SourceBuild
from roslab.config.source import OLD_TOOLS
from roslab.errors import ConfigurationError
from roslab.knowledge.distros import releases_of

jsonschema = pytest.importorskip("jsonschema")

ONLY_THE_READER = {
    "two are named": "JSON Schema cannot compare the names of a list's items",
    "has no `host_path`": "one volume may be written as three items, so that no item of its own must be complete",
    "has no `container_path`": "the same",
    "has no packages for Ubuntu": "a table of ROS and Ubuntu releases would have to be unfolded into branches",
    "stands here a second time": "a duplicate key is gone once a file is data",
    "it needs a private key": "an address of ssh is right where `secrets` names a key",
    "is not allowed": "a control character is no YAML",
}
"""Words of the reader's message: why the schema cannot say the same."""
VALUES: list[Any] = [
    *(None, True, False, 3, 2.5, 0, "text", "", "a b", [], {}, ["x"], {"a": 1}, "16.04", 16.04, "git", "-x", "../x"),
    *("a\n", "x" * 200, [["a"]], ["git", None], [1], "https://github.com/a/b.git", "ro", 70000, "linux/amd64"),
    *(["linux/amd64"], {"commands": ["a"]}, "noetic", "11.8-devel", {"ubuntu": 20.04}, [{"name": "a"}], "devel"),
]


@pytest.fixture(scope="module")
def schema() -> Any:
    return json.loads(pathlib.Path(vocabulary.SCHEMA).read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def validator(schema: Any) -> Any:
    jsonschema.Draft202012Validator.check_schema(schema)

    def pattern(_validator: Any, expression: str, instance: Any, _schema: Any) -> Iterator[Any]:
        # In Python the last `$` fits before a line break too; in JSON Schema, and so in editors, it does not.
        if isinstance(instance, str) and not re.search(expression.removesuffix("$") + r"\Z", instance):
            yield jsonschema.ValidationError(f"{instance!r} does not fit {expression!r}")

    return jsonschema.validators.extend(jsonschema.Draft202012Validator, {"pattern": pattern})(schema)


def complaint(text: str) -> str | None:
    try:
        read(text)
    except ConfigurationError as error:
        return str(error)
    return None


def agree(validator: Any, text: str, data: Any) -> None:
    told = complaint(text)
    if told and all(any(words in line for words in ONLY_THE_READER) for line in told.splitlines()):
        return
    assert validator.is_valid(data) == (told is None), f"{told}\n{text}"


def files(checkout: pathlib.Path) -> list[pathlib.Path]:
    good = sorted((checkout / "tests" / "data" / "config" / "good").glob("*.yaml"))
    bad = sorted((checkout / "tests" / "bad_input" / "config").glob("*.yaml"))
    assert good
    assert bad
    return good + bad


def test_good_and_bad_files(checkout: pathlib.Path, validator: Any) -> None:
    for file in files(checkout):
        text = file.read_text(encoding="utf-8", errors="replace")
        try:
            data = yaml.safe_load(text)
        except yaml.YAMLError:
            assert complaint(text)  # no data, so that no schema is asked
        else:
            if not isinstance(data, dict) or all(isinstance(key, str) for key in data):
                agree(validator, text, data)


def test_real_files(shared: pathlib.Path, validator: Any) -> None:
    found = sorted((shared / "roslab-yaml").glob("*.yaml"))
    assert found
    for file in found:
        text = file.read_text(encoding="utf-8")
        agree(validator, text, yaml.safe_load(text))


def spots(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    inside = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    found: list[tuple[Any, ...]] = []
    for key, value in inside:
        found += [(*path, key), *spots(value, (*path, key))]
    return found


def mutant(data: Any, others: list[Any], dice: random.Random) -> Any:
    """Change one or two places of a file: delete, replace, wrap, add another file's key, repeat."""
    data = copy.deepcopy(data)
    for _ in range(dice.choice([1, 1, 2])):
        path = dice.choice(spots(data) or [()])
        if not path:
            return data
        holder = data
        for key in path[:-1]:
            holder = holder[key]
        operation = dice.randrange(6)
        if operation == 0:
            del holder[path[-1]]
        elif operation == 1:
            holder[path[-1]] = [holder[path[-1]]]
        elif operation == 2 and isinstance(holder, dict):
            other = dice.choice(others)
            key = dice.choice(list(other))
            data[key] = copy.deepcopy(other[key])
        elif operation == 3 and isinstance(holder, list):
            holder.append(copy.deepcopy(holder[path[-1]]))
        else:
            holder[path[-1]] = copy.deepcopy(dice.choice(VALUES))
    return data


@pytest.mark.parametrize("seed", range(4))
def test_generated_files(checkout: pathlib.Path, validator: Any, seed: int) -> None:
    folder = checkout / "tests" / "data" / "config" / "good"
    data = [yaml.safe_load(file.read_text(encoding="utf-8")) for file in sorted(folder.glob("*.yaml"))]
    dice = random.Random(seed)  # noqa: S311 - repeatable, nothing secret
    for _ in range(400):
        changed = mutant(dice.choice(data), data, dice)
        agree(validator, yaml.safe_dump(changed), changed)


def test_every_example_of_the_schema_fits(schema: Any, validator: Any) -> None:
    def walk(part: Any) -> None:
        if isinstance(part, dict):
            for example in part.get("examples", ()):
                rule = {"$defs": schema["$defs"], **part}
                assert jsonschema.Draft202012Validator(rule).is_valid(example), (part.get("title"), example)
            for value in part.values():
                walk(value)
        elif isinstance(part, list):
            for value in part:
                walk(value)

    walk(schema)


def test_every_definition_is_described_and_used(schema: Any) -> None:
    text = json.dumps(schema)
    for name, part in schema["$defs"].items():
        assert {"title", "description"} <= part.keys(), name
        assert f'"#/$defs/{name}"' in text, name


def test_the_words_of_schema_and_tables_are_the_same(schema: Any) -> None:
    definitions = schema["$defs"]
    assert {v for v in definitions["ubuntu"]["enum"] if isinstance(v, str)} == {
        *vocabulary.rows("ubuntu"),
        *vocabulary.rows("ubuntu").values(),
    }
    assert definitions["ros_distro"]["enum"] == list(releases_of())
    for distro in releases_of():
        assert read(f"base: {{ros: {distro}}}").base.ros == distro
    releases = set(vocabulary.rows("ubuntu").values())
    assert all(set(found) <= releases for found in releases_of().values())


def test_the_words_of_schema_and_model_are_the_same(schema: Any) -> None:
    definitions = schema["$defs"]
    for generation in ("today", "later", "interim", "paper"):
        assert definitions[generation]["properties"]["kind"]["enum"] == list(get_args(Kind))
    assert {OLD_TOOLS.get(tool, tool) for tool in definitions["build_tool"]["enum"]} == set(get_args(BuildTool))
    assert {OLD_TOOLS.get(tool, tool) for tool in definitions["source_build"]["enum"]} == set(get_args(SourceBuild))
    assert {"paper", "later", "interim", "today"} == set(get_args(Generation))


def test_every_table_has_its_source_and_date() -> None:
    for name, table in json.loads(pathlib.Path(vocabulary.WORDS).read_text(encoding="utf-8")).items():
        assert {"about", "source", "date", "rows"} == table.keys(), name
        assert len(table["date"].split("-")) == 3, name


def test_the_exceptions_are_few_and_all_real() -> None:
    assert len(ONLY_THE_READER) <= 7
    read_messages = "".join(
        str(complaint(text))
        for text in (
            "source: [{name: a, repo: 'https://h.org/a'}, {name: a, repo: 'https://h.org/a'}]",
            "volume: [{container_path: /a}]",
            "volume: [{host_path: /a}]",
            "base: {ubuntu: 16.04, ros: noetic}",
            "name: a\nname: b",
            "name: \x00",
            "source: [{name: a, repo: 'git@h.org:a/b'}]",
        )
    )
    assert all(words in read_messages for words in ONLY_THE_READER)
