"""What a page clones and installs editable stays as a folder; the scripts run with git, and pip or a stand-in of it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sysconfig
import venv
from pathlib import Path

import pytest

from roslab.lock.inventory import _lines, _python
from roslab.render import image_scripts

SCRIPTS = Path(image_scripts.__path__[0])
SETUP = "from setuptools import setup\nsetup(name='arm-lib', version='1.2', packages=['arm'])\n"
FILES = {"setup.py": SETUP, "arm/__init__.py": "", "assets/arm.urdf": "<robot/>", "configs/__init__.py": "A = 1\n"}
PROJECT = "[build-system]\nrequires = []\nbuild-backend = 'backend'\nbackend-path = ['.']\n"
BACKEND = """\
import os, zipfile

def build_editable(folder, *_):
    name = "arm_lib-1.2-py3-none-any.whl"
    record = "arm_lib-1.2.dist-info"
    with zipfile.ZipFile(os.path.join(folder, name), "w") as wheel:
        wheel.writestr("arm_lib.pth", os.getcwd())
        wheel.writestr(record + "/METADATA", "Metadata-Version: 2.1\\nName: arm-lib\\nVersion: 1.2\\n")
        wheel.writestr(record + "/WHEEL", "Wheel-Version: 1.0\\nRoot-Is-Purelib: true\\nTag: py3-none-any\\n")
        wheel.writestr(record + "/RECORD", "")
    return name
"""
"""What builds the package, as no other package may be there."""
AUTHOR = {f"GIT_{who}_{what}": "a@example.org" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}
STAND_IN = """#!/bin/bash
# A stand-in of Python with pip: it notes each call, and refuses to install what is editable if that is said
case "$*" in
  "-c "*) echo {folder}/site-packages ;;
  "-m pip list"*) ;;
  *) words="$*"; echo "${{words#-m pip install }}" >>{folder}/calls; {refused} ;;
