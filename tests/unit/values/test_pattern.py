"""Patterns that wait for their first use."""

from __future__ import annotations

import importlib
import marshal
import pkgutil
import re
import subprocess
import sys
from pathlib import Path

import pytest

import roslab
from roslab.values import kept_patterns
from roslab.values.pattern import named_by, pattern, postponed
from roslab.values.word_first import word_first


def test_it_is_a_pattern() -> None:
    word = pattern(r"(?P<name>\w+)!", re.IGNORECASE)
    for _ in range(2):  # the second use of each method is the compiled pattern's own
        assert word.findall("a! B!") == ["a", "B"]
        assert word.sub("-", "a! b") == "- b"
        found = word.fullmatch("Ab!")
        assert found
        assert found["name"] == "Ab"
    assert word.pattern == r"(?P<name>\w+)!"
    assert word.groups == 1


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("numpy", True),
        ("numpy2", False),
        ("a.b", True),
        ("aXb", False),
        ("mmcv-full", True),
        ("my_config", True),
        ("my_configs", False),
    ],
)
def test_a_name_is_told_by_those_with_a_star_and_those_without(name: str, *, told: bool) -> None:
    assert bool(named_by(("numpy", "a.b", "mmcv*", "*_config")).match(name)) is told


def test_a_wrong_one_is_told_at_its_first_use() -> None:
    wrong = pattern("(")
    with pytest.raises(re.error):
        wrong.match("(")


def test_what_is_imported_meanwhile_waits_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "some_library.py").write_text("import re\nWORD = re.compile('a+', re.I)\nWRONG = re.compile('(')\n")
    monkeypatch.syspath_prepend(tmp_path)
    at_once = re.compile
    with postponed():
        library = importlib.import_module("some_library")
    assert re.compile is at_once
    assert library.WORD.fullmatch("aA")
    with pytest.raises(re.error):
        library.WRONG.match("(")


def _patterns() -> list[re.Pattern[str]]:
    """Return every pattern that a module of the program has by a name."""
    found_modules = pkgutil.walk_packages(roslab.__path__, "roslab.")
    names = [each.name for each in found_modules if not {"__main__", "probes"} & set(each.name.split("."))]
    kind = type(pattern(""))
    return [
        value for name in names for value in vars(importlib.import_module(name)).values() if isinstance(value, kind)
    ]


