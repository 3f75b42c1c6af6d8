"""Programs with windows, for real, through each door and on a laptop; and launches whose nodes die.

The program draws an orange disc: what is kept of its screen must show it.
"""

from __future__ import annotations

import io
import json
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from subprocess import CompletedProcess

import pytest
from PIL import Image

from lab import doors
from lab.act import Result, run_workflow
from lab.home import CHECKOUT
from lab.kept_artifacts import artifacts
from lab.laboratory import Laboratory
from roslab.prove import display

Roslab = Callable[..., CompletedProcess[str]]
Build = Callable[..., CompletedProcess[str]]
OF_THE_TEST = "screenshot-linux-amd64-repository-test.png"
ORANGE = (255, 165, 0)
SOCKETS = Path("/tmp/.X11-unix")
WINDOW = {
    "Dockerfile": "FROM ubuntu:24.04\n"
    "RUN apt-get update && apt-get install -y --no-install-recommends python3-tk && rm -rf /var/lib/apt/lists/*\n"
    'COPY window.py /window.py\nUSER 1000\nCMD ["python3", "/window.py"]\n',
    "window.py": "import tkinter\n"
    "try:\n"
    "    root = tkinter.Tk()\n"
    "except tkinter.TclError as error:\n"
    "    raise SystemExit(error)\n"
    'root.geometry("640x480+100+80")\n'
    'canvas = tkinter.Canvas(root, width=640, height=480, background="white")\n'
    "canvas.pack()\n"
    'canvas.create_oval(120, 40, 520, 440, fill="orange")\n'
    'print("opened on", root.winfo_screen())\n'
    "root.mainloop()\n",
    "roslab.yaml": "format: 3\nkind: python\ndockerfile: Dockerfile\n",
}
PLAIN_WINDOW = {
    "Dockerfile": 'FROM ubuntu:24.04\nCOPY window.pl /window.pl\nUSER 1000\nCMD ["perl", "/window.pl"]\n',
    "window.pl": (Path(__file__).parent / "window.pl").read_text(),
    "roslab.yaml": "format: 3\nkind: cpp\ndockerfile: Dockerfile\ngui: true\n",
}
"""The same picture, for both platforms: to install Tk on an emulated machine takes longer than all of the rest."""
NAME = "screenshot-{}-default-command-starts.png"


OTHERS = 60.0
"""Seconds after which a proof's display is gone, whoever runs it."""


@pytest.fixture
def displays() -> Iterator[None]:
    """See that no X server and no socket of one is left behind."""
    before = x_servers()
    yield
    deadline = time.monotonic() + OTHERS
    while (left := x_servers() - before) and time.monotonic() < deadline:
        time.sleep(1)  # another proof on this machine has one for a while; one that was left behind stays
    assert not left


def x_servers() -> set[str]:
    sockets = {path.name for path in SOCKETS.iterdir()} if SOCKETS.is_dir() else set()
    for process in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # it ended meanwhile
            if (process / "comm").read_text() == "Xvfb\n" and (process / "cmdline").read_bytes():  # not a zombie's
                sockets.add(f"process {process.name}")
    return sockets


def x_keys() -> dict[str, str]:
    """Return the path of the key of each X server on this machine, by the name of its socket."""
    found = {}
    for process in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            words = (process / "cmdline").read_text().split("\0") if (process / "comm").read_text() == "Xvfb\n" else []
            if "-auth" in words:
                found[f"X{words[1].removeprefix(':')}"] = words[words.index("-auth") + 1]
    return found


def disc(data: bytes) -> int:
    """Return how many pixels of a picture are of the disc's colour; it is a PNG of the whole screen."""
    with Image.open(io.BytesIO(data)) as picture:
        assert (picture.format, picture.size) == ("PNG", (1920, 1080))
        colours = picture.convert("RGB").getcolors(1 << 24)
    return next((count for count, colour in colours or () if colour == ORANGE), 0)


def whole_disc(data: bytes) -> bool:
    return abs(disc(data) - 3.1416 * 200**2) < 3000


def named(kept: dict[str, bytes], *words: str) -> str:
    """Return the one artifact with a name of these words; a hash of branch and call and the attempt stand in it too."""
    first, *rest = map(re.escape, words)
    pattern = re.compile("-".join([first, "[0-9a-f]{8}", *rest, "1"]))
    (name,) = {path.partition("/")[0] for path in kept if pattern.fullmatch(path.partition("/")[0])}
    return name


