"""The golden files, in which each part that is the same in every image stands once and is named where it belongs.

``tests/golden/_constant/NAME`` holds such a part; a line ``@@ _constant/NAME @@`` stands for its bytes.
"""

from __future__ import annotations

import re
from pathlib import Path

GOLDEN = Path(__file__).resolve().parent / "golden"
EXAMPLES = GOLDEN.parent.parent / "examples"
CONSTANT = "_constant"
DISTROS = "_distros"
CASES = GOLDEN.parent / "cases"
CASES_GOLDEN = GOLDEN / "_cases"
MARK = re.compile(rf"^@@ {CONSTANT}/(\S+) @@\n", re.MULTILINE)
_CARRIED = re.compile(r"(^COPY (?:--chmod=755 )?<<'EOF' /([\w.-]+)\n)(.*?)(?=^EOF$)", re.MULTILINE | re.DOTALL)
_BODY = re.compile(r"(^# ---- the same for every repository[^\n]*\n)(.*)", re.MULTILINE | re.DOTALL)


def names() -> list[str]:
    """Return the names of the examples, each of which has golden files."""
    return sorted(path.name for path in EXAMPLES.iterdir() if path.is_dir())


def contents(folder: Path) -> dict[str, str]:
    """Return the text of every file below a folder by its relative path."""
    return {str(path.relative_to(folder)): path.read_text() for path in sorted(folder.rglob("*")) if path.is_file()}


def whole(name: str) -> dict[str, str]:
    """Return the files that an example gives, by path, each byte of them."""
    return {path: unfolded(text) for path, text in contents(GOLDEN / name).items()}


def refresh(name: str, made: dict[str, str]) -> None:
    """Write the golden files of an example, and the constant parts that they have."""
    parts = contents(GOLDEN / name)
    for path in parts:
        (GOLDEN / name / path).unlink()
    for path, text in made.items():
        (GOLDEN / name / path).parent.mkdir(parents=True, exist_ok=True)
        (GOLDEN / name / path).write_text(folded(path, text))


def of_distros() -> dict[str, str]:
    """Return the Dockerfile of each ROS distribution, each byte of it."""
    return {path.name: unfolded(path.read_text()) for path in sorted((GOLDEN / DISTROS).iterdir())}


def unfolded(text: str) -> str:
    """Return a golden file with each constant part in its place."""
    return MARK.sub(_part, text)


def folded(path: str, text: str) -> str:
    """Return a file as it is kept, and keep the constant parts that it has."""
    if path == "Dockerfile":
        return _CARRIED.sub(lambda found: found[1] + _kept(found[2], found[3]), text)
    if path.endswith(".sh"):
        return _BODY.sub(lambda found: found[1] + _kept(path, found[2]), text)
    return text


def _kept(name: str, body: str) -> str:
    (GOLDEN / CONSTANT).mkdir(exist_ok=True)
    (GOLDEN / CONSTANT / name).write_text(body)
    return f"@@ {CONSTANT}/{name} @@\n"


def _part(mark: re.Match[str]) -> str:
    return (GOLDEN / CONSTANT / mark[1]).read_text()
