"""What a conda file has for pip is installed once the environment is there."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
import yaml

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "take-pip-part.sh"


def taken(folder: Path, text: str) -> tuple[list[object], list[str]]:
    file = folder / "environment.yml"
    file.write_text(text)
    subprocess.run(["bash", str(SCRIPT), str(file)], check=True)
    return yaml.safe_load(file.read_text())["dependencies"], (folder / "environment.yml.pip").read_text().splitlines()


@pytest.mark.parametrize("indent", ["", "  "])
def test_the_list_is_taken_as_yaml_reads_it(tmp_path: Path, indent: str) -> None:
    lines = ["numpy==1.26.4  # as in the paper", "'torch[cu]>=2'", '"mujoco <4"', "git+https://host.test/a#egg=a"]
    lines += ["# nothing", "-r more.txt", "--extra-index-url https://host.test/whl"]
    part = "".join(f"{indent}    {'' if line.startswith('#') else '- '}{line}\n" for line in lines)
    text = f"name: a\ndependencies:\n{indent}- python=3.8\n{indent}- pip: # pip\n{part}\n{indent}- scipy\n"
    text += "prefix: /opt/a\n"
    expected = next(item for item in yaml.safe_load(text)["dependencies"] if isinstance(item, dict))["pip"]
    assert taken(tmp_path, text) == (["python=3.8", "scipy"], expected)
    assert expected[:2] == ["numpy==1.26.4", "torch[cu]>=2"]


def test_items_may_stand_below_the_name(tmp_path: Path) -> None:
    text = "dependencies:\r\n  - pip\r\n  - pip:\r\n    - gym\r\n\r\n    - wandb\r\n"
    assert taken(tmp_path, text) == (["pip"], ["gym", "wandb"])


def test_a_file_without_such_a_list_stays(tmp_path: Path) -> None:
    text = "dependencies:\n  - pip=21\n  - pip: [gym]\n"
    assert taken(tmp_path, text) == (["pip=21", {"pip": ["gym"]}], [])
