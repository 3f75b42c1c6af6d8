"""``packaging``'s readers, and what they import themselves: all of it with patterns that wait for their first use."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

SCRIPTS = Path(__file__).parents[3] / "scripts"
USES = """
import sys
sys.path.insert(0, SCRIPTS)
from roslab.values.standard_requirement import InvalidRequirement, Marker, Requirement, SpecifierSet
import dataclasses, locale, logging, platform, string, subprocess, textwrap, traceback

asked = Requirement('torch[a,b] >= 1.9, != 2.* ; python_version < "3.12" and sys_platform in "linux"')
assert (asked.name, sorted(asked.extras), str(asked.specifier)) == ("torch", ["a", "b"], "!=2.*,>=1.9")
assert asked.marker.evaluate({"python_version": "3.10", "sys_platform": "linux"})
assert not Marker("python_version < '3'").evaluate()
assert SpecifierSet("~=1.4.2").contains("1.4.9")
try:
    Requirement("no such thing")
except InvalidRequirement as error:
    assert "Expected" in str(error), error
assert string.Template("$a ${b}").substitute(a=1, b=2) == "1 2"
assert textwrap.fill("one two three", 7) == "one two\\nthree"
assert locale.format_string("%d of %s", (1, "two")) == "1 of two"
assert platform.platform() and platform.python_version_tuple()
for style in "%{$":
    logging.Formatter({"%": "%(message)s", "{": "{message}", "$": "$message"}[style], style=style)
made = dataclasses.make_dataclass("Made", [("other", "int")])
assert made(other=1).other == 1
traceback.format_exc()
subprocess.run([sys.executable, "-c", ""], check=True)
"""


def test_it_and_what_it_imports_work_as_ever() -> None:
    code = f"SCRIPTS = {str(SCRIPTS)!r}\n{USES}"
    answer = subprocess.run([sys.executable, "-I", "-c", code], capture_output=True, text=True, check=False)
    assert answer.returncode == 0, answer.stderr