def through(lab: Laboratory, caller: Path, name: str, place: Path, event: str = "push") -> Result:
    head = "stranger/robot" if event == "pull_request" else None
    payload = doors.payload(name, head=head) if head else doors.payload(name)
    secrets = {"REGISTRY_PASSWORD": ""} if head else {}
    return run_workflow(lab, caller, event, payload, env=doors.builder(lab), secrets=secrets, place=place)


@pytest.mark.parametrize("event", ["push", "pull_request"])
@pytest.mark.usefixtures("displays")
def test_through_the_action_on_every_platform(lab: Laboratory, tmp_path: Path, event: str) -> None:
    repository = lab.fresh_repository(f"{doors.OWNER}/window").partition("/")[2]
    caller = doors.through_action(tmp_path / "caller", {"registry": lab.registry}, PLAIN_WINDOW, base={})
    ran = through(lab, caller, repository.partition("/")[2], tmp_path / "place", event)
    assert ran.exit_code == 0, ran.log
    assert set(doors.tags(repository)) > {"main", "latest"} or event == "pull_request"
    kept = artifacts(tmp_path / "place")
    name = named(kept, f"screenshots-{repository.replace('/', '-')}", "all")
    pictures = {f"{name}/{NAME.format(platform)}" for platform in ("linux-amd64", "linux-arm64")}
    assert {path for path in kept if path.startswith("screenshots-")} == pictures
    assert [path for path in pictures if not whole_disc(kept[path])] == []
    for platform in ("amd64", "arm64"):
        line = (
            f"Screenshot on `linux/{platform}`: `{NAME.format(f'linux-{platform}')}`, among the artifacts of this run."
        )
        assert line in ran.summary
    assert "nothing was drawn" not in ran.summary


@pytest.mark.usefixtures("displays")
def test_through_the_workflow_beside_the_report(lab: Laboratory, tmp_path: Path) -> None:
    repository = lab.fresh_repository(f"{doors.OWNER}/window").partition("/")[2]
    caller = doors.through_workflow(tmp_path / "caller", {"registry": lab.registry}, PLAIN_WINDOW)
    ran = through(lab, caller, repository.partition("/")[2], tmp_path / "place")
    assert ran.exit_code == 0, ran.log
    kept = artifacts(tmp_path / "place")
    for platform in ("linux-amd64", "linux-arm64"):
        folder = named(kept, f"image-{repository.replace('/', '-')}", platform)
        assert whole_disc(kept[f"{folder}/{NAME.format(platform)}"])
        report = json.loads(kept[f"{folder}/report-{platform}.json"])
        assert report["proofs"][-1]["screenshot"] == NAME.format(platform)
        assert report["proofs"][-1]["screenshot_remark"] == ""
        assert f"`{NAME.format(platform)}`, among the artifacts of this run." in ran.summary


@pytest.fixture
def build(lab: Laboratory, roslab: Roslab, tmp_path: Path) -> Iterator[Build]:
    """Return a function that runs ``roslab build`` on the window's repository with a ``roslab.yaml`` of more lines."""
    folder = doors.write(tmp_path / "window", WINDOW)

    def run(*arguments: str | Path, more: str = "", env: dict[str, str] | None = None) -> CompletedProcess[str]:
        (folder / "roslab.yaml").write_text(WINDOW["roslab.yaml"] + more)
        settings = {**lab.environment, "XDG_CACHE_HOME": str(tmp_path / "cache"), **(env or {})}
        return roslab("build", folder, "--tag", "repro-lab", *arguments, env=settings, timeout=900)

    yield run
    lab_docker(lab)("image", "rm", "--force", "window:repro-lab")


@pytest.mark.usefixtures("displays", "x_server")
def test_on_a_laptop_it_lies_in_the_cache(build: Build, tmp_path: Path) -> None:
    answer = build()
    assert answer.returncode == 0, answer.stderr
    file = tmp_path / "cache" / "roslab" / "window" / NAME.format("linux-amd64")
    assert f"[linux/amd64] screenshot: {file}\n" in answer.stderr
    assert whole_disc(file.read_bytes())
    assert answer.stdout == "window:repro-lab\n"
    assert sorted(path.name for path in (tmp_path / "window").iterdir()) == sorted(WINDOW)


