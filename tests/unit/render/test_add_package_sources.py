"""A PPA that an old release cannot ask Launchpad for is added by its key and its address."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

FINGERPRINT = "60C317803A41BA51845E371A1E9377A2BA9EF27F"
PPA = "ppa:ubuntu-toolchain-r/test"
CURL = f"""#!/bin/bash
for word in "$@"; do address="$word"; done
case "$address" in
  *api.launchpad.net*) [ -e known ] && echo '{{"name": "test", "signing_key_fingerprint": "{FINGERPRINT}", "a": 1}}' ;;
  *op=get*search=0x{FINGERPRINT}) while [ "$1" != --output ]; do shift; done; printf key >"$2" ;;
  *) exit 22 ;;
esac
"""


def run(there: Path, *, answers: bool, known: bool, apt: str) -> str:
    """Run the script with folders of ``there`` in the place of the system's, and return the sources and keys."""
    script = (Path(image_scripts.__path__[0]) / "add-package-sources.sh").read_text(encoding="utf-8")
    for folder in ("/usr/share/keyrings", "/etc/apt/sources.list.d", "/usr/local/share/roslab"):
        (there / folder.lstrip("/")).mkdir(parents=True)
        script = script.replace(f"{folder}/", f".{folder}/")
    script = script[: script.index("rm -rf /var/cache")]
    programs = {
        "apt-get": "exit 0",
        "apt-key": 'echo "trusted $2" >>trusted',
        "add-apt-repository": f"exit {0 if answers else 1}",
        "lsb_release": "echo trusty",
        "dpkg": '[ "$2" != "$4" ] && printf "%s\\n" "$2" "$4" | sort --version-sort --check=quiet',
        "dpkg-query": f"printf {apt}",
        "curl": CURL,
    }
    for name, text in programs.items():
        (there / name).write_text(text if text.startswith("#!") else f"#!/bin/bash\n{text}\n", encoding="utf-8")
        (there / name).chmod(0o755)
    if known:
        (there / "known").touch()
    env = {"PATH": f"{there}:/usr/bin:/bin"}
    subprocess.run(["bash", "-c", script, "add", PPA], cwd=there, check=True, env=env, capture_output=True)
    files = (
        *(there / "etc/apt/sources.list.d").iterdir(),
        there / "usr/local/share/roslab/left-out.txt",
        there / "trusted",
    )
    return "".join(file.read_text(encoding="utf-8") for file in files if file.exists())


LINE = (
    "deb [signed-by=./usr/share/keyrings/roslab-1.gpg] "
    "http://ppa.launchpad.net/ubuntu-toolchain-r/test/ubuntu trusty main\n"
)


@pytest.mark.parametrize(
    ("answers", "known", "apt", "found"),
    [
        (True, True, "2.4", ""),
        (False, True, "1.2", LINE),
        (False, True, "1.0.1", f"{LINE}trusted ./usr/share/keyrings/roslab-1.gpg\n"),
        (False, False, "1.2", f"source {PPA}\n"),
    ],
)
def test_a_ppa_is_added(tmp_path: Path, answers: bool, known: bool, apt: str, found: str) -> None:
    assert run(tmp_path, answers=answers, known=known, apt=apt) == found
