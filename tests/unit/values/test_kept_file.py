"""What is kept of the program's own files, its modules among them."""

from __future__ import annotations

import atexit
import importlib
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from importlib.machinery import ModuleSpec
from pathlib import Path

import pytest

from roslab.values.kept_file import KeptFile

SCRIPTS = Path(__file__).parents[3] / "scripts"


@pytest.fixture
def module(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleSpec:
    """A module beside whose compiled file things are kept; nothing is written by itself."""
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    monkeypatch.setattr(atexit, "register", lambda _: None)
    return spec_of(tmp_path)


def spec_of(folder: Path) -> ModuleSpec:
    (folder / "__pycache__").mkdir()
    (folder / "module.py").write_text("# as it was\n")
    spec = ModuleSpec("module", None, origin=str(folder / "module.py"))
    spec.cached = str(folder / "__pycache__" / "module.pyc")
    return spec


def kept_beside(module: ModuleSpec) -> Path:
    return Path(module.cached or "").with_suffix(".rows")


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


def keep(module: ModuleSpec | None, *sources: Path) -> None:
    file = KeptFile(module, "rows")
    for each in sources:
        file.value(str(each), words)
    file.write()


def test_what_is_kept_is_not_made_again(module: ModuleSpec, source: Path) -> None:
    keep(module, source)
    assert KeptFile(module, "rows").value(str(source), never) == ["a"]


@pytest.mark.parametrize(("text", "date"), [("b\n", 2), ("b\n", 1 + 1e-6), ("ab\n", 1)])
def test_of_a_file_with_another_date_or_size_it_is_made_anew(
    module: ModuleSpec, source: Path, text: str, date: float
) -> None:
    keep(module, source)
    source.write_text(text)
    os.utime(source, (date, date))
    assert KeptFile(module, "rows").value(str(source), words) == [text.strip()]


def test_by_another_version_of_the_module_it_is_made_anew(module: ModuleSpec, source: Path) -> None:
    keep(module, source)
    Path(module.origin or "").write_text("# as it is now\n")
    with pytest.raises(AssertionError, match="is read again"):
        KeptFile(module, "rows").value(str(source), never)


def test_what_comes_later_is_added_and_what_is_gone_left_out(module: ModuleSpec, source: Path, tmp_path: Path) -> None:
    gone, new = tmp_path / "gone.csv", tmp_path / "new.csv"
    gone.write_text("gone\n")
    new.write_text("new\n")
    keep(module, source, gone)
    before = kept_beside(module).stat().st_size
    gone.unlink()
    keep(module, new)
    kept = KeptFile(module, "rows")
    assert [kept.value(str(each), never) for each in (source, new)] == [["a"], ["new"]]
    assert kept_beside(module).stat().st_size < before + 10
    assert [each.name for each in kept_beside(module).parent.iterdir()] == ["module.rows"]


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
    damage: Callable[[bytes], bytes], module: ModuleSpec, source: Path
) -> None:
    keep(module, source)
    file = kept_beside(module)
    file.write_bytes(damage(file.read_bytes()))
    assert KeptFile(module, "rows").value(str(source), words) == ["a"]
    keep(module, source)
    assert KeptFile(module, "rows").value(str(source), never) == ["a"]