esac
"""


def _git(folder: Path, *words: str) -> str:
    done = subprocess.run(
        ["git", "-C", str(folder), *words], env={**os.environ, **AUTHOR}, capture_output=True, text=True, check=True
    )
    return done.stdout.strip()


def _repository(tmp_path: Path, files: dict[str, str], name: str = "arm.git") -> tuple[str, list[str]]:
    """Return the URL of a repository with two commits, of which the first is tagged, and the commits."""
    folder = tmp_path / "host" / name
    folder.mkdir(parents=True)
    _git(folder, "init", "--quiet")
    commits = []
    for text in ("first", "second"):
        for file, content in {**files, "notes.txt": text}.items():
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).write_text(content)
        _git(folder, "add", "--all")
        _git(folder, "commit", "--quiet", "--message", text)
        commits.append(_git(folder, "rev-parse", "HEAD"))
    _git(folder, "tag", "v1", commits[0])
    return f"git+file://localhost{folder}", commits


def _install(tmp_path: Path, python: Path, *packages: str, options: tuple[str, ...] = ()) -> Path:
    """Run the script, and return the folder of the clones."""
    programs, share = tmp_path / "bin", tmp_path / "share"
    for folder in (programs, share):
        folder.mkdir(exist_ok=True)
    for name in ("ask-pip-again", "clone-editable", "install-optional-pip"):
        text = (SCRIPTS / f"{name}.sh").read_text().replace("/opt/cloned", f"{tmp_path}/src")
        (programs / name).write_text(text.replace("/usr/local/share/roslab", str(share)))
        (programs / name).chmod(0o755)
    (share / "left-out.txt").touch()
    subprocess.run(
        [str(programs / "install-optional-pip"), str(python), *options, "--", *packages],
        env={**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "TMPDIR": str(tmp_path)},
        capture_output=True,
        check=True,
    )
    return tmp_path / "src"


def _stand_in(tmp_path: Path, refused: str = "true") -> Path:
    python = tmp_path / "python3"
    python.write_text(STAND_IN.format(folder=tmp_path, refused=refused))
    python.chmod(0o755)
    return python


def _calls(tmp_path: Path) -> list[str]:
    return (tmp_path / "calls").read_text().replace(str(tmp_path), "").splitlines()


@pytest.mark.parametrize("beside", ["", "--no-build-isolation="])
def test_a_clone_stays_with_all_its_files_and_its_commit(tmp_path: Path, beside: str) -> None:
    url, commits = _repository(tmp_path, FILES)
    src = _install(tmp_path, _stand_in(tmp_path), "numpy", f"{beside}--editable={url}@v1")
    option = "--no-build-isolation " if beside else ""
    assert _calls(tmp_path)[1:] == [f"{option}--editable /src/arm"]
    assert {str(file.relative_to(src)) for file in src.rglob("*") if file.is_file()} == {
        f"arm/{name}" for name in (*FILES, "notes.txt")
    }, "git keeps times, so that its part is not left"
    assert (src / "arm/notes.txt").read_text() == "first"
    address = url.removeprefix("git+")
    assert (tmp_path / "share/clones").read_text() == f"{src}/arm\t{address}\t{commits[0]}\t\n"


def test_a_locked_commit_and_two_folders_of_one_clone(tmp_path: Path) -> None:
    url, commits = _repository(tmp_path, {"a/setup.py": SETUP, "b/pyproject.toml": ""})
    lines = [f"--editable={url}@{commits[0]}#subdirectory={folder}" for folder in "ab"]
    src = _install(tmp_path, _stand_in(tmp_path), *lines)
    assert _calls(tmp_path) == ["--editable /src/arm/a", "--editable /src/arm/b"]
    notes = [line.split("\t")[2:] for line in (tmp_path / "share/clones").read_text().splitlines()]
    assert notes == [[commits[0], "a"], [commits[0], "b"]]
    assert not (src / "arm/.git").exists()


@pytest.mark.parametrize(
    ("files", "tried"),
    [
        (FILES, ["--editable /src/arm", "--no-build-isolation --editable /src/arm"]),
        ({"pyproject.toml": "[build-system]\nrequires = ['meson-python']\nbuild-backend = 'mesonpy'\n"}, []),
        ({"README.md": ""}, []),
    ],
)
def test_what_cannot_be_installed_editable_is_installed_from_git(
    tmp_path: Path, files: dict[str, str], tried: list[str]
) -> None:
    url, _ = _repository(tmp_path, files)
    src = _install(tmp_path, _stand_in(tmp_path, '[[ "$*" != *--editable* ]]'), f"--editable={url}")
    assert _calls(tmp_path) == [*tried, url.replace(str(tmp_path), "")]
    assert not src.exists()
    assert not (tmp_path / "share/clones").exists()
    assert not (tmp_path / "share/left-out.txt").read_text()


def test_what_cannot_be_cloned_is_left_to_pip_and_another_clone_keeps_its_name(tmp_path: Path) -> None:
    url, _ = _repository(tmp_path, FILES)
    other, _ = _repository(tmp_path, FILES, "fork/arm.git")
    gone = f"git+file://localhost{tmp_path}/gone.git"
    src = _install(tmp_path, _stand_in(tmp_path), *(f"--editable={each}" for each in (gone, url, other, f"{gone}@v2")))
    asked = [each.replace(str(tmp_path), "") for each in (gone, other, f"{gone}@v2")]
    assert _calls(tmp_path) == [asked[0], "--editable /src/arm", *asked[1:]]
    assert [folder.name for folder in src.iterdir()] == ["arm"]


@pytest.mark.parametrize("old_pip", [False, True])
def test_pip_uses_the_clone_and_the_lock_has_its_commit(tmp_path: Path, old_pip: bool) -> None:
    files = {**FILES, "setup.py": "", "pyproject.toml": PROJECT, "backend.py": BACKEND}
    url, commits = _repository(tmp_path, files)
    venv.create(tmp_path / "venv", symlinks=True)
    python = tmp_path / "venv/bin/python"
    own = Path(sysconfig.get_path("purelib", vars={"base": f"{tmp_path}/venv"}))
    (own / "with-pip.pth").write_text(sysconfig.get_path("purelib"))
    src = _install(tmp_path, python, f"--editable={url}", options=("--no-index", "--no-build-isolation"))
    assert not [*src.rglob("__pycache__"), *src.rglob(".git")]
    code = "import arm, configs, os; print(os.listdir(os.path.join(os.path.dirname(arm.__file__), '../assets')))"
    found = subprocess.run([str(python), "-c", code], cwd="/", capture_output=True, text=True, check=False)
    assert found.stdout == "['arm.urdf']\n", found.stderr
    (installed,) = own.glob("arm_lib-*")
    if old_pip:  # it leaves a link alone, and its record beside the sources
        (src / "arm/arm_lib.egg-info").mkdir()
        (installed / "METADATA").rename(src / "arm/arm_lib.egg-info/PKG-INFO")
        shutil.rmtree(installed)
    script = (SCRIPTS.parents[1] / "lock/inventory.sh").read_text()
    told = subprocess.run(
        ["/bin/sh", "-c", script.replace("/usr/local/share/roslab", f"{tmp_path}/share")],
        env={"PATH": f"{tmp_path}/venv/bin:{os.environ['PATH']}", "HOME": str(tmp_path)},
        capture_output=True,
        text=True,
        check=True,
    )
    packages = {each.package.name: each.package for each in _python(_lines(told.stdout)) if each.environment == "image"}
    assert packages["arm-lib"].url == f"{url}@{commits[1]}"
    assert packages["arm-lib"].version == "1.2"


@pytest.mark.parametrize(
    ("folder", "url"),
    [
        ("/opt/cloned/arm/python", "git+https://github.com/lab/arm.git@1234#subdirectory=python"),
        ("/opt/cloned/arm/python/src", "git+https://github.com/lab/arm.git@1234#subdirectory=python"),
        ("/opt/cloned/arms", ""),
        ("/home/jovyan/demo", ""),
    ],
)
def test_a_folder_below_a_clone_is_of_its_commit(folder: str, url: str) -> None:
    clone = "clone\t/opt/cloned/arm/python\thttps://github.com/lab/arm.git\t1234\tpython\n"
    record = f'python\timage\tarm\t1.0\tpip\t{{"dir_info": {{"editable": true}}, "url": "file://{folder}"}}\n'
    assert [each.package.url for each in _python(_lines(record + clone))] == ([url] if url else [])


def test_a_folder_of_a_repository_that_pip_installed_itself_is_known_too() -> None:
    direct = '{"subdirectory": "python", "url": "https://a.org/b", "vcs_info": {"vcs": "git", "commit_id": "12"}}'
    (found,) = _python(_lines(f"python\timage\tarm\t1.0\tpip\t{direct}\n"))
    assert found.package.url == "git+https://a.org/b@12#subdirectory=python"
