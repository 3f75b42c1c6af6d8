"""Files of which the tree has only the pointers of Git LFS."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence import pointers
from roslab.repository.checkout import Repository

POINTER = "version https://git-lfs.github.com/spec/v1\noid sha256:a0076a70\nsize 16128\n"
LFS = " filter=lfs diff=lfs merge=lfs -text\n"


@pytest.mark.parametrize(
    ("attributes", "files", "names"),
    [
        (f"*.so{LFS}", ("lib/a.so", "lib/b.so"), "lib/a.so, lib/b.so"),
        (f"*.md text\nassets/*.obj{LFS}*.so{LFS}", ("assets/a.obj", "lib/b.so"), "assets/a.obj, lib/b.so"),
        (f"*.so{LFS}", tuple(f"{name}.so" for name in "abcde"), "a.so, b.so, c.so and 2 more"),
        (f"*.so{LFS}*.png{LFS}", ("media/a.png", "docs/b.so", "c.txt"), ""),
        ("*.so text\n", ("lib/a.so",), ""),
    ],
)
def test_pointers(tmp_path: Path, attributes: str, files: tuple[str, ...], names: str) -> None:
    for path, text in {".gitattributes": attributes, **dict.fromkeys(files, POINTER)}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    told = [message for message, _, _ in pointers.read(Repository.open(tmp_path))]
    assert [message.partition("image, of ")[2].partition(":")[0] for message in told] == ([names] if names else [])


def test_content_that_is_there_is_no_pointer(tmp_path: Path) -> None:
    (tmp_path / ".gitattributes").write_text(f"*.so{LFS}")
    (tmp_path / "a.so").write_bytes(b"\x7fELF\0\0")
    assert not [*pointers.read(Repository.open(tmp_path))]
