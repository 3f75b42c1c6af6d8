"""The script that moves a build tree between a cache mount and an image."""

from __future__ import annotations

import subprocess
import tarfile
from pathlib import Path

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/carry-build.sh"


def carry(root: Path, mount: Path, *words: str) -> None:
    mount.mkdir(exist_ok=True)
    text = SCRIPT.read_text().replace("/var/cache/roslab-build", str(mount)).replace("/before", str(root / "before"))
    subprocess.run(["bash", "-c", text, "carry-build", *words], check=True)


def size(root: Path, mount: Path) -> str:
    carry(root, mount, "size", str(root / "said"))
    return (root / "said/size").read_text().strip()


def fill(mount: Path, code: str) -> None:
    for name, text in {"fingerprint": "same", "contents": code, "tree/build/a.o": code}.items():
        (mount / name).parent.mkdir(parents=True, exist_ok=True)
        (mount / name).write_text(text)


def test_a_tree_is_packed_and_taken(tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    assert size(tmp_path, first) == "none"
    carry(tmp_path, first, "pack", str(tmp_path / "before"))
    carry(tmp_path, second, "take")  # there was none
    assert size(tmp_path, second) == "none"
    fill(first, "one")
    assert int(size(tmp_path, first)) > 0
    carry(tmp_path, first, "pack", str(tmp_path / "before"))
    assert size(tmp_path, first) == "same", "it is kept"
    carry(tmp_path, second, "take")
    assert (second / "tree/build/a.o").read_text() == "one"
    assert size(tmp_path, second) == "same", "nothing was compiled with it"
    fill(second, "two")
    assert int(size(tmp_path, second)) > 0


def test_what_ccache_keeps_travels_with_the_tree_and_without_one(tmp_path: Path) -> None:
    program, workspace = tmp_path / "program", tmp_path / "workspace"
    for mount in (program, workspace):
        (mount / "ccache/1").mkdir(parents=True)
        (mount / "ccache/1/a.result").write_text("one")
        (mount / "ccache/1/stats").write_text("0")
    fill(workspace, "one")
    for number, mount in enumerate((program, workspace)):
        assert int(size(tmp_path, mount)) > 0
        carry(tmp_path, mount, "pack", str(tmp_path / "before"))
        (mount / "ccache/1/stats").write_text("1")
        assert size(tmp_path, mount) == "same", "a count of hits is nothing new"
        second = tmp_path / f"second{number}"
        carry(tmp_path, second, "take")
        assert (second / "ccache/1/a.result").read_text() == "one"
        assert (second / "tree/build/a.o").exists() == (mount == workspace)
    (program / "ccache/1/b.result").write_text("two")
    assert int(size(tmp_path, program)) > 0


def test_a_mount_keeps_its_own_tree(tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    fill(first, "one")
    fill(second, "two")
    carry(tmp_path, first, "pack", str(tmp_path / "before"))
    carry(tmp_path, second, "take")
    assert (second / "tree/build/a.o").read_text() == "two"


def test_what_is_packed_is_what_reuse_build_keeps(tmp_path: Path) -> None:
    fill(tmp_path / "mount", "one")
    carry(tmp_path, tmp_path / "mount", "pack", str(tmp_path / "before"))
    with tarfile.open(tmp_path / "before/tree.tar") as packed:
        assert {name.partition("/")[0] for name in packed.getnames()} == {"contents", "fingerprint", "tree"}


def test_a_tree_that_a_failed_build_left_gives_way(tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    fill(first, "one")
    carry(tmp_path, first, "pack", str(tmp_path / "before"))
    fill(second, "two")
    (second / "tree/build/b.o").touch()
    (second / "fingerprint").unlink()
    assert size(tmp_path, second) == "none"
    carry(tmp_path, second, "pack", str(tmp_path / "other"))
    assert not list((tmp_path / "other").iterdir())
    carry(tmp_path, second, "take")
    assert [(file.name, file.read_text()) for file in (second / "tree/build").iterdir()] == [("a.o", "one")]
    assert size(tmp_path, second) == "same"