def test_every_pattern_of_the_program_can_be_compiled() -> None:
    found = _patterns()
    assert len(found) > 100
    for each in found:
        assert each.groups >= 0


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The file of kept patterns, in a folder of its own and not yet written."""
    monkeypatch.setattr(kept_patterns, "_file", lambda: str(tmp_path / "kept"))
    monkeypatch.setattr(kept_patterns, "_kept", None)
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    return tmp_path / "kept"


def _read_again(monkeypatch: pytest.MonkeyPatch) -> None:
    kept_patterns._write()
    monkeypatch.setattr(kept_patterns, "_kept", None)


@pytest.mark.skipif(sys.version_info[:2] not in kept_patterns.SEEN, reason="this Python keeps no patterns")
def test_a_kept_pattern_is_what_re_compiles(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    given = [(word_first(*each._given), each._given[1]) for each in _patterns()]  # type: ignore[attr-defined]
    for source, flags in given:
        assert kept_patterns.compiled(source, flags) == re.compile(source, flags)
    _read_again(monkeypatch)
    monkeypatch.setattr(kept_patterns, "_form", None)  # nothing is compiled any more
    for source, flags in given:
        found, expected = kept_patterns.compiled(source, flags), re.compile(source, flags)
        assert found == expected
        assert (found.flags, found.groups, found.groupindex) == (expected.flags, expected.groups, expected.groupindex)


@pytest.mark.skipif(sys.version_info[:2] not in kept_patterns.SEEN, reason="this Python keeps no patterns")
@pytest.mark.parametrize(
    "text", [b"", b"no form", b"i\x01\x00\x00\x00", marshal.dumps(("another release", {("a", 0): 1}))]
)
def test_a_file_that_is_damaged_or_of_another_python_is_written_anew(
    file: Path, monkeypatch: pytest.MonkeyPatch, text: bytes
) -> None:
    file.write_bytes(text)
    assert kept_patterns.compiled("a", 0).match("a")
    _read_again(monkeypatch)
    monkeypatch.setattr(kept_patterns, "_form", None)
    assert kept_patterns.compiled("a", 0).match("a")


def test_nothing_is_written_where_python_writes_nothing(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert kept_patterns.compiled("a", 0).match("a")
    kept_patterns._write()
    assert not file.exists()


def test_a_folder_that_cannot_be_written_is_no_error(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept_patterns, "_file", lambda: str(file / "absent" / "kept"))
    assert kept_patterns.compiled("a", 0).match("a")
    kept_patterns._write()


def test_a_python_whose_halves_nobody_saw_compiles_anew(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kept_patterns, "_KEEPS", False)
    assert kept_patterns.compiled(r"\b(a)b", 0) == re.compile(r"(a(?<=\ba))b")
    kept_patterns._write()
    assert kept_patterns._kept is None


@pytest.mark.parametrize(
    ("source", "flags", "turned"),
    [
        (r"\bgit\b", 0, r"git(?<=\bgit)\b"),
        (r"\b(?:wget|curl)\b", 0, r"(?:wget(?<=\bwget)|curl(?<=\bcurl))\b"),
        (r"\b(foo|b[ar]r)\b", 0, r"(foo(?<=\bfoo)|b(?<=\bb)[ar]r)\b"),
        (r"\bray\.tune\b|\bfrom[ \t]+ray", 0, r"ray\.tune(?<=\bray\.tune)\b|from(?<=\bfrom)[ \t]+ray"),
        (r"(?<![\w./-])cp[ \t]+", 0, r"cp(?<=(?<![\w./-])cp)[ \t]+"),
        (r"\b(?<!-)if", 0, r"if(?<=\b(?<!-)if)"),
        (r"^from[ \t]", re.MULTILINE, r"from(?<=^from)[ \t]"),
        (r"(?m)^(?:from|import)", 0, r"(?m)(?:from(?<=^from)|import(?<=^import))"),
        (r"\bwandb?\.", 0, r"wand(?<=\bwand)b?\."),
        (r"\bA[|)]x|c", 0, r"A(?<=\bA)[|)]x|c"),
        (r"^from[ \t]", 0, None),  # the beginning of the text alone: there is nothing to look for
        (r"\bgit\b", re.IGNORECASE, None),  # Python looks for no letters then
        (r"(?i)\bgit\b", 0, None),
        (r"\b git # a comment", re.VERBOSE, None),
        (r"\b(?:ba)?sh\b", 0, None),
        (r"\ba{2}", 0, None),
        (r"\b(?:\w|a)", 0, None),
        (r"\b(?i:git)", 0, None),
        (r"\b(", 0, None),
    ],
)
def test_a_pattern_is_written_with_its_word_first(source: str, flags: int, turned: str | None) -> None:
    assert word_first(source, flags) == (turned or source)


def test_a_pattern_with_its_word_first_finds_the_same() -> None:
    root = Path(__file__).parents[3]
    files = (*root.glob("*.md"), *root.glob("examples/*/*.*"), *root.glob("scripts/roslab/evidence/python/*.py"))
    text = "\n".join(file.read_text(encoding="utf-8", errors="replace")[:4_000] for file in sorted(files)[:40])
    changed = found = 0
    for each in _patterns():
        source, flags = each._given  # type: ignore[attr-defined]
        turned = word_first(source, flags)
        if turned != source:
            expected = [(match.span(), match.groups()) for match in re.compile(source, flags).finditer(text)]
            assert [(match.span(), match.groups()) for match in re.compile(turned, flags).finditer(text)] == expected
            changed, found = changed + 1, found + len(expected)
    assert changed > 100
    assert found > 1_000


def test_a_pattern_that_nothing_keeps_is_compiled_while_others_wait(tmp_path: Path) -> None:
    """A library may use one of its patterns while it is imported, as packaging does on a fresh installation."""
    lines = (
        "import re, sys",
        f"sys.pycache_prefix = {str(tmp_path)!r}",
        f"sys.path.insert(0, {str(Path(roslab.__path__[0]).parent)!r})",
        "from roslab.values.pattern import postponed",
        "with postponed():",
        r"    assert re.compile(r'\bgit\b').search('a git')",
    )
    answer = subprocess.run([sys.executable, "-I", "-c", "\n".join(lines)], capture_output=True, text=True, check=False)
    assert answer.returncode == 0, answer.stderr[-300:]