def test_nothing_is_written_where_python_writes_nothing(
    module: ModuleSpec, source: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    keep(module, source)
    assert not kept_beside(module).exists()


def test_a_folder_that_cannot_be_written_is_no_error(module: ModuleSpec, source: Path, tmp_path: Path) -> None:
    module.cached = str(tmp_path / "absent" / "module.pyc")
    keep(module, source)
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
        "kept_modules.install('roslab.cli.commands', 'roslab.decide.deciding')",
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


def test_a_name_that_a_module_lacks_is_told(program: Path) -> None:
    code = (
        "from types import ModuleType",
        "print(isinstance(conda, ModuleType), hasattr(conda, '__path__'))",
        "try:",
        "    from roslab.values.conda import nothing",
        "except ImportError as error:",
        "    print(error)",
    )
    origins(program)
    told = origins(program, *code).splitlines()
    file = program / "roslab" / "values" / "conda.py"
    assert told[1:] == ["True False", f"cannot import name 'nothing' from 'roslab.values.conda' ({file})"]


def test_a_copy_names_its_own_sources(program: Path, tmp_path: Path) -> None:
    origins(program)
    copy = Path(shutil.copytree(program, tmp_path / "copy"))
    file = copy / "roslab" / "values" / "conda.py"
    told = [origins(copy, "print(conda.conda_package.__code__.co_filename)") for _ in range(2)][1]
    assert told == f"_Loader {file}\n{file}\n"


def test_damaged_modules_and_values_are_made_anew(program: Path, module: ModuleSpec, source: Path) -> None:
    keep(module, source)
    origins(program)
    (kept,) = program.glob("**/*.modules")
    for file in (kept, kept_beside(module)):
        whole = file.read_bytes()
        length = 8 + int.from_bytes(whole[:8], "little")
        file.write_bytes(whole[:length] + bytes(len(whole) - length))
    again = KeptFile(module, "rows")
    assert again.value(str(source), words) == ["a"]
    again.write()
    assert KeptFile(module, "rows").value(str(source), never) == ["a"]
    where = program / "roslab" / "values" / "conda.py"
    assert [origins(program, "print(conda.conda_package.__name__)") for _ in range(2)] == [
        f"_Loader {where}\nconda_package\n"
    ] * 2
    assert kept.read_bytes()[length:].strip(b"\0")


def together(program: Path, *code: str) -> list[str]:
    """Import what the commands import, and print how many modules came by themselves, and what ``code`` prints."""
    count = "sum(type(m.__loader__).__name__ == '_Loader' for n, m in sys.modules.items() if n.startswith('roslab.'))"
    return origins(
        program, "import roslab.cli.commands, roslab.decide.deciding", f"print({count})", *code
    ).splitlines()[1:]


def test_what_the_commands_import_comes_as_one_from_the_third_start_on(program: Path) -> None:
    told = [
        together(
            program,
            "import inspect, roslab.decide as room",
            "from roslab.decide import kind",
            "print(kind.__spec__.name, kind.__file__, room.kind is kind, inspect.getsource(kind)[:3])",
            "print(room.__path__, room.__package__, kind.__package__, kind.__spec__.cached == kind.__cached__)",
        )
        for _ in range(4)
    ]
    first, second, third, fourth = (int(alone) for alone, *_ in told)
    assert first == 0
    assert second > 500
    assert third == fourth < 20, "what came before the commands, and themselves"
    folder = program / "roslab" / "decide"
    where = f'roslab.decide.kind {folder / "kind.py"} True """'
    as_package = f"[{str(folder)!r}] roslab.decide roslab.decide True"
    assert [each[1:] for each in told] == [[where, as_package]] * 4


def test_where_a_source_was_changed_all_come_by_themselves_and_then_as_one_again(program: Path) -> None:
    for _ in range(3):
        together(program)
    file = program / "roslab" / "decide" / "kind.py"
    file.write_text(file.read_text(encoding="utf-8") + "\nNEW = 'new'\n", encoding="utf-8")
    told = [together(program, "from roslab.decide.kind import NEW", "print(NEW)") for _ in range(3)]
    assert [each[1] for each in told] == ["new"] * 3
    assert [int(each[0]) > 200 for each in told] == [True, True, False]


def test_a_copy_does_not_take_them_from_elsewhere(program: Path, tmp_path: Path) -> None:
    for _ in range(3):
        together(program)
    copy = Path(shutil.copytree(program, tmp_path / "copy"))
    foreign = (
        f"print([n for n, m in sys.modules.items() if n.startswith('roslab') and {str(copy)!r} not in m.__file__])"
    )
    assert [together(copy, foreign)[1] for _ in range(4)] == ["[]"] * 4


def test_damaged_ones_are_made_anew(program: Path) -> None:
    for _ in range(3):
        together(program)
    (kept,) = program.glob("**/*.together")
    whole = kept.read_bytes()
    length = 8 + int.from_bytes(whole[:8], "little")
    kept.write_bytes(whole[:length] + bytes(len(whole) - length))
    assert [int(together(program)[0]) > 500 for _ in range(2)] == [True, False]
