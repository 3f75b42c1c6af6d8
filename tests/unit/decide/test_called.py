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
        ("from subprocess import run\nrun(\n    ['rsync', source])", ["rsync"]),
        ("subprocess.run(args=('rsync', source))", ["rsync"]),
        ("run(['rsync', source])", []),
    ],
)
def test_the_programs_that_code_calls(tree: Tree, code: str, asked: list[str]) -> None:
    files = {"train.py": f"import os\nimport subprocess\n{code}\n", "requirements.txt": "numpy\n"}
    files["tests/test_it.py"] = "import os\nos.system('zip a b')\n"
    assert [
        name for name in tree(files).apt_guessed if name in {"curl", "ffmpeg", "rsync", "unzip", "wget", "zip"}
    ] == asked


@pytest.mark.parametrize(
    ("path", "asked"), [("setup.py", True), ("python/setup.py", True), ("third_party/a/setup.py", False)]
)
def test_the_programs_that_a_setup_script_calls(tree: Tree, path: str, asked: bool) -> None:
    script = (
        "import subprocess\nfrom setuptools import setup\n"
        "commit = subprocess.check_output(\n    ['git', 'rev-parse', 'HEAD']\n)\n"
        "setup(name='demo', install_requires=['numpy'])\n"
    )
    decision = tree({"demo/__init__.py": "import numpy\n", "requirements.txt": "numpy\n", path: script})
    assert ("git" in decision.apt_guessed) == asked
