"""The scripts that give pip an index of a day: run as a build runs them, against an index of this test."""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import tarfile
import threading
import zipfile
from collections.abc import Iterator
from functools import cache
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pip
import pytest

from roslab.evidence.prose.python_steps import MAY_CALL_PIP
from roslab.knowledge.build_limits import build_limits
from roslab.knowledge.build_programs import build_programs

SCRIPTS = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts"
DAY = "2021-01-10"
OLD, NEW = "2020-06-01", "2022-06-01"
OWN = f"cp{sys.version_info.major}{sys.version_info.minor}"
EVERY = "py3-none-any"
BINARY = f"{OWN}-{OWN}-linux_x86_64.manylinux2014_x86_64.manylinux2014_aarch64"
FILES = {
    "pip": {f"pip-20.0-{EVERY}.whl": OLD},
    "plain": {f"plain-1.0-{EVERY}.whl": OLD, f"plain-2.0-{EVERY}.whl": NEW},
    "source": {"source-1.0.tar.gz": OLD, f"source-2.0-{EVERY}.whl": NEW},
    "compiled": {
        "compiled-1.0-cp27-cp27m-linux_x86_64.whl": OLD,
        f"compiled-2.0-{BINARY}.whl": NEW,
        f"compiled-3.0-{BINARY}.whl": "2023-06-01",
    },
    "ancient": {
        **{f"ancient-0.1.4{end}": "2017-11-01" for end in (f"-{EVERY}.whl", ".tar.gz")},
        "ancient-0.1.5.tar.gz": OLD,
        "ancient-0.2rc1.tar.gz": OLD,
    },
    "binary": {f"binary-1.0-{BINARY}.whl": OLD, "binary-1.0.tar.gz": OLD, "binary-1.1.tar.gz": OLD},
    "other": {**{f"other-1.0{end}": OLD for end in (f"-{EVERY}.whl", ".tar.gz")}, "other-2.0.tar.gz": OLD},
    "cython": {f"cython-{number}-{EVERY}.whl": OLD for number in ("0.29.36", "3.0")},
    "needs": {"needs-1.0.tar.gz": OLD},
    "swig": {f"swig-1.0-{EVERY}.whl": OLD},
    "wrapped": {"wrapped-1.0.tar.gz": OLD},
    "shared": {f"shared-{number}-{EVERY}.whl": OLD for number in ("1.0", "2.0")},
    "left": {f"left-1.0-{EVERY}.whl": OLD},
    "right": {f"right-1.0-{EVERY}.whl": OLD},
    "scripted": {"scripted-1.0.tar.gz": OLD},
    "gone": {f"gone-{number}-{EVERY}.whl": OLD for number in ("2.1.3", "2.1.25", "2.1.30", "2.2.0")},
    "front": {f"front-{number}-{EVERY}.whl": day for number, day in (("1.0", OLD), ("2.1", NEW), ("3.0", NEW))},
    "mended": {"mended-1.0.tar.gz": OLD, f"mended-2.0-{EVERY}.whl": NEW},
    "lacking": {f"lacking-0.9-{EVERY}.whl": OLD, "lacking-1.0.tar.gz": OLD},
    "calling": {f"calling-0.9-{EVERY}.whl": OLD, "calling-1.0.tar.gz": OLD},
    "withdrawn": {f"withdrawn-{number}-{EVERY}.whl": day for number, day in (("1.0", OLD), ("1.1", OLD), ("3.0", NEW))},
    "later": {f"later-1.0-{EVERY}.whl": NEW, f"later-2.0-{EVERY}.whl": "2023-06-01"},
}

REQUIRES = {
    "left": "Requires-Dist: shared==1.0\n",
    "right": "Requires-Dist: shared==2.0\n",
    "reaching": "Requires-Dist: plain>=1.5\nRequires-Dist: later>=23.1,<30\nProvides-Extra: more\n"
    "Requires-Dist: swig; extra == 'more'\nRequires-Dist: nowhere; python_version < '3'\n",
}


