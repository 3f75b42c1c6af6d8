"""The YAML layer: places, bounds, and what no value may hold."""

import pytest

from hanging import ends
from roslab.config.cited import shown
from roslab.config.document import MAX_CHARACTERS, parse
from roslab.config.node import Mapping, Scalar
from roslab.config.reader import read
from roslab.errors import ConfigurationError

BOMB = "a: &a [x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{chr(98 + i)}: &{chr(98 + i)} [{', '.join(['*' + chr(97 + i)] * 9)}]\n" for i in range(20)
)


def problem(text: str | bytes) -> str:
    with pytest.raises(ConfigurationError) as caught:
        read(text)
    return str(caught.value)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (BOMB, "holds too many values"),
        ("a: &a {b: *a}", "contains itself"),
        ("a: *b", "alias"),
        ("x" * 100_000_000, "holds 100000000 characters"),
        ("apt:\n" + "- git\n" * MAX_CHARACTERS, "characters"),
        ("[" * 10_000, "nested too deep"),
        ("{a: " * 10_000, "nested too deep"),
        ("- " * 10_000 + "x", "nested too deep"),
        ("? " * 10_000, "nested too deep"),
        ("a: &a {x: 1}\nb: {<<: [" + "*a, " * 10_000 + "]}", "holds too many values"),
        ("\n".join(f"k{i}: 1" for i in range(7000)), "unknown key"),
        ("pip: ['" + "a-" * 2000 + "!']", "is no pip requirement"),
        ("pip: ['" + "a>=1," * 800 + "!']", "is no pip requirement"),
        ("apt: ['" + "a*" * 2000 + "!']", "is no apt package"),
        ("cmake_options: '" + "\\a" * 2000 + "\"'", "is no line of shell arguments"),
        ("volume: [{host_path: '/" + "a/" * 500 + "..', container_path: /" + "a/" * 500 + "'}]", "volume"),
    ],
    ids=lambda value: value[:20],
)
def test_a_hostile_file_ends_in_a_clear_error_at_once(text: str, message: str) -> None:
    with ends():
        assert message in problem(text)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("name: a\nx: \x00", "roslab.yaml:2:4: the character U+0000 is not allowed"),
        ("name: \ud800", "the character U+D800 is not allowed"),
        ("name: \x1b[31m", "the character U+001B is not allowed"),
        (b"name: \xff\xfe", "a character is broken: save the file as UTF-8"),
        ("name: a".encode("utf-16"), "U+0000 is not allowed"),
        ("name: a\n---\nname: b", "roslab.yaml:2:1: a second document begins here"),
        ("name: !!python/object/apply:os.system ['true']", "the tag tag:yaml.org,2002:python/object"),
        ("name: !custom a", "the tag !custom is not allowed"),
        ("apt:\n\t- git", "never with tabs"),
        ("? [a]\n: b", "a key must be a word"),
        ("? {a: b}\n: c", "a key must be a word"),
        ("1: a", 'unknown key "1"'),
        ("true: a", 'unknown key "true"'),
        ("~: a", 'unknown key "~"'),
        ("<<: 3", '"<<" takes mappings only'),
        ("name: a: b", "put a value that holds a colon and a space in quotes"),
        ("name: 'a", "close the quote"),
        ("apt: [git", "close the bracket"),
        (
            "name: a\nname: b\nname: c",
            '2:1: "name" stands here a second time (keep one of them: the first is on line 1)',
        ),
        ("base: {ros: noetic, ros: melodic}", 'roslab.yaml:1:21: "ros" stands here a second time'),
    ],
    ids=lambda value: repr(value)[:25],
)
def test_what_is_no_yaml_says_where_and_why(text: str | bytes, message: str) -> None:
    assert message in problem(text)


@pytest.mark.parametrize(
    "text", ["\ufeffname: a", b"\xef\xbb\xbfname: a", b"# caf\xe9\nname: a", "name: a\r\n", "--- {name: a}\n..."]
)
def test_marks_comments_and_line_ends_do_no_harm(text: str | bytes) -> None:
    assert read(text).name == "a"


def test_the_limit_of_the_parser_itself_is_told_as_ours(monkeypatch: pytest.MonkeyPatch) -> None:
    """libyaml 0.2.6 (PyYAML 6.0.4) counts levels itself and scans ahead, so that its error comes before ours."""
    import yaml

    mark = yaml.Mark("f", 1000, 0, 1000, None, 0)
    error = yaml.scanner.ScannerError("while increasing flow level", mark, "exceeded maximum nesting depth", mark)

    def limited(text: str, **_: object) -> object:
        raise error

    monkeypatch.setattr(yaml, "parse", limited)
    assert problem("[" * 2000).startswith("roslab.yaml:1:1001: nested too deep (at most 32 levels are read")


def test_every_problem_is_told_at_once_in_the_order_of_the_lines() -> None:
    told = problem("bild: cmake\nname: 'a b'\napt: {}\nbase: {ubuntu: 17.10, opengl: yes}\nname: c")
    assert [line.split(":")[1] for line in told.splitlines()] == ["1", "2", "3", "4", "4", "5"]


def test_numbers_keep_their_text() -> None:
    root = parse("a: 20.10\nb: 1_0\nc: 'x'\nd: ~\ne: yes\nf: 22:22\ng: 2019-01-01\nh: !!str 3", file="f").root
    assert isinstance(root, Mapping)
    found = {key.text: (value.text, value.kind) for key, value in root.pairs if isinstance(value, Scalar)}
    assert found == {
        "a": ("20.10", "number"),
        "b": ("1_0", "integer"),
        "c": ("x", "string"),
        "d": ("~", "null"),
        "e": ("yes", "boolean"),
        "f": ("22:22", "integer"),
        "g": ("2019-01-01", "date"),
        "h": ("3", "string"),
    }


def test_aliases_and_merges_are_read_as_written_out() -> None:
    config = read(
        "format: 3\napt: &x [git]\nsource:\n- &y {name: a, repo: 'https://h.org/a', depends: *x}\n- {<<: *y, name: b}"
    )
    assert [source.name for source in config.source] == ["a", "b"]
    assert config.source[1].depends == ("git",)
    assert config.source[1].repo == "https://h.org/a"


def test_messages_are_one_line_without_control_characters() -> None:
    assert shown("a\x1b]0;b\u202e\n") == "a\\x1b]0;b\\u202e\\n"
    assert len(shown("x" * 1000)) == 60
    assert len(problem('name: "a\\x1b[31m\\nb"').splitlines()) == 1


def test_the_parser_without_c_finds_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    import yaml

    text = "# c\nname: ünï\nbase:\n  ubuntu: 16.04 # d\napt: ['a', \"b\"]\n"
    before = parse(text, file="f").root
    monkeypatch.setattr("roslab.config.document._LOADER", yaml.SafeLoader)
    after = parse(text, file="f").root
    assert isinstance(before, Mapping)
    assert isinstance(after, Mapping)
    assert [(k.start, k.end, k.text) for k, _ in before.pairs] == [(k.start, k.end, k.text) for k, _ in after.pairs]
    assert "nested too deep" in problem("[" * 10_000)
    assert "no valid YAML" in problem('name: "\\UFFFFFFFF"')
    assert "no valid YAML" in problem('name: "\\U00110000"')
