"""What many programs of a tree reach is found once for all of them."""

from __future__ import annotations

import posixpath
import random
from collections import Counter
from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.facts import Mention
from roslab.evidence.python import imports, programs, reached, sibling_folders
from roslab.evidence.python.import_graph import ImportGraph
from roslab.repository.checkout import Repository
from trees import tree_of

GUARD = "if __name__ == '__main__':\n    print('a')\n"
MANY = 300


def reached_in(repository: Repository) -> list[Mention]:
    return [*reached.read(repository, imports.read(repository), programs.read(repository), ())]


@pytest.mark.parametrize("seed", range(30))
def test_a_program_reaches_what_a_walk_from_it_reaches(seed: int) -> None:
    """A name is looked for in the program's folder, and then at the root."""
    draw = random.Random(seed)  # noqa: S311 - no secret
    files = [posixpath.join(folder, f"m{name}.py") for folder in ("", "a", "b") for name in range(6)]
    files = draw.sample(files, 12)
    wanted = {file: frozenset(f"m{draw.randrange(6)}" for _ in range(draw.randrange(3))) for file in files}

    def resolved(file: str, folder: str | None) -> tuple[str, ...]:
        places = ("",) if folder is None else (folder, "")
        paths = (
            next((p for each in places if (p := posixpath.join(each, f"{n}.py")) in files), "") for n in wanted[file]
        )
        return tuple(path for path in paths if path)

    def walked(program: str) -> set[str]:
        found, left = {program}, [program]
        while left:
            left += [new for new in resolved(left.pop(), posixpath.dirname(program)) if new not in found]
            found.update(left)
        return found

    inside: dict[str, set[str]] = {}
    for file in files:
        inside.setdefault(posixpath.dirname(file), set()).add(posixpath.basename(file)[:-3])
    graph = ImportGraph(files, inside, wanted.__getitem__, resolved)
    for program in files:
        found = graph.reach(program) or 0
        assert {file for file in files if found & graph.bit(file)} == walked(program)


def test_each_file_is_looked_at_once_for_all_programs_of_a_folder() -> None:
    files = [f"{folder}/m{number}.py" for folder in "abcd" for number in range(50)]
    looked: Counter[tuple[str, str | None]] = Counter()

    def resolved(file: str, folder: str | None) -> tuple[str, ...]:
        looked[file, folder] += 1
        return tuple(files)

    graph = ImportGraph(files, {"a": {"m"}}, lambda _: frozenset({"m"}), resolved)
    assert all(graph.reach(file) == (1 << len(files)) - 1 for file in files)
    assert set(looked.values()) == {1}
    assert {folder for _, folder in looked} == {None, "a"}


def test_modules_that_import_each_other_all(tmp_path: Path) -> None:
    everyone = "".join(f"import m{number}\n" for number in range(MANY))
    files = {f"m{number}.py": f"{everyone}{GUARD}" for number in range(MANY)}
    repository = tree_of(tmp_path, {**files, "m7.py": f"import zzunknown\n{everyone}{GUARD}"})
    with ends():
        found = reached_in(repository)
    assert {(each.value, each.file, each.line) for each in found} == {("zzunknown", "m7.py", 1)}
    assert len(found) == MANY


def test_the_own_import_is_named_before_another_file_s(tmp_path: Path) -> None:
    files = {"b.py": f"import a\nimport zzone, zztwo\n{GUARD}", "a.py": "import zztwo\nimport zzthree\n"}
    found = reached_in(tree_of(tmp_path, files))
    assert [(each.value, each.file, each.line) for each in found] == [
        ("zzone", "b.py", 2),
        ("zztwo", "b.py", 2),
        ("zzthree", "a.py", 2),
    ]


def test_many_programs_that_need_one_folder(tmp_path: Path) -> None:
    files = {f"a{number}/run.py": f"from a{(number + 1) % MANY} import run\n{GUARD}" for number in range(MANY)}
    repository = tree_of(tmp_path, {**files, "a9/run.py": f"import zzonly\nimport a10.run\n{GUARD}", "c/zzonly.py": ""})
    with ends():
        found = [*sibling_folders.read(repository, ())]
    assert {(each.value, each.inside) for each in found} == {("zzonly", "c")}
    assert len(found) == MANY


def test_a_program_that_reaches_one_that_adds_to_the_path_needs_none(tmp_path: Path) -> None:
    adds = "import sys\nsys.path.append('c')\n"
    files = {"a/run.py": f"import zzonly\nimport b.lib\n{GUARD}", "c/zzonly.py": "", "b/lib.py": ""}
    assert [*sibling_folders.read(tree_of(tmp_path / "plain", files), ())]
    assert not [*sibling_folders.read(tree_of(tmp_path / "adds", {**files, "b/lib.py": adds}), ())]


def test_a_module_beside_the_program_is_not_of_another_folder(tmp_path: Path) -> None:
    files = {"a/run.py": f"import zzonly\n{GUARD}", "b/run.py": f"import a.run\n{GUARD}", "a/zzonly.py": ""}
    found = [*sibling_folders.read(tree_of(tmp_path, files), ())]
    assert [(each.file, each.inside) for each in found] == [("b/run.py", "a")]
