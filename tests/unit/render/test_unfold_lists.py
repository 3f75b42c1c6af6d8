"""Lists of a conda file that stand in brackets are written item by item."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
import yaml

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "unfold-lists.sh"
FILES = (
    "dependencies: [python=3.8, pip, {pip: [torch==1.8.0+cu111, 'a[b]>=2', \"c\"]}]\n",
    "name: a\nchannels: [conda-forge, 'https://host.test']\ndependencies:\n  - a\n  - pip: [gym, -e .]\n  - scipy\n",
    'dependencies:\n- python\n- pip: [\n    gym,  # as in 2019\n    "git+https://host.test/a#egg=a",\n  ] # end\n- b\n',
    "dependencies:\r\n  - pip:\r\n      [gym, wandb]\r\nprefix: /opt/a\r\n",
    "dependencies:\n  [\n    python=3.8, # first\n    numpy\n  ]\nname: a\n",
    "dependencies:\n  - {pip: [gym, 'it''s']}\n  - b\n",
    "dependencies:\n  - python\n  - pip: []\nvariables: {A: '[x]'}\n",
    "# [no list]\ndependencies:\n  - python=3.8\n  - pip:\n    - gym[box]\n    - a  # [b]\n",
)


@pytest.mark.parametrize("text", FILES)
def test_the_file_says_the_same_without_brackets(tmp_path: Path, text: str) -> None:
    file = tmp_path / "environment.yml"
    file.write_text(text)
    subprocess.run(["bash", str(SCRIPT), str(file)], check=True)
    written, read = yaml.safe_load(file.read_text()), yaml.safe_load(text)
    for each in read["dependencies"]:
        if isinstance(each, dict):
            each["pip"] = each["pip"] or None
    assert written == read
    lines = file.read_text().splitlines()
    assert not [line for line in lines if line.strip("- ").startswith("[") or ": [" in line.partition("#")[0]]


def test_a_file_without_brackets_stays_as_it_is(tmp_path: Path) -> None:
    file = tmp_path / "environment.yml"
    file.write_text(FILES[-1])
    subprocess.run(["bash", str(SCRIPT), str(file)], check=True)
    assert file.read_text() == FILES[-1]