def test_without_a_display_the_same_program_dies(build: Build, tmp_path: Path) -> None:
    answer = build(more="gui: false\n")
    assert answer.returncode == 5
    assert "no display name and no $DISPLAY environment variable" in answer.stderr
    assert "screenshot" not in answer.stderr
    assert not (tmp_path / "cache").exists()


@pytest.mark.usefixtures("displays", "x_server")
def test_a_test_that_closes_its_window_and_the_users_own_display(build: Build, tmp_path: Path) -> None:
    """The last picture with something in it is kept; a display and a key of the user's are not passed on."""
    test = "test: timeout 4 python3 -u /window.py; test $? = 124\n"
    environment = {"DISPLAY": ":77", "XAUTHORITY": str(tmp_path / "nobody"), "WAYLAND_DISPLAY": "wayland-9"}
    answer = build("--screenshots", tmp_path / "pictures", more=test, env=environment)
    assert answer.returncode == 0, answer.stderr
    opened = re.findall(r"opened on (\S+)", answer.stderr)  # by the test, and by the command
    assert opened
    assert ":77.0" not in opened
    assert "passed in " in answer.stderr
    assert whole_disc((tmp_path / "pictures" / OF_THE_TEST).read_bytes())


@pytest.mark.usefixtures("displays", "x_server")
def test_who_has_no_key_draws_nothing_and_that_is_told(build: Build, tmp_path: Path) -> None:
    """The same socket without its key is refused; nor can the container write to either."""
    tries = "! XAUTHORITY=/dev/null python3 /window.py && ! touch $XAUTHORITY && ! rm -f /tmp/.X11-unix/X${DISPLAY#:}"
    test = f'test: "{tries} && test ! -e /dev/dri"\n'
    answer = build("--screenshots", tmp_path / "pictures", more=test + "gui: true\n")
    assert answer.returncode == 0, answer.stderr
    assert "couldn't connect to display" in answer.stderr
    file = tmp_path / "pictures" / OF_THE_TEST
    assert f"[linux/amd64] screenshot: {file}; nothing was drawn: it is wholly blank\n" in answer.stderr
    assert disc(file.read_bytes()) == 0


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL], ids=["ended", "killed"])
@pytest.mark.usefixtures("displays", "x_server")
def test_the_display_goes_away_with_the_program(lab: Laboratory, tmp_path: Path, number: int) -> None:
    folder = doors.write(tmp_path / "window", {**WINDOW, "roslab.yaml": WINDOW["roslab.yaml"] + "test: sleep 600\n"})
    command = [sys.executable, "-I", str(CHECKOUT / "scripts"), "build", str(folder), "--tag", "repro-lab-end"]
    settings = {**lab.environment, "XDG_CACHE_HOME": str(tmp_path), "TMPDIR": str(tmp_path)}

    def own(key: str) -> bool:
        return Path(key).is_relative_to(tmp_path)

    with subprocess.Popen(command, env=settings, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        assert next((line for line in process.stderr if "the repository's test:" in line), "")
        # Its own: another proof on this machine may have a display meanwhile
        assert within(30, lambda: any(own(key) for key in x_keys().values()))
        (name,) = (name for name, key in x_keys().items() if own(key))
        assert within(30, (SOCKETS / name).exists)
        process.send_signal(number)
        process.stderr.read()
    try:
        assert process.returncode == (143 if number == signal.SIGTERM else -number)
        assert within(10, lambda: not any(own(key) for key in x_keys().values()))
        assert within(10, lambda: not (SOCKETS / name).exists() or name in x_keys())
    finally:  # nobody can clean up who was killed: his container lives on
        docker = lab_docker(lab)
        candidate = f"window:roslab-candidate-{process.pid}-linux-amd64"
        for container in docker("ps", "--all", "--quiet", "--filter", f"ancestor={candidate}").split():
            docker("rm", "--force", container)
        docker("image", "rm", "--force", candidate)


def within(seconds: float, true: Callable[[], bool]) -> bool:
    deadline = time.monotonic() + seconds
    while not true() and time.monotonic() < deadline:
        time.sleep(0.1)
    return true()


def lab_docker(lab: Laboratory) -> Callable[..., str]:
    def run(*arguments: str) -> str:
        command = ["docker", *arguments]
        return subprocess.run(command, env=dict(lab.environment), capture_output=True, text=True, check=False).stdout

    return run


def test_a_folder_that_cannot_be_made(build: Build, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    answer = build("--screenshots", tmp_path / "file" / "pictures")
    assert answer.returncode == 2
    assert f"no folder {tmp_path}/file/pictures can be made for screenshots: Not a directory" in answer.stderr
    assert "--screenshots DIR" in answer.stderr


@pytest.mark.usefixtures("x_server", "displays")
def test_servers_that_start_at_once_take_numbers_of_their_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A server that takes no lock, as a desktop's does, keeps its socket too; what a killed one left is used again."""
    monkeypatch.setattr(display, "_require_engine_here", lambda: None)
    # Of its own: a proof of another test takes and leaves numbers of the usual range meanwhile
    monkeypatch.setattr(display, "NUMBERS", range(display.NUMBERS.stop, display.NUMBERS.stop + 100))
    first = next(number for number in display.NUMBERS if not display._answers(number))
    desktop = display.SOCKETS / f"X{first}"
    display.SOCKETS.mkdir(mode=0o1777, exist_ok=True)
    desktop.unlink(missing_ok=True)
    taken: list[int] = []

    def start(name: str) -> None:
        folder = tmp_path / name
        folder.mkdir()
        with display.virtual_display(folder) as found:
            taken.append(found.number)
            together.wait()

    together = threading.Barrier(5)
    with socket.socket(socket.AF_UNIX) as other:
        other.bind(str(desktop))
        other.listen()
        threads = [threading.Thread(target=start, args=(str(number),)) for number in range(4)]
        for thread in threads:
            thread.start()
        together.wait(60)
        for thread in threads:
            thread.join(60)
        assert len(set(taken)) == 4
        assert first not in taken
        assert desktop.is_socket()
    taken.clear()
    together = threading.Barrier(1)
    start("after")  # its file is still there, and nobody answers
    assert taken == [first]
    assert not desktop.exists()


PACKAGE = """\
<package format="2"><name>robot</name><version>1.0.0</version><description>x</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license></package>
"""
LAUNCH = {
    "Dockerfile": "FROM ros:noetic-ros-base\nCOPY . /opt/ros/noetic/share/robot\n"
    'RUN chmod +x /opt/ros/noetic/share/robot/node.py\nCMD ["roslaunch", "robot", "all.launch"]\n',
    "package.xml": PACKAGE,
    "node.py": "#!/usr/bin/env python3\nimport sys, time\ntime.sleep(1)\nsys.exit(int(sys.argv[1]))\n",
    "roslab.yaml": "format: 3\nname: launched\nkind: ros1\ndockerfile: Dockerfile\n",
}


@pytest.mark.parametrize(
    ("nodes", "said"),
    [
        ('<node pkg="robot" type="node.py" name="good" args="0"/>', "passed: still running after "),
        ('<node pkg="robot" type="node.py" name="bad" args="3"/>', "failed: bad-3 died with exit code 3, though "),
        ('<node pkg="robot" type="absent.py" name="none"/>', "failed: robot/absent.py cannot be started, though "),
        ('<node pkg="robot" type="node.py" name="must" args="4" required="true"/>', "must-3 died with exit code 4"),
    ],
    ids=["good", "died", "absent", "required"],
)
def test_a_launch_that_outlives_its_nodes(
    lab: Laboratory, roslab: Roslab, tmp_path: Path, nodes: str, said: str
) -> None:
    """roscore goes on without them; only the node that ended well leaves a proof that passed."""
    launch = f'<launch><node pkg="rosout" type="rosout" name="stays"/>{nodes}</launch>'
    folder = doors.write(tmp_path / "launched", {**LAUNCH, "all.launch": launch})
    answer = roslab("build", folder, "--tag", "repro-lab", env=lab.environment, timeout=900)
    assert said in answer.stderr
    assert answer.returncode == (0 if said.startswith("passed") else 5), answer.stderr
    lab_docker(lab)("image", "rm", "--force", "launched:repro-lab")
