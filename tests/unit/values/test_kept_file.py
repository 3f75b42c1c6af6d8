"""What is kept of the program's own files, its modules among them."""

from __future__ import annotations

import atexit
import importlib
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.values.kept_file import KeptFile

SCRIPTS = Path(__file__).parents[3] / "scripts"


@pytest.fixture
def compiled(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """The path of a module's compiled file, beside which things are kept; nothing is written by itself."""
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    monkeypatch.setattr(atexit, "register", lambda _: None)
    (tmp_path / "__pycache__").mkdir()
    return str(tmp_path / "__pycache__" / "module.pyc")


@pytest.fixture
def source(tmp_path: Path) -> Path:
    path = tmp_path / "table.csv"
    path.write_text("a\n")
    os.utime(path, (1, 1))
    return path


def words(path: str) -> list[str]:
    return Path(path).read_text(encoding="utf-8").split()


def never(path: str) -> list[str]:
    raise AssertionError(f"{path} is read again")


never.__name__ = words.__name__  # what is made is kept under the name of its maker


def keep(compiled: str, *sources: Path) -> None:
    file = KeptFile(compiled, "rows")
    for each in sources:
        file.value(str(each), words)
    file.write()


def test_what_is_kept_is_not_made_again(compiled: str, source: Path) -> None:
    keep(compiled, source)
    assert KeptFile(compiled, "rows").value(str(source), never) == ["a"]


@pytest.mark.parametrize(("text", "date"), [("b\n", 2), ("b\n", 1 + 1e-6), ("ab\n", 1)])
def test_of_a_file_with_another_date_or_size_it_is_made_anew(
    compiled: str, source: Path, text: str, date: float
) -> None:
    keep(compiled, source)
    source.write_text(text)
    os.utime(source, (date, date))
    assert KeptFile(compiled, "rows").value(str(source), words) == [text.strip()]


def test_what_comes_later_is_added_and_what_is_gone_left_out(compiled: str, source: Path, tmp_path: Path) -> None:
    gone, new = tmp_path / "gone.csv", tmp_path / "new.csv"
    gone.write_text("gone\n")
    new.write_text("new\n")
    keep(compiled, source, gone)
    before = Path(compiled).with_suffix(".rows").stat().st_size
    gone.unlink()
    keep(compiled, new)
    kept = KeptFile(compiled, "rows")
    assert [kept.value(str(each), never) for each in (source, new)] == [["a"], ["new"]]
    assert Path(compiled).with_suffix(".rows").stat().st_size < before + 10
    assert [each.name for each in Path(compiled).parent.iterdir()] == ["module.rows"]


@pytest.mark.parametrize(
    "damage",
    [
        lambda _: b"",
        lambda _: b"nothing of this kind",
        lambda whole: whole[:-1],
        lambda whole: whole.replace(sys.version.encode(), b"?" * len(sys.version.encode())),
    ],
    ids=["empty", "foreign", "cut off", "of another Python"],
)
def test_a_damaged_file_or_one_of_another_python_is_written_anew(
    damage: Callable[[bytes], bytes], compiled: str, source: Path
) -> None:
    keep(compiled, source)
    file = Path(compiled).with_suffix(".rows")
    file.write_bytes(damage(file.read_bytes()))
    assert KeptFile(compiled, "rows").value(str(source), words) == ["a"]
    keep(compiled, source)
    assert KeptFile(compiled, "rows").value(str(source), never) == ["a"]


def test_nothing_is_written_where_python_writes_nothing(
    compiled: str, source: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    keep(compiled, source)
    assert not Path(compiled).with_suffix(".rows").exists()


def test_a_folder_that_cannot_be_written_is_no_error(source: Path, tmp_path: Path) -> None:
    keep(str(tmp_path / "absent" / "module.pyc"), source)
    assert not (tmp_path / "absent").exists()


def test_a_module_without_a_compiled_file_keeps_nothing(source: Path) -> None:
    file = KeptFile(None, "rows")
    assert file.value(str(source), words) == ["a"]
    file.write()


@pytest.fixture
def program(tmp_path: Path) -> Path:
    """A copy of the program, which has compiled nothing yet."""
    return Path(shutil.copytree(SCRIPTS, tmp_path / "scripts", ignore=shutil.ignore_patterns("__pycache__")))


def origins(program: Path, *code: str) -> str:
    """Import a module of the program, as its commands do, and print which loader it had, and what ``code`` prints."""
    lines = (
        "import sys",
        f"sys.path.insert(0, {str(program)!r})",
        "from roslab.values import kept_modules",
        "kept_modules.install()",
        "from roslab.values import conda",
        "print(type(conda.__loader__).__name__, conda.__file__)",
        *code,
    )
    answer = subprocess.run([sys.executable, "-I", "-c", "\n".join(lines)], capture_output=True, text=True, check=True)
    return answer.stdout


def test_a_module_comes_from_the_file_from_the_second_start_on(program: Path) -> None:
    file = program / "roslab" / "values" / "conda.py"
    assert origins(program) == f"SourceFileLoader {file}\n"
    told = origins(program, "import inspect", "print(conda.__spec__.cached, inspect.getsource(conda)[:10])")
    cached = importlib.util.cache_from_source(str(file))
    assert told == f"_Loader {file}\n{cached} {file.read_text(encoding='utf-8')[:10]}\n"


def test_a_module_that_was_changed_is_compiled_anew(program: Path) -> None:
    file = program / "roslab" / "values" / "conda.py"
    origins(program)
    file.write_text(file.read_text(encoding="utf-8") + "\nNEW = 'new'\n", encoding="utf-8")
    for loader in ("SourceFileLoader", "_Loader"):
        assert origins(program, "print(conda.NEW)") == f"{loader} {file}\nnew\n"


def test_a_module_that_is_gone_is_not_found(program: Path) -> None:
    origins(program)
    (program / "roslab" / "values" / "conda.py").unlink()
    with pytest.raises(subprocess.CalledProcessError):
        origins(program)


def test_a_copy_of_the_program_has_its_own_modules(program: Path, tmp_path: Path) -> None:
    origins(program)
    copy = Path(shutil.copytree(program, tmp_path / "copy"))
    assert origins(copy) == f"SourceFileLoader {copy / 'roslab' / 'values' / 'conda.py'}\n"


def test_packages_are_found_with_what_is_in_them(program: Path) -> None:
    code = ("import roslab.evidence.lex.yaml as found", "print(found.__package__, *roslab.evidence.lex.__path__)")
    for _ in range(2):
        told = origins(program, "import roslab", *code).splitlines()
        assert told[1] == f"roslab.evidence.lex {program / 'roslab' / 'evidence' / 'lex'}"
