"""What a container gets of a display, where there can be none, and how its picture is called."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from PIL import Image, ImageGrab

from roslab.errors import BuildError
from roslab.pipeline import plan_repository
from roslab.prove import display
from roslab.prove.screenshot import NO_PILLOW, Camera, Screenshot, file_name


def test_the_container_gets_a_socket_and_a_key_and_nothing_else() -> None:
    options = display.Display(number=7, key=Path("/private/Xauthority")).options()
    pairs = dict(zip(options[1::2], options[::2], strict=True))
    assert pairs == {
        "type=tmpfs,destination=/tmp/.X11-unix,tmpfs-mode=1777": "--mount",
        "type=bind,source=/tmp/.X11-unix/X7,destination=/tmp/.X11-unix/X7,readonly": "--mount",
        "type=bind,source=/private/Xauthority,destination=/run/roslab/Xauthority,readonly": "--mount",
        "DISPLAY=:7": "--env",
        "XAUTHORITY=/run/roslab/Xauthority": "--env",
        "LIBGL_ALWAYS_SOFTWARE=1": "--env",
    }


def test_without_an_x_server_it_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(BuildError) as caught, display.virtual_display(tmp_path):
        pass
    assert str(caught.value) == "Xvfb is not installed (on Debian and Ubuntu: apt install xvfb)"


@pytest.mark.parametrize(
    ("host", "system", "said"),
    [
        ("tcp://docker:2376", "Alpine Linux", "the Docker engine at tcp://docker:2376 is on another machine"),
        ("ssh://lab@robot", "Debian", "the Docker engine at ssh://lab@robot is on another machine"),
        ("", "", "the Docker engine at an unknown address is on another machine"),
        (
            "unix:///home/a/.docker/desktop/docker.sock",
            "Docker Desktop",
            "Docker Desktop's engine is in a virtual machine",
        ),
    ],
)
def test_an_engine_elsewhere_has_no_display(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, host: str, system: str, said: str
) -> None:
    """Stand-ins of the programs: one that must not be started, and a client that knows two questions."""
    (tmp_path / "Xvfb").write_text("#!/bin/sh\nexit 1\n")
    answers = f'#!/bin/sh\ncase "$1" in context) echo "{host}" ;; info) echo "{system}" ;; *) exit 9 ;; esac\n'
    (tmp_path / "docker").write_text(answers)
    for program in ("Xvfb", "docker"):
        (tmp_path / program).chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(BuildError) as caught, display.virtual_display(tmp_path):
        pass
    assert str(caught.value) == said


def test_a_server_that_does_not_start_says_why(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A stand-in that fails as the real one does where the sockets' folder is read-only."""
    (tmp_path / "Xvfb").write_text("#!/bin/sh\necho 'Cannot establish any listening sockets' >&2\nexit 1\n")
    (tmp_path / "docker").write_text("#!/bin/sh\necho unix:///var/run/docker.sock\n")
    for program in ("Xvfb", "docker"):
        (tmp_path / program).chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(BuildError) as caught, display.virtual_display(tmp_path):
        pass
    assert str(caught.value) == "Xvfb does not start: Cannot establish any listening sockets"


def test_the_key_is_one_entry_for_every_host_and_number() -> None:
    cookie = bytes(range(16))
    assert display._entry(cookie) == b"\xff\xff\0\0\0\0\0\x12MIT-MAGIC-COOKIE-1\0\x10" + cookie


@pytest.mark.parametrize(
    ("platform", "proof", "expected"),
    [
        ("linux/amd64", "the default command starts", "screenshot-linux-amd64-default-command-starts.png"),
        ("linux/arm/v7", "the repository's test", "screenshot-linux-arm-v7-repository-test.png"),
        ("linux/arm64", "../../etc; $(id)", "screenshot-linux-arm64-etc-id.png"),
    ],
)
def test_the_name_of_a_picture(platform: str, proof: str, expected: str) -> None:
    assert file_name(platform, proof) == expected


def test_what_is_told_of_a_picture() -> None:
    assert str(Screenshot(file=Path("/a/b.png"))) == "screenshot: /a/b.png"
    assert str(Screenshot(file=Path("/a/b.png"), remark="nothing")) == "screenshot: /a/b.png; nothing"
    assert str(Screenshot(remark=NO_PILLOW)) == f"no screenshot; {NO_PILLOW}"


PROGRAM = "if __name__ == '__main__':\n    print(1)\n"


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"main.py": PROGRAM}, {"the default command starts": False}),
        ({"main.py": PROGRAM, "roslab.yaml": "format: 3\ngui: true\n"}, {"the default command starts": True}),
        ({"main.py": "import tkinter\n" + PROGRAM}, {"the default command starts": True}),
        (
            {"main.py": "import tkinter\n" + PROGRAM, "roslab.yaml": "format: 3\ngui: false\n"},
            {"the default command starts": False},
        ),
        (
            {"main.py": "import PyQt5\n", "roslab.yaml": "format: 3\ntest: python3 main.py\n"},
            {"the repository's test": True},
        ),
    ],
    ids=["none", "said", "imported", "denied", "test"],
)
def test_which_proofs_have_a_display(tmp_path: Path, files: dict[str, str], expected: dict[str, bool]) -> None:
    """What opens windows has one; imports and packages are proved without."""
    for name, text in {**files, "requirements.txt": "numpy\nPyQt5\n"}.items():
        (tmp_path / name).write_text(text)
    found = {proof.name: proof.display for proof in plan_repository(tmp_path).plan.proofs}
    assert {name: found[name] for name in expected} == expected
    assert not any(shown for name, shown in found.items() if name not in expected)


def test_without_pillow_the_proof_goes_on(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "PIL", None)
    camera = Camera(display=display.Display(number=7, key=tmp_path / "Xauthority"))
    camera.look()
    assert (camera.blind, camera.drawn) == (True, False)
    assert camera.keep(tmp_path / "a.png") == Screenshot(remark="Pillow is not installed (pip install Pillow)")


def test_a_display_that_is_gone_gives_no_picture_and_no_error(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("XAUTHORITY", "the user's own")
    camera = Camera(display=display.Display(number=59999, key=tmp_path / "Xauthority"))
    camera.look()
    assert (camera.blind, camera.drawn) == (True, False)
    assert os.environ["XAUTHORITY"] == "the user's own"
    kept = camera.keep(tmp_path / "a.png")
    assert kept.file is None
    assert kept.remark.startswith("the display gives no picture: ")
    assert list(tmp_path.iterdir()) == []


def test_the_newest_picture_with_something_in_it_is_kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A stand-in of the X server's answers: blank, a window, another, and blank again once it is closed."""
    pictures = []
    for colour in (None, "red", "green", None):
        pictures.append(Image.new("RGB", (30, 20)))
        if colour:
            pictures[-1].paste(colour, (5, 5, 10, 10))
    answers = iter(pictures)
    monkeypatch.setattr(ImageGrab, "grab", lambda xdisplay: next(answers))
    camera = Camera(display=display.Display(number=7, key=tmp_path / "Xauthority"))
    camera.look()
    assert camera.keep(tmp_path / "blank.png").remark == "nothing was drawn: it is wholly blank"
    for _ in range(3):
        camera.look()
    assert camera.keep(tmp_path / "new" / "a.png") == Screenshot(file=tmp_path / "new" / "a.png")
    with Image.open(tmp_path / "new" / "a.png") as kept:
        assert kept.getpixel((6, 6)) == (0, 128, 0)
    (tmp_path / "file").touch()
    assert "cannot be written" in camera.keep(tmp_path / "file" / "a.png").remark
