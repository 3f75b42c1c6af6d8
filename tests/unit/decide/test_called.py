"""Packages of the programs that Python code calls."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("code", "asked"),
    [
        ("os.system('wget --no-check-certificate %s; unzip %s' % (www, zipfile))", ["unzip", "wget"]),
        ("os.system('unzip {} -d .'.format(zipfile))", ["unzip"]),
        ('os.system(f"cd {data} && sudo curl -O {url} | unzip")', ["curl", "unzip"]),
        ('subprocess.check_call(["ffmpeg", "-i", video])', ["ffmpeg"]),
        ('subprocess.run(\n    ["rsync", source],\n)', ["rsync"]),
        ('subprocess.run(["echo; unzip"])', []),
        ("os.system('python3 unzip.py')", []),
        ("os.system(unzip)", []),
        ("# os.system('unzip a.zip')", []),
        ("system('unzip a.zip')", []),
    ],
)
def test_the_programs_that_code_calls(tree: Tree, code: str, asked: list[str]) -> None:
    files = {"train.py": f"import os\nimport subprocess\n{code}\n", "requirements.txt": "numpy\n"}
    files["tests/test_it.py"] = "import os\nos.system('zip a b')\n"
    assert [
        name for name in tree(files).apt_guessed if name in {"curl", "ffmpeg", "rsync", "unzip", "wget", "zip"}
    ] == asked
