"""What is no key in a line of a package.xml is taken out of it before rosdep reads it."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-rosdep-keys.sh"
EDITS = re.compile(r"^find [^\n]* -name package.xml .*?\{\} \+$", re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize(
    ("line", "keys"),
    [
        ("<depend>foo</depend>", ["foo"]),
        ("<depend>foo (1.0)</depend>", ["foo"]),
        ("<depend>foo (x) (y)</depend>", ["foo"]),
        ('<depend version_gte="1">foo (x) bar (y)</depend><depend>baz (z)</depend>', ["foo", "bar", "baz"]),
        ("<depend> </depend><depend>foo bar</depend>", ["foo", "bar"]),
    ],
)
def test_a_line_names_keys_alone(tmp_path: Path, line: str, keys: list[str]) -> None:
    (tmp_path / "package.xml").write_text(f"<package>\n  {line}\n</package>\n", encoding="utf-8")
    edits = EDITS.findall(SCRIPT.read_text(encoding="utf-8"))[0]
    subprocess.run(["bash", "-c", f'folders=("$1")\n{edits}', "x", str(tmp_path)], check=True)
    written = (tmp_path / "package.xml").read_text(encoding="utf-8")
    assert [each.strip() for each in re.findall(r"<depend[^>]*>([^<]*)</depend>", written)] == keys
