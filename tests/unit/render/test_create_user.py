"""The script that makes the image's user: git takes old addresses of code hosts by https."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile

from .conftest import make

SCRIPT = Path(image_scripts.__path__[0]) / "create-user.sh"
STAND_INS = {
    "getent": 'echo "jovyan:x:$NB_UID:$GROUP::$HOME_OF_USER:/bin/bash"',
    "dpkg-query": "true",
}
"""Programs that would change this machine or do not know the user."""


@pytest.mark.parametrize(
    ("words", "address", "taken"),
    [
        ([], "git://github.com/lab/nav.git", "https://github.com/lab/nav.git"),
        ([], "git@github.com:lab/nav.git", "https://github.com/lab/nav.git"),
        ([], "ssh://git@gitlab.com/lab/nav.git", "https://gitlab.com/lab/nav.git"),
        ([], "https://github.com/lab/nav.git", "https://github.com/lab/nav.git"),
        ([], "git@example.org:lab/nav.git", "git@example.org:lab/nav.git"),
        (["--ssh"], "git://bitbucket.org/lab/nav", "https://bitbucket.org/lab/nav"),
        (["--ssh"], "git@github.com:lab/nav.git", "git@github.com:lab/nav.git"),
    ],
)
def test_old_addresses(tmp_path: Path, words: list[str], address: str, taken: str) -> None:
    home = tmp_path / "home"
    home.mkdir()
    programs = tmp_path / "bin"
    programs.mkdir()
    for name, text in STAND_INS.items():
        (programs / name).write_text(f"#!/bin/bash\n{text}\n")
        (programs / name).chmod(0o755)
    (tmp_path / "share").mkdir()
    (tmp_path / "share/git-hosts.txt").write_text("github.com\ngitlab.com\nbitbucket.org\n")
    script = tmp_path / "script"
    text = SCRIPT.read_text().replace("/etc/", f"{tmp_path}/")
    script.write_text(text.replace("/usr/local/share/roslab", f"{tmp_path}/share"))
    environment = {
        "PATH": f"{programs}:{os.environ['PATH']}",
        "NB_USER": "jovyan",
        "NB_UID": str(os.getuid()),
        "GROUP": str(os.getgid()),
        "HOME_OF_USER": str(home),
    }
    subprocess.run(["bash", script, *words], env=environment, check=True, capture_output=True)
    assert (home / ".local/share").is_dir()
    assert (home / ".cache").is_dir()
    assert f"source {tmp_path}/share/environment.bash;" in (tmp_path / "bash.bashrc").read_text()
    for command in (["init", "--quiet", "."], ["remote", "add", "origin", address]):
        subprocess.run(["git", *command], cwd=home, check=True)
    found = subprocess.run(
        ["git", "remote", "get-url", "origin"],
        cwd=home,
        env={**environment, "GIT_CONFIG_GLOBAL": f"{tmp_path}/gitconfig", "GIT_CONFIG_NOSYSTEM": "1"},
        check=True,
        capture_output=True,
        text=True,
    )
    assert found.stdout.strip() == taken


def test_with_a_key_addresses_of_ssh_stay() -> None:
    assert " create-user --ssh" in dockerfile(make(secrets=("ssh",)))
    assert " create-user --ssh" not in dockerfile(make())
