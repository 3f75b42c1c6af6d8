"""A file that the command needs is fetched where it can be, and stops nothing where not."""

from __future__ import annotations

import subprocess
import zipfile
from pathlib import Path

import pytest

from roslab.render import image_scripts
from serving import served

SCRIPT = Path(image_scripts.__path__[0]) / "fetch-optional.sh"


@pytest.fixture
def there(tmp_path: Path) -> Path:
    (tmp_path / "site").mkdir()
    (tmp_path / "site/model.pth").write_bytes(b"\0weights")
    (tmp_path / "site/page.pth").write_text("<!DOCTYPE html><html>Sign in</html>")
    with zipfile.ZipFile(tmp_path / "site/data.zip", "w") as archive:
        archive.writestr("one/a.txt", "a")
    with (tmp_path / "site/large.bag").open("wb") as large:
        large.truncate(1_000_000_001)
    (tmp_path / "image").mkdir()
    return tmp_path


def run(there: Path, *words: str) -> str:
    with served(there / "site") as address:
        argv = ["bash", str(SCRIPT), f"{address}/{words[0]}", *words[1:]]
        answer = subprocess.run(argv, cwd=there / "image", capture_output=True, text=True, check=True)
    return answer.stdout.replace(address, "")


def listed(there: Path) -> list[str]:
    return sorted(str(path.relative_to(there / "image")) for path in (there / "image").rglob("*") if path.is_file())


def test_a_file(there: Path) -> None:
    assert run(there, "model.pth", "weights/model.pth") == "roslab: fetching /model.pth\n"
    assert (there / "image/weights/model.pth").read_bytes() == b"\0weights"


def test_an_archive(there: Path) -> None:
    run(there, "data.zip", "data.zip", "data")
    assert listed(there) == ["data/one/a.txt"]


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("gone.pth", "it cannot be fetched, or has more than 1 GB"),
        ("large.bag", "it cannot be fetched, or has more than 1 GB"),
        ("page.pth", "it is a page, not a file"),
    ],
)
def test_what_is_left_out(there: Path, name: str, why: str) -> None:
    assert f"roslab: left out: /{name}: {why}\n" in run(there, name, f"weights/{name}")
    assert listed(there) == []


def test_what_is_no_archive(there: Path) -> None:
    (there / "site/data.zip").write_bytes(b"no archive")
    assert "roslab: left out: /data.zip: it cannot be unpacked\n" in run(there, "data.zip", "data.zip", "data")
    assert listed(there) == []