def wheel(file: str) -> bytes:
    """Return an empty wheel of that name."""
    name, version = file.split("-")[:2]
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as archive:
        folder = f"{name}-{version}.dist-info"
        for part, text in (
            ("METADATA", f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n{REQUIRES.get(name, '')}"),
            ("WHEEL", "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n"),
            ("RECORD", f"{folder}/METADATA,,\n{folder}/WHEEL,,\n{folder}/RECORD,,\n"),
        ):
            archive.writestr(zipfile.ZipInfo(f"{folder}/{part}"), text)
    return made.getvalue()


BACKEND = """\
import importlib.metadata, os, shutil

def build_wheel(folder, config_settings=None, metadata_directory=None):
    if importlib.metadata.version("cython") >= "3":
        print("Error compiling Cython file:")
        raise SystemExit(1)
    shutil.copy("made.whl", os.path.join(folder, "needs-1.0-py3-none-any.whl"))
    return "needs-1.0-py3-none-any.whl"
"""


WRAPPED = """\
import os, shutil

def build_wheel(folder, config_settings=None, metadata_directory=None):
    if not os.path.exists(os.environ["BROUGHT"] + "/swig-1.0.dist-info"):
        print("error: command 'swig' failed: No such file or directory")
        raise SystemExit(1)
    shutil.copy("made.whl", os.path.join(folder, "wrapped-1.0-py3-none-any.whl"))
    return "wrapped-1.0-py3-none-any.whl"
"""


SCRIPTED = """\
import shutil

def build_wheel(folder, config_settings=None, metadata_directory=None):
    import outside
    shutil.copy("made.whl", folder + "/scripted-1.0-py3-none-any.whl")
    return "scripted-1.0-py3-none-any.whl"
"""
REACHING = """\
import shutil

def build_wheel(folder, config_settings=None, metadata_directory=None):
    shutil.copy("made.whl", folder + "/reaching-1.0-py3-none-any.whl")
    return "reaching-1.0-py3-none-any.whl"

build_editable = build_wheel
"""
LACKING = """\
def get_requires_for_build_wheel(config_settings=None):
    open(PATH)
    return []
"""
CALLING = """\
import subprocess
def get_requires_for_build_wheel(config_settings=None):
    subprocess.run(["nowhere-there"])
    return []
"""
BACKENDS = {
    "mended": (LACKING.replace("PATH", "__file__ + '.RELEASE'"), ""),
    "lacking": (LACKING.replace("PATH", "'requirements.txt'"), ""),
    "calling": (CALLING, ""),
    "needs": (BACKEND, '"cython"'),
    "wrapped": (WRAPPED, ""),
    "scripted": (SCRIPTED, ""),
    "reaching": (REACHING, ""),
}


def source(file: str) -> bytes:
    """Return the source of a package: one that no Cython from 3.0 on compiles, that calls a program or imports one."""
    made = io.BytesIO()
    name = file.partition("-")[0]
    backend, needs = BACKENDS[name]
    own = f'[build-system]\nrequires = [{needs}]\nbuild-backend = "backend"\nbackend-path = ["."]\n'
    whole = wheel(f"{name}-1.0-{EVERY}.whl")
    parts = {"pyproject.toml": own.encode(), "backend.py": backend.encode(), "made.whl": whole}
    with tarfile.open(fileobj=made, mode="w:gz") as archive:
        for name, content in parts.items():
            member = tarfile.TarInfo(f"{file.removesuffix('.tar.gz')}/{name}")
            member.size = len(content)
            archive.addfile(member, io.BytesIO(content))
    return made.getvalue()


@cache
def content(file: str) -> bytes:
    """Return what the index has under a name."""
    return source(file) if file.startswith(tuple(BACKENDS)) and file.endswith(".tar.gz") else wheel(file)


class Index(BaseHTTPRequestHandler):
    """PEP 691's pages; below /old they do not tell the times of PEP 700."""

    def do_GET(self) -> None:
        name = self.path.strip("/").rpartition("/")[2]
        if name.endswith((".whl", ".tar.gz")):
            self.send_response(200)
            self.end_headers()
            self.wfile.write(content(name))
            return
        files = [
            {
                "filename": file,
                "url": f"/files/{file}",
                "hashes": {"sha256": hashlib.sha256(content(file)).hexdigest()},
                **({} if self.path.startswith("/old") else {"upload-time": f"{day}T08:00:00Z"}),
                **({"requires-python": "<3"} if file == "other-2.0.tar.gz" else {}),
                **({"yanked": "too old"} if file.startswith("withdrawn-1.") else {}),
            }
            for file, day in FILES.get(name, {}).items()
        ]
        self.send_response(200 if files else 404)
        self.send_header("Content-Type", "application/vnd.pypi.simple.v1+json")
        self.end_headers()
        self.wfile.write(json.dumps({"meta": {"api-version": "1.1"}, "name": name, "files": files}).encode())

    def log_message(self, *_: object) -> None:
        """Say nothing."""


@pytest.fixture
def index() -> Iterator[str]:
    """Serve the index."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), Index)
    threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True).start()
    yield f"http://127.0.0.1:{server.server_address[1]}"
    server.shutdown()
    server.server_close()


@pytest.fixture(scope="module")
def with_pip(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a Python with pip and nothing else, as an image has it: pip looks at all that is installed."""
    folder = tmp_path_factory.mktemp("python") / "python"
    own_python(folder)
    (folder / "bin/pip").write_text('#!/bin/sh\nexec "$(dirname "$0")/python3" -m pip "$@"\n')
    (folder / "bin/rustc").write_text("#!/bin/sh\nexit 1\n")  # of which pip tells the index, where it is installed
    for name in ("pip", "rustc"):
        (folder / "bin" / name).chmod(0o755)
    return folder


@pytest.fixture
def step(tmp_path: Path, index: str, with_pip: Path) -> Iterator[list[subprocess.Popen[str]]]:
    """Have the scripts under the names that they have in an image; what they start ends with the test."""
    if shutil.which("bash") is None:
        pytest.skip("a step of a build has bash")
    (tmp_path / "python").symlink_to(with_pip)
    for name in ("index-as-of", "ask-pip-again", "git-as-of", "shell-as-of"):
        text = (SCRIPTS / f"{name}.sh").read_text(encoding="utf-8")
        (tmp_path / name).write_text(text.replace("/dev/shm", str(tmp_path)))  # other tests have theirs
        (tmp_path / name).chmod(0o755)
    started: list[subprocess.Popen[str]] = []
    yield started
    for process in started:
        with contextlib.suppress(ProcessLookupError):  # a step that served nothing left nothing
            os.killpg(process.pid, signal.SIGKILL)


UNASKED = {"PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_NO_WARN_CONFLICTS": "0"}
"""Else each pip asks once more, for itself, which takes as long as what it was called for, and reads what is installed.

Of an option whose name begins with "no" a value that means no is the yes.
"""
OF_DAY = f'eval "$(index-as-of {DAY} --or-today)"'
TODAY = "source ask-pip-again"
either = pytest.mark.parametrize("start", [OF_DAY, TODAY])


def ran(
    step: list[subprocess.Popen[str]],
    folder: Path,
    index: str,
    commands: str,
    *,
    before: str = ":",
    start: str = OF_DAY,
) -> str:
    """Return what a step prints after its ``start``; ``before`` is run before that."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("PIP_", "GIT_"))}
    path = f"{folder}:{folder}/python/bin:{environment['PATH']}"
    with (folder / "said").open("w") as said:
        process = subprocess.Popen(
            ["bash", "-ec", f"{before}\n{start}\n{commands}"],
            env=environment | {"PATH": path, "PIP_INDEX_URL": index, "no_proxy": "127.0.0.1"} | UNASKED,
            stdout=subprocess.PIPE,
            stderr=said,
            text=True,
            start_new_session=True,
        )
    step.append(process)
    output, _ = process.communicate(timeout=100)
    assert process.returncode == 0, (folder / "said").read_text()
    return output


PAGES = """python3 - <<'E'
import os, re, urllib.request
for name in "plain source compiled later".split():
    asked = urllib.request.Request(os.environ["PIP_INDEX_URL"] + name + "/", headers={"User-Agent": "pip/AGENT"})
    text = urllib.request.urlopen(asked).read().decode()
    links = re.findall(r"<a ([^>]*)>([^<]*)</a>", text)
    print(name, *(file.split("-")[1].replace(".tar.gz", "") for more, file in links if "yanked" not in more))
E"""


@pytest.mark.parametrize("agent", ["23.2.1", "9.0.1"])
def test_what_came_later_is_hidden_unless_nothing_else_would_do(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, agent: str
) -> None:
    output = ran(step, tmp_path, f"{index}/simple/", PAGES.replace("AGENT", agent))
    assert output.splitlines() == ["plain 1.0", "source 1.0", "compiled 1.0 2.0", "later 1.0"]
    assert "compiled had nothing for this Python on 2021-01-10: compiled-2.0-" in (tmp_path / "said").read_text()


@pytest.mark.parametrize(("agent", "preferred"), [("23.2.1", "1"), ("9.0.1", "1"), ("23.2.1", "0")])
def test_where_wheels_are_preferred_an_old_one_of_plain_python_is_not_taken_before_newer_source(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, agent: str, preferred: str
) -> None:
    asked = PAGES.replace("AGENT", agent).replace("plain source compiled later", "ancient binary other")
    shown = asked.replace('file.split("-")[1].replace(".tar.gz", "")', 'file.partition("-")[2]')
    output = ran(step, tmp_path, f"{index}/simple/", shown, before=f"export PIP_PREFER_BINARY={preferred}")
    wheel_too = [f"0.1.4-{EVERY}.whl"] if preferred == "0" else []
    assert output.splitlines() == [
        " ".join(("ancient", *wheel_too, "0.1.4.tar.gz", "0.1.5.tar.gz", "0.2rc1.tar.gz")),
        f"binary 1.0-{BINARY}.whl 1.0.tar.gz 1.1.tar.gz",
        f"other 1.0-{EVERY}.whl 1.0.tar.gz 2.0.tar.gz",
    ]


def test_what_was_taken_back_since_is_there_where_the_day_had_nothing_else(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    output = ran(step, tmp_path, f"{index}/simple/", PAGES.replace("AGENT", "23.2.1").replace("plain", "withdrawn", 1))
    assert output.splitlines()[0] == "withdrawn 1.0 1.1"


def test_a_later_version_is_there_for_its_exact_number(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    output = ran(step, tmp_path, f"{index}/simple/", 'curl --silent --user-agent pip/23.0 "${PIP_INDEX_URL}plain/"')
    assert 'data-yanked="uploaded after 2021-01-10">plain-2.0' in output


@pytest.mark.parametrize(("asked", "got"), [("plain", "1.0"), ("'plain>=1.5'", "2.0"), ("plain==2.0", "2.0")])
def test_a_lower_bound_that_is_newer_than_the_day_gets_newer_versions(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, asked: str, got: str
) -> None:
    install = f"python3 -m pip install --quiet --no-cache-dir --target {tmp_path}/got {asked}"
    output = ran(step, tmp_path, f"{index}/simple/", f"{install}\nls {tmp_path}/got")
    assert f"plain-{got}.dist-info" in output
    assert ("no version of plain" in (tmp_path / "said").read_text()) == (">" in asked)


@either
@pytest.mark.parametrize(
    ("listed", "got"),
    [("gone==2.1.21", "2.1.25"), ("gone == 2.1.21 ; python_version > '3'", "2.1.25"), ("gone==2.1.30", "2.1.30")],
)
def test_an_exact_version_that_is_gone_becomes_the_next_of_its_minor_one(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, *, start: str, listed: str, got: str
) -> None:
    (tmp_path / "list.txt").write_text(f"plain\n{listed}\n")
    install = f"python3 -m pip install --quiet --no-cache-dir --target {tmp_path}/got"
    calls = (f"--requirement {tmp_path}/list.txt", f'plain "{listed}"')
    commands = "\n".join(f"{install} {call}\nls {tmp_path}/got\nrm -r {tmp_path}/got" for call in calls)
    output = ran(step, tmp_path, f"{index}/simple/", commands, start=start).split()
    assert output.count(f"gone-{got}.dist-info") == len(calls)
    told = (tmp_path / "said").read_text().count("the index no longer has gone 2.1.21: 2.1.25 is taken")
    assert told == (0 if got in listed else len(calls))


def test_a_version_that_is_gone_is_replaced_by_none_of_another_minor_one(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    install = f"python3 -m pip install --quiet --no-cache-dir --target {tmp_path}/got gone==2.0.1"
    assert ran(step, tmp_path, f"{index}/simple/", f"{install} || echo failed").strip() == "failed"


@either
@pytest.mark.parametrize("known", [True, False])
def test_what_a_new_cython_does_not_compile_gets_an_older_one(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, start: str, *, known: bool
) -> None:
    table, script = tmp_path / "build-limits.txt", tmp_path / "ask-pip-again"
    table.write_text(build_limits() + "\n" if known else "")
    script.write_text(script.read_text().replace("/usr/local/share/roslab/build-limits.txt", str(table)))
    install = f"python3 -m pip install --target {tmp_path}/made --quiet --no-cache-dir needs || echo failed"
    output = ran(step, tmp_path, f"{index}/simple/", install, start=start)
    said = (tmp_path / "said").read_text()
    assert (tmp_path / "made/needs-1.0.dist-info").exists() is known
    assert ("failed" in output.split()) is not known
    assert said.count("does not suit cython 3 and newer: an older one is taken") == known
    assert ("Error compiling Cython file:" in said) is not known  # what stops the build is seen


def test_what_is_built_beside_a_new_cython_gets_an_older_one_there(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    table, script = tmp_path / "build-limits.txt", tmp_path / "ask-pip-again"
    table.write_text(build_limits() + "\n")
    script.write_text(script.read_text().replace("/usr/local/share/roslab/build-limits.txt", str(table)))
    first, packages = own_python(tmp_path / "own")
    install = f"""{first}
        python3 -m pip install --quiet --no-cache-dir cython
        python3 -m pip install --quiet --no-cache-dir --no-build-isolation needs
        ls {packages}"""
    installed = ran(step, tmp_path, f"{index}/simple/", install, start=TODAY).split()
    assert {"needs-1.0.dist-info", "cython-0.29.36.dist-info"} <= set(installed)
    assert "roslab: it is built beside what is installed: pip installs cython<3" in (tmp_path / "said").read_text()


@either
def test_a_program_that_a_build_lacks_comes_from_pip(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, start: str
) -> None:
    table, script = tmp_path / "build-programs.txt", tmp_path / "ask-pip-again"
    table.write_text(build_programs() + "\n")
    script.write_text(script.read_text().replace("/usr/local/share/roslab/build-programs.txt", str(table)))
    before = f"export PIP_TARGET={tmp_path}/made BROUGHT={tmp_path}/made"
    install = "python3 -m pip install --quiet --no-cache-dir wrapped || echo failed"
    output = ran(step, tmp_path, f"{index}/simple/", install, before=before, start=start)
    said = (tmp_path / "said").read_text()
    assert "failed" not in output.split(), said
    assert (tmp_path / "made/wrapped-1.0.dist-info").exists()
    assert said.count("lacks a program or module: pip installs swig") == 1


def own_python(folder: Path) -> tuple[str, Path]:
    """Make a virtual environment with this one's pip; return the line that puts it first, and its packages' folder."""
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", folder], check=True)
    packages = next(folder.glob("lib/python*/site-packages"))
    there = Path(pip.__file__).parent.parent
    for each in (*there.glob("pip"), *there.glob("pip-*.dist-info")):
        (packages / each.name).symlink_to(each)
    for name in ("setuptools", "wheel"):  # which a step before installs in an image
        (packages / f"{name}-60.0.dist-info").mkdir()
        (packages / f"{name}-60.0.dist-info/METADATA").write_text(
            f"Metadata-Version: 2.1\nName: {name}\nVersion: 60.0\n"
        )
    return f"export PATH={folder}/bin:$PATH", packages


@pytest.mark.parametrize("there", [True, False])
def test_what_a_setup_script_imports_is_what_is_installed(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, *, there: bool
) -> None:
    first, packages = own_python(tmp_path / "own")
    (packages / ("outside.py" if there else "other.py")).touch()
    install = f"{first}\npython3 -m pip install --quiet --no-cache-dir scripted || echo failed"
    output = ran(step, tmp_path, f"{index}/simple/", install, start=TODAY)
    assert ("failed" not in output.split()) is there
    assert (packages / "scripted-1.0.dist-info").exists() is there
    assert (tmp_path / "said").read_text().count("imports outside and does not ask for it") == there


NEW_PIP = """\
import os, pathlib, sys
older = pathlib.Path(__file__).with_name("older")
if any(each.startswith("pip<") for each in sys.argv):
    older.write_text(sys.argv[-1])
elif not older.exists():
    said = "SAID"
    lost = "ERROR: No matching distribution found for a"
    pathlib.Path(os.environ["PIP_LOG"]).write_text(f"2026-11-27T10:00:00,000 {said}\\n{lost}")
    sys.exit(1)
"""
REFUSED = "Please use pip<24.1 if you need to use this version."
NO_EDITABLE = (
    "ERROR: Project file:///home/r uses a build backend that is missing the 'build_editable' hook, so it cannot be"
)


@pytest.mark.parametrize(
    ("said", "older"),
    [
        (REFUSED, "pip<24.1"),
        (REFUSED.replace("pip<24.1", "another pip"), ""),
        (NO_EDITABLE, "pip<25.3"),
        (NO_EDITABLE.replace("build_editable", "build_wheel"), ""),
    ],
)
def test_a_package_that_a_new_pip_refuses_gets_an_older_pip(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, said: str, older: str
) -> None:
    """With the words of pip 24.2 (gym 0.18.0) and 25.3 (setuptools 52), both of which were tried by hand."""
    first, packages = own_python(tmp_path / "own")
    (packages / "pip").unlink()
    (packages / "pip").mkdir()
    (packages / "pip/__main__.py").write_text(NEW_PIP.replace("SAID", said))
    install = f"{first}\npython3 -m pip install a || echo failed"
    output = ran(step, tmp_path, f"{index}/simple/", install, start=TODAY)
    assert ("failed" in output.split()) == (not older)
    got = packages / "pip/older"
    assert (got.read_text() if got.exists() else "") == older


def test_what_another_installer_put_there_is_covered(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    """As in an image of Ubuntu, where apt's packages lie behind those of pip."""
    first, packages = own_python(tmp_path / "own")
    behind = tmp_path / "own/behind"
    behind.mkdir()
    (packages / "behind.pth").write_text(f"{behind}\n")
    (behind / "shared-0.5.egg-info").write_text("Metadata-Version: 1.1\nName: shared\nVersion: 0.5\n")
    install = f"{first}\npython3 -m pip install --quiet --no-cache-dir left"
    ran(step, tmp_path, f"{index}/simple/", install, start=TODAY)
    assert (packages / "shared-1.0.dist-info").exists()
    assert (packages / "left-1.0.dist-info").exists()
    assert "pip cannot remove shared of another installer: it stays, and 1.0" in (tmp_path / "said").read_text()


@pytest.mark.parametrize(
    ("asked", "start", "got"),
    [
        ("mended", OF_DAY, "mended-2.0"),
        ("mended==1.0", OF_DAY, ""),
        ("lacking", OF_DAY, "lacking-0.9"),
        ("lacking", TODAY, "lacking-0.9"),
        ("calling", TODAY, ""),
    ],
)
def test_a_release_whose_archive_lacks_what_builds_it_is_passed_by(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, *, asked: str, start: str, got: str
) -> None:
    target = tmp_path / "got"
    target.mkdir()
    install = f"python3 -m pip install --no-cache-dir --target {target} {asked} || echo failed"
    output = ran(step, tmp_path, f"{index}/simple/", install, start=start)
    assert ("failed" in output.split()) == (not got)
    assert [each.name for each in target.glob("*.dist-info")] == ([f"{got}.dist-info"] if got else [])
    assert ("lacks what builds it" in (tmp_path / "said").read_text()) == bool(got)


@either
def test_of_requirements_that_contradict_each_other_the_first_decides(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, start: str
) -> None:
    install = f"python3 -m pip install --target {tmp_path}/made --quiet left right"
    ran(step, tmp_path, f"{index}/simple/", install, start=start)
    assert sorted(each.name for each in (tmp_path / "made").glob("*.dist-info")) == [
        "left-1.0.dist-info",
        "right-1.0.dist-info",
        "shared-1.0.dist-info",
    ]
    said = (tmp_path / "said").read_text()
    assert "roslab: Cannot install left==1.0 and right==1.0 because these package versions have conflicting" in said
    assert "the first requirement that names a package decides" in said


def test_requirements_that_contradict_each_other_and_cannot_be_had_fail(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    install = (
        f"python3 -m pip install --target {tmp_path}/made --quiet --no-cache-dir left right nowhere || echo failed"
    )
    assert ran(step, tmp_path, f"{index}/simple/", install).split()[-1] == "failed"


@pytest.mark.parametrize(("companion", "kept"), [("compiled", "1.0 2.1"), ("plain", "1.0")])
def test_what_is_released_together_is_of_one_time(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, companion: str, kept: str
) -> None:
    table = tmp_path / "released-together.txt"
    table.write_text(f"front {companion}\n")
    script = tmp_path / "index-as-of"
    script.write_text(script.read_text().replace("/usr/local/share/roslab/released-together.txt", str(table)))
    pages = PAGES.replace("AGENT", "23.2.1").replace("plain source compiled later", "front")
    assert ran(step, tmp_path, f"{index}/simple/", pages).strip() == f"front {kept}"


@pytest.mark.parametrize("asked", ["plain==3", "'plain<1'", "'plain>=1.5,<2'", "nowhere"])
def test_what_no_day_has_fails_as_before(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, asked: str
) -> None:
    install = f"python3 -m pip install --quiet --no-cache-dir --target {tmp_path}/got {asked}"
    assert ran(step, tmp_path, f"{index}/simple/", f"{install} || echo failed").strip() == "failed"
    assert (tmp_path / "said").read_text().count("No matching distribution found for") == 2


def test_a_lower_bound_that_other_pythons_have_fails_as_before(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    install = f"python3 -m pip install --quiet --no-cache-dir --target {tmp_path}/got 'other>=1.5' || echo failed"
    assert ran(step, tmp_path, f"{index}/simple/", install, start=TODAY).strip() == "failed"


@either
@pytest.mark.parametrize(
    "listed", ["plain>=23.1", "plain [more] >= 23.1  # as numpy", "plain>2.1,<30; python_version>'3'"]
)
def test_a_lower_bound_that_no_release_reaches_is_left_out(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, *, start: str, listed: str
) -> None:
    (tmp_path / "list.txt").write_text(f"left\n{listed}\n")
    install = f"python3 -m pip install --quiet --no-cache-dir --target {tmp_path}/got"
    calls = (f"--requirement {tmp_path}/list.txt", f'left "{listed.partition("#")[0].strip()}"')
    commands = "\n".join(f"{install} {call}\nls {tmp_path}/got\nrm -r {tmp_path}/got" for call in calls)
    output = ran(step, tmp_path, f"{index}/simple/", commands, start=start).split()
    assert output.count("plain-2.0.dist-info") == output.count("left-1.0.dist-info") == len(calls)
    assert (tmp_path / "said").read_text().count("no release of plain reaches 2") == len(calls)


@either
@pytest.mark.parametrize("more", [True, False])
def test_what_a_project_asks_for_is_a_list_where_no_release_reaches_one_of_its_bounds(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, *, start: str, more: bool
) -> None:
    first, packages = own_python(tmp_path / "own")
    with tarfile.open(fileobj=io.BytesIO(source("reaching-1.0.tar.gz"))) as archive:
        for member in archive.getmembers():
            (tmp_path / member.name).parent.mkdir(exist_ok=True)
            part = archive.extractfile(member)
            (tmp_path / member.name).write_bytes(part.read() if part else b"")
    project = f"{tmp_path}/reaching-1.0{'[more]' * more}"
    install = f"{first}\npython3 -m pip install --quiet --no-cache-dir --find-links {tmp_path} --editable '{project}'"
    ran(step, tmp_path, f"{index}/simple/", install, start=start)
    got = {each.name for each in packages.glob("*.dist-info")}
    assert {"reaching-1.0.dist-info", "plain-2.0.dist-info", "later-2.0.dist-info"} <= got
    assert ("swig-1.0.dist-info" in got) is more
    assert (
        "no release of later reaches 23.1, its newest is 2.0: the bound is left out" in (tmp_path / "said").read_text()
    )


def test_what_a_package_of_the_index_asks_for_is_not_changed(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    REQUIRES["right"], kept = "Requires-Dist: plain>=23.1\n", REQUIRES["right"]
    content.cache_clear()
    try:
        install = f"python3 -m pip install --quiet --no-cache-dir --target {tmp_path}/got right || echo failed"
        assert ran(step, tmp_path, f"{index}/simple/", install, start=TODAY).split()[-1] == "failed"
    finally:
        REQUIRES["right"] = kept
        content.cache_clear()


def test_an_index_that_tells_no_times_is_taken_as_it_is(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    assert ran(step, tmp_path, f"{index}/old/", 'echo "${PIP_INDEX_URL}"').strip() == f"{index}/old/"
    said = (tmp_path / "said").read_text()
    assert said == (
        "roslab: pip's packages are those of today and not of 2021-01-10: "
        "the index does not tell when it got its files\n"
    )


def test_a_clone_is_of_the_day_and_keeps_its_branch(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str
) -> None:
    source = tmp_path / "source"
    source.mkdir()
    identity = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    subprocess.run(["git", "init", "--quiet", "--initial-branch=main", source], check=True)
    for day in (OLD, NEW):
        when = {"GIT_AUTHOR_DATE": f"{day}T12:00:00Z", "GIT_COMMITTER_DATE": f"{day}T12:00:00Z"}
        command = ["git", "-C", str(source), *identity, "commit", "--quiet", "--allow-empty", "--message", day]
        subprocess.run(command, check=True, env={**os.environ, **when})
    commands = f"git clone --quiet {source} {tmp_path}/copy; git -C {tmp_path}/copy log -1 --format='%s %D'"
    output = ran(step, tmp_path, f"{index}/old/", commands)
    assert output.startswith(f"{OLD} HEAD -> main")


def test_the_python_that_has_pip_is_asked(tmp_path: Path) -> None:
    """conda's has it, and the system's python3, which stands before it, has none; none at all is told."""
    for name, code in (("python3", 1), ("python2", 1)):
        (tmp_path / name).write_text(f"#!/bin/sh\nexit {code}\n")
        (tmp_path / name).chmod(0o755)
    tools = {tool: shutil.which(tool) for tool in ("env", "bash", "mktemp", "seq", "sleep", "cat", "rm")}
    for tool, path in tools.items():
        (tmp_path / tool).symlink_to(path or tool)
    environment = {"PATH": str(tmp_path), "HOME": str(tmp_path)}
    command = ["/bin/bash", str(SCRIPTS / "index-as-of.sh"), DAY, "--or-today"]
    none = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert (none.returncode, none.stdout) == (0, "")
    assert "no Python with pip" in none.stderr


@pytest.mark.parametrize(
    ("run", "got"),
    [
        ("pip download --quiet --no-deps --dest . plain && ls plain*", "plain-1.0"),
        ("PIP_NO_DEPS=1 python -m pip download --quiet --dest . 'plain>1' 2>/dev/null || echo none", "none"),
        ('echo "${PIP_INDEX_URL} ${PIP_PREFER_BINARY:-}"', "{index}"),
        ('echo pip "${PIP_PREFER_BINARY:-}"', "pip 1"),
        ('echo pip "${PIP_INDEX_URL%:*}"', "pip http://127.0.0.1"),
        ("[ -n \"${BASH_VERSION:-}\" ] || echo 'the usual shell'", "the usual shell"),
    ],
)
def test_an_authors_step_that_calls_pip_has_the_index_of_the_day(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, run: str, got: str
) -> None:
    said = ran(step, tmp_path, index, f"cd {tmp_path}\nexec shell-as-of {DAY} {shlex.quote(run)}", start=":")
    assert said.strip().startswith(got.format(index=index))


@pytest.mark.parametrize(
    "asked",
    [
        ("git clone --quiet {origin} got && git -C got log --format=%s", "of the day"),
        ("git clone --quiet --depth 1 file://{origin} got && git -C got log -1 --format=%s", "of the day"),
        ("git clone --quiet --branch later {origin} got && git -C got log -1 --format=%s", "of the day"),
        ("git clone --quiet {origin} got && git -C got checkout --quiet v2 && git -C got log -1 --format=%s", "newest"),
        ("echo 'no clone' ${{GIT_AS_OF:-}}", "no clone"),
        ("git --version >/dev/null; exit 7", "failed with 7"),
    ],
)
@pytest.mark.parametrize("pip", [True, False])
def test_an_authors_step_that_clones_has_the_heads_of_the_day(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, asked: tuple[str, str], pip: bool
) -> None:
    origin = tmp_path / "origin"
    run, got = asked
    made = f"git init --quiet {origin} && cd {origin} && git config user.name a && git config user.email a@b.c"
    for day, what in (("2020-01-02", "of the day"), ("2026-01-02", "newest")):
        made += f" && GIT_COMMITTER_DATE={day}T12:00:00Z git commit --quiet --allow-empty --message '{what}'"
    made += " && git branch later && git tag v2"
    if not pip:
        (tmp_path / "index-as-of").unlink()
    run = run.format(origin=origin)
    call = f"shell-as-of {DAY} {shlex.quote(run)} || echo failed with $?"
    assert ran(step, tmp_path, index, f"cd {tmp_path} && {call}", before=f"({made})", start=":").strip() == got


@pytest.mark.parametrize(
    ("asked", "got"),
    [
        ("git clone --quiet --no-checkout {origin} got && git -C got checkout --quiet master --", "of the day"),
        ("git clone --quiet --branch master {origin} got", "of the day"),
        (
            "git clone --quiet --depth 1 --branch=master file://{origin} got && git -C got checkout -q master --",
            "of the day",
        ),
        ("git clone --quiet -bmaster {origin} got", "of the day"),
        ("git clone --quiet {origin} got && git -C got checkout --quiet origin/master", "of the day"),
        (
            "git init --quiet got && git -C got fetch -q {origin} master && git -C got checkout -q FETCH_HEAD",
            "of the day",
        ),
        (
            "git clone --quiet {origin} got && cd got && git fetch --quiet --prune && git checkout --quiet master",
            "of the day",
        ),
        ("git clone --quiet {origin} got && git -C got checkout --quiet main", "of the day"),
        ("git clone --quiet --branch masters {origin} got", "failed with 128"),
        (
            "mkdir -p main/a && ! git clone -q {origin} main && test ! -e master && git clone -q {origin} got",
            "of the day",
        ),
        ("git clone --quiet --branch master {origin}-gone got", "failed with 128"),
    ],
)
def test_a_branch_that_a_host_renamed_is_found_by_its_old_name(
    step: list[subprocess.Popen[str]], tmp_path: Path, index: str, asked: str, got: str
) -> None:
    origin = tmp_path / "origin"
    made = f"git init --quiet --initial-branch=main {origin} && cd {origin} && git config user.name a"
    made += " && git config user.email a@b.c"
    for day, what in (("2020-01-02", "of the day"), ("2026-01-02", "newest")):
        made += f" && GIT_COMMITTER_DATE={day}T12:00:00Z git commit --quiet --allow-empty --message '{what}'"
    call = f"{asked.format(origin=origin)} && git -C {tmp_path}/got log -1 --format=%s"
    run = f"shell-as-of {DAY} {shlex.quote(call)} 2>/dev/null || echo failed with $?"
    assert ran(step, tmp_path, index, f"cd {tmp_path} && {run}", before=f"({made})", start=":").strip() == got


def test_a_step_that_may_call_pip_is_known_alike_to_the_plan_and_to_the_shell() -> None:
    text = (SCRIPTS / "shell-as-of.sh").read_text(encoding="utf-8")
    assert f"grep --quiet --extended-regexp '{MAY_CALL_PIP.pattern}' " in text


def test_an_authors_step_that_fails_fails(step: list[subprocess.Popen[str]], tmp_path: Path, index: str) -> None:
    said = ran(step, tmp_path, index, f"shell-as-of {DAY} 'pip --version >/dev/null; exit 7' || echo $?", start=":")
    assert said.strip() == "7"
