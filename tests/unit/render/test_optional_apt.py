"""The script that installs what apt knows and leaves out the rest, with as few calls of apt as there can be."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/install-optional-apt.sh"
APT = """\
#!/bin/bash
# Stands in for apt-get: of what begins with no- it knows nothing, virtual- has no package, clash-… and other-… exclude
# each other, broken- can be chosen and not unpacked, and stuck- has a dependency that is nowhere;
# g++-14 is a pattern to it
echo "$*" >>{folder}/calls
if [ "$1" = update ]; then exit; fi
simulated='' exact='' asked=() code=0
for word in "${{@:2}}"; do
  case "${{word}}" in
    --simulate) simulated=yes ;;
    -oAPT::Cmd::Pattern-Only=true) exact=yes ;;
    -*) ;;
    g++-14) if [ -z "${{exact}}" ]; then asked+=(clang-14)
      else echo "E: Unable to locate package ${{word}}" >&2 && code=100; fi ;;
    no-*) echo "E: Unable to locate package ${{word}}" >&2 && code=100 ;;
    virtual-*) echo "E: Package '${{word}}' has no installation candidate" >&2 && code=100 ;;
    stuck-*) echo "E: Unable to correct problems, you have held broken packages." >&2 && code=100 ;;
    broken-*) asked+=("${{word}}") && if [ -z "${{simulated}}" ]; then code=100; fi ;;
    *) asked+=("${{word}}") ;;
  esac
done
if [[ " ${{asked[*]}} " = *" clash-"* && " ${{asked[*]}} " = *" other-"* ]]; then code=100; fi
if [ "${{code}}" = 0 ] && [ -z "${{simulated}}" ]; then printf '%s\\n' "${{asked[@]}}" >>{folder}/installed; fi
exit "${{code}}"
"""


@pytest.mark.parametrize(
    ("asked", "installed", "left", "calls"),
    [
        ("a b c", "a b c", "", 3),
        ("a no-x b virtual-y", "a b", "no-x virtual-y", 4),
        ("no-x", "", "no-x", 2),
        ("a stuck-x no-y b", "a b", "stuck-x no-y", 8),
        ("clash-a other-b c", "clash-a other-b c", "", 10),
        ("a broken-x b", "a b", "broken-x", 6),
        ("a a.b no-a", "a a.b", "no-a", 4),
        ("a g++-14", "a", "g++-14", 4),
    ],
)
def test_what_apt_knows_is_installed(tmp_path: Path, asked: str, installed: str, left: str, calls: int) -> None:
    if not shutil.which("bash"):
        pytest.skip("there is no bash")
    (tmp_path / "apt-get").write_text(APT.format(folder=tmp_path))
    (tmp_path / "apt-get").chmod(0o755)
    text = SCRIPT.read_text().replace("=/tmp/", f"={tmp_path}/")
    text = text.replace("/usr/local/share/roslab/left-out.txt", f"{tmp_path}/left")
    text = text[: text.index("rm -rf /var/cache")]  # what follows tidies a real image
    environment = os.environ | {"PATH": f"{tmp_path}:{os.environ['PATH']}"}
    done = subprocess.run(
        ["bash", "-c", text, "install-optional-apt", *asked.split()],
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 0, done.stderr

    def lines(name: str) -> list[str]:
        return (tmp_path / name).read_text().splitlines() if (tmp_path / name).exists() else []

    assert lines("installed") == installed.split()
    assert lines("left") == [f"apt {each}" for each in left.split()]
    assert [line for line in done.stdout.splitlines() if "left out" in line] == [
        f"roslab: left out: apt {each}" for each in left.split()
    ]
    assert len(lines("calls")) == calls
