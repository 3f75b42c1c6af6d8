"""The files that `create` writes, on the real engine: built, run, opened in JupyterLab, executed cell by cell."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from .laboratory import Laboratory

ROOT = Path(__file__).resolve().parent.parent.parent
NAME = "lab-run-script"
CONFIG = f"""\
format: 3
name: {NAME}
notebook: true
ports: [18711]
volume:
  - host_path: ./my data (1)
    container_path: /my data
    options: ro
"""
Run = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture(scope="module")
def repository(lab: Laboratory, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Return a repository whose image was built by its own docker_build.sh."""
    folder = tmp_path_factory.mktemp("run-script") / "robot"
    shutil.copytree(ROOT / "examples" / "python_filter", folder, ignore=shutil.ignore_patterns("__pycache__"))
    (folder / "my data (1)").mkdir()
    (folder / "my data (1)" / "track; $(id).txt").write_text("42\n")
    (folder / "roslab.yaml").write_text(CONFIG)
    (folder / ".dockerignore").write_text("*.txt\nsecret.key\n!.git\n")
    (folder / "secret.key").write_text("s3cret\n")
    (folder / ".git").mkdir()
    (folder / ".git" / "config").write_text("[http]\n\textraheader = AUTHORIZATION: basic s3cret\n")
    create = subprocess.run(
        [sys.executable, "-I", str(ROOT / "scripts"), "create", str(folder)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert create.returncode == 0, create.stderr
    build = subprocess.run(
        [folder / "docker_build.sh", "--progress", "plain"],
        env=dict(lab.environment),
        capture_output=True,
        text=True,
        check=False,
    )
    assert build.returncode == 0, build.stderr[-4000:]
    yield folder
    subprocess.run(
        ["docker", "image", "rm", "--force", NAME], env=dict(lab.environment), capture_output=True, check=False
    )


@pytest.fixture
def run(lab: Laboratory, repository: Path) -> Run:
    """Return a function that runs docker_run.sh with arguments; ``env`` is added to the environment."""

    def call(
        *arguments: str, env: dict[str, str] | None = None, text: str | None = None
    ) -> subprocess.CompletedProcess[str]:
        script = repository / "docker_run.sh"
        if text is not None:
            script = repository / "changed_run.sh"
            script.write_text(text)
        settings = {k: v for k, v in lab.environment.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY", "ROSLAB_IMAGE")}
        return subprocess.run(
            ["bash", script, *arguments],
            env={**settings, **(env or {})},
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            check=False,
            timeout=120,
        )

    return call


def test_a_command_replaces_the_default_one(run: Run) -> None:
    answer = run("bash", "-c", 'id -u; printf "<%s>\\n" "$@"; exit 7', "x", "a b", "$(id); rm -rf ~", "it's")
    assert answer.returncode == 7, answer.stderr
    assert answer.stdout == "1000\n<a b>\n<$(id); rm -rf ~>\n<it's>\n"


def test_the_program_of_the_readme_runs(run: Run) -> None:
    answer = run("python3", "demo.py")
    assert answer.returncode == 0, answer.stderr
    assert "filtered: 0.387" in answer.stdout


def test_another_reference_is_run(run: Run, lab: Laboratory) -> None:
    inspect = ["docker", "image", "inspect", "--format", "{{.Id}}", NAME]
    identity = subprocess.run(inspect, env=dict(lab.environment), capture_output=True, text=True, check=True).stdout
    assert run("pwd", env={"ROSLAB_IMAGE": identity.strip()}).stdout == f"/home/jovyan/{NAME}\n"


def test_the_volume_is_there_and_only_to_be_read(run: Run) -> None:
    answer = run("bash", "-c", 'cat "/my data/"*; touch "/my data/x"')
    assert answer.stdout == "42\n"
    assert "Read-only file system" in answer.stderr


def test_what_went_into_the_image(run: Run) -> None:
    """The author's lines hold, the requirements came back, the notebook is there, .git is not."""
    files = set(run("bash", "-c", "ls -A").stdout.split("\n"))
    assert {"requirements.txt", "README.ipynb", "roslab.yaml", "demo.py"} <= files
    assert not files & {
        ".git",
        "secret.key",
        "Dockerfile",
        "Dockerfile.dockerignore",
        "docker_run.sh",
        "docker_build.sh",
    }


def test_the_key_of_the_display_reaches_the_program_and_nobody_else(run: Run, repository: Path, tmp_path: Path) -> None:
    runtime = tmp_path / "runtime"
    runtime.mkdir()
    text = (repository / "docker_run.sh").read_text().replace("gui=no", "gui=yes")
    number = 30000 + os.getpid()
    folder = Path("/tmp/.X11-unix")
    folder.mkdir(exist_ok=True)
    (tmp_path / "Xauthority").write_bytes(b"")
    if shutil.which("xauth"):
        add = ["xauth", "-q", "-f", str(tmp_path / "Xauthority"), "add", f":{number}", ".", "0123456789abcdef" * 2]
        subprocess.run(add, check=True)
    script = (
        "import os, socket; s = socket.socket(socket.AF_UNIX); "
        "s.connect('/tmp/.X11-unix/X' + os.environ['DISPLAY'][1:]); "
        "print(len(open(os.environ['XAUTHORITY'], 'rb').read()), s.recv(9))"
    )
    path = folder / f"X{number}"
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(path))
        path.chmod(0o777)  # as an X server's is
        listener.listen()

        def answer_once() -> None:
            with listener.accept()[0] as connection:
                connection.sendall(b"connected")

        threading.Thread(target=answer_once, daemon=True).start()
        env = {"DISPLAY": f":{number}", "XDG_RUNTIME_DIR": str(runtime), "XAUTHORITY": str(tmp_path / "Xauthority")}
        answer = run("python3", "-c", script, env=env, text=text)
    path.unlink()
    assert answer.returncode == 0, answer.stderr
    length, said = answer.stdout.split()
    assert said == "b'connected'"
    assert int(length) > 0 or not shutil.which("xauth")
    assert list(runtime.iterdir()) == []


def test_the_socket_of_wayland_lies_in_a_folder_of_the_users_own(run: Run, repository: Path, tmp_path: Path) -> None:
    user = os.getuid()
    text = (repository / "docker_run.sh").read_text().replace("gui=no", "gui=yes")
    text = text.replace("image_user=1000", f"image_user={user}")
    with socket.socket(socket.AF_UNIX) as listener:
        path = Path(f"/tmp/lab-wayland-{os.getpid()}")
        listener.bind(str(path))
        answer = run(
            f"--option=--user={user}",
            *(
                "bash",
                "-c",
                'stat -c "%a %u" "$XDG_RUNTIME_DIR"; test -S "$XDG_RUNTIME_DIR/$WAYLAND_DISPLAY" && echo there',
            ),
            env={"WAYLAND_DISPLAY": str(path)},
            text=text,
        )
    path.unlink()
    assert answer.stdout == f"700 {user}\nthere\n", answer.stderr


def fetch(url: str) -> int:
    try:
        with urllib.request.urlopen(url, timeout=5) as answer:  # noqa: S310 - http to this machine
            return int(answer.status)
    except urllib.error.HTTPError as error:
        return error.code


@pytest.fixture
def jupyterlab(lab: Laboratory, repository: Path) -> Iterator[str]:
    """Return the address that `docker_run.sh --notebook` prints, once something answers there."""
    process = subprocess.Popen(
        [repository / "docker_run.sh", "--notebook"],
        env=dict(lab.environment),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    try:
        assert process.stdout is not None
        url = process.stdout.readline().removeprefix("JupyterLab: ").strip()
        for _ in range(120):
            try:
                fetch(url)
                break
            except OSError:
                time.sleep(0.5)
        yield url
    finally:
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)


def test_jupyterlab_answers_on_this_machine_only_and_with_its_token(jupyterlab: str) -> None:
    match = re.fullmatch(r"(http://127\.0\.0\.1:(\d+))/lab/tree/README\.ipynb\?token=([0-9a-f]{48})", jupyterlab)
    assert match, jupyterlab
    base, port, token = match.groups()
    assert fetch(jupyterlab) == 200
    assert fetch(f"{base}/api/contents/README.ipynb?token={token}") == 200
    assert fetch(f"{base}/api/contents/README.ipynb") == 403
    assert fetch(f"{base}/api/contents/README.ipynb?token=") == 403
    listening = subprocess.run(["ss", "-Hltn", f"sport = :{port}"], capture_output=True, text=True, check=True).stdout
    assert {line.split()[3] for line in listening.splitlines()} == {f"127.0.0.1:{port}"}


def test_the_notebook_runs_cell_by_cell(run: Run) -> None:
    script = "/opt/jupyter/bin/jupyter execute --output=/tmp/done.ipynb README.ipynb >&2 && cat /tmp/done.ipynb"
    answer = run("bash", "-c", script)
    assert answer.returncode == 0, answer.stderr
    cells = [cell for cell in json.loads(answer.stdout)["cells"] if cell["cell_type"] == "code"]
    assert len(cells) == 2
    for cell in cells:
        assert "filtered:" in "".join(text for output in cell["outputs"] for text in output["text"])


def test_a_port_is_open_on_this_machine_only(lab: Laboratory, repository: Path) -> None:
    process = subprocess.Popen(
        [repository / "docker_run.sh", "python3", "-m", "http.server", "18711"],
        env=dict(lab.environment),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        for _ in range(60):
            try:
                assert fetch("http://127.0.0.1:18711/README.md") == 200
                break
            except OSError:
                time.sleep(0.5)
        else:
            pytest.fail("nothing answers at 127.0.0.1:18711")
        listening = subprocess.run(["ss", "-Hltn", "sport = :18711"], capture_output=True, text=True, check=True).stdout
        assert {line.split()[3] for line in listening.splitlines()} == {"127.0.0.1:18711"}
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait(60)
