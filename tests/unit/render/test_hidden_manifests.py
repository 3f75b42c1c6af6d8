"""A manifest.xml beside a package.xml is hidden from rosdep, which would take it in the place of that."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-rosdep-keys.sh"


def test_a_manifest_beside_a_package_xml_is_hidden_and_comes_back(tmp_path: Path) -> None:
    for path in ("a b/manifest.xml", "a b/package.xml", "old/manifest.xml", "new/package.xml"):
        (tmp_path / "src" / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "src" / path).write_text(path)
    text = SCRIPT.read_text()
    hide = re.search(r"^hide_manifests\(\) \{\n.*?^\}\n", text, re.MULTILINE | re.DOTALL)
    back = re.search(r"^find [^\n]*manifest\.xml\.hidden[^\n]*\n", text, re.MULTILINE)
    assert hide
    assert back
    said = f"set -euo pipefail\nfolders=(src)\n{hide[0]}hide_manifests\nhide_manifests\nfind src -type f\n{back[0]}"
    ran = subprocess.run(["bash", "-c", said], cwd=tmp_path, capture_output=True, text=True, check=True)
    hidden = {"src/a b/manifest.xml.hidden", "src/a b/package.xml", "src/old/manifest.xml", "src/new/package.xml"}
    assert {*ran.stdout.splitlines()} == hidden
    assert (tmp_path / "src/a b/manifest.xml").read_text() == "a b/manifest.xml"
    assert not (tmp_path / "src/a b/manifest.xml.hidden").exists()


def test_every_call_of_rosdep_install_comes_after_it() -> None:
    text = SCRIPT.read_text()
    assert text.count("rosdep install") == 1
    assert text.index("hide_manifests\n  rosdep install")
