"""Lists that a shell hands to an installer by a here-document, a here-string or a pipe."""

from __future__ import annotations

from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.facts import Evidence
from roslab.evidence.gather import gather
from roslab.evidence.prose.here_lists import spelled_out
from trees import tree_of


def apt(evidence: Evidence) -> list[tuple[str, int]]:
    return [(each.name, each.line) for each in evidence.prose if each.namespace == "apt"]


def pip(evidence: Evidence) -> list[tuple[str, int]]:
    return [(each.written, each.line) for each in evidence.prose_pip]


@pytest.mark.parametrize(
    ("script", "packages", "requirements"),
    [
        (
            "sudo xargs apt-get install -y <<EOF\nffmpeg\n# seen below\nlibfoo-dev git\nEOF\n",
            {"ffmpeg": 2, "libfoo-dev": 4, "git": 4}, {},
        ),
        ("cat <<-'EOF' | xargs -r sudo apt install\n\tffmpeg\n\tEOF\n", {"ffmpeg": 2}, {}),
        ("sudo apt-get install -y $(cat <<EOF\nffmpeg\nEOF\n)\necho done\n", {"ffmpeg": 2}, {}),
        (
            "pip install -r /dev/stdin <<'EOF'\nscipy>=1.10,<2  # old\nshapely\nEOF\n",
            {}, {"scipy>=1.10,<2": 2, "shapely": 3},
        ),
        ("cat > deps/req.txt <<EOF\nscipy\nEOF\npip install -r deps/req.txt\n", {}, {"scipy": 2}),
        ("cat <<EOF >req.txt\nscipy\nEOF\npip3 install -r ./req.txt trimesh\n", {}, {"scipy": 2, "trimesh": 4}),
        ('xargs sudo apt-get install <<< "ffmpeg git"\n', {"ffmpeg": 1, "git": 1}, {}),
        ("pip install -r /dev/stdin <<< 'scipy'\n", {}, {"scipy": 1}),
        ('echo "scipy trimesh" | xargs pip install\n', {}, {"scipy": 1, "trimesh": 1}),
    ],
)  # fmt: skip
def test_the_list_is_installed(
    tmp_path: Path, script: str, packages: dict[str, int], requirements: dict[str, int]
) -> None:
    (tmp_path / "s").mkdir()
    evidence = gather(tree_of(tmp_path / "s", {"install.sh": f"#!/bin/bash\n{script}", "main.py": "print(1)\n"}))
    assert dict(apt(evidence)) == {name: line + 1 for name, line in packages.items()}
    assert {name.replace(" ", ""): line for name, line in pip(evidence)} == {
        name: line + 1 for name, line in requirements.items()
    }
    page = f"# Demo\n```bash\n{script}```\n"
    evidence = gather(tree_of(tmp_path / "p", {"README.md": page, "main.py": "print(1)\n"}))
    assert dict(apt(evidence)) == {name: line + 2 for name, line in packages.items()}
    assert {name.replace(" ", ""): line for name, line in pip(evidence)} == {
        name: line + 2 for name, line in requirements.items()
    }


@pytest.mark.parametrize(
    "text",
    [
        "cat > config.txt <<EOF\nscipy\nEOF\npython main.py --list config.txt\n",
        "cat <<EOF >> ~/.bashrc\nexport A=pip install\nEOF\n",
        "docker build - <<EOF\nRUN apt-get install git\nEOF\n",
        "find . | xargs rm\n",
        "std::cout << EOF << x;\n",
    ],
)
def test_what_is_no_list_is_left(text: str) -> None:
    assert spelled_out(text) == text


def test_long_lines_end() -> None:
    for line in (f"echo a{' ' * 60_000}x xargs", "xargs " + "echo a " * 9_000):
        with ends():
            assert spelled_out(line) == line
