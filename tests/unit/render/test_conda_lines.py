"""What is taken out of a conda file before it is read: by the command of the Dockerfile, which runs here."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render import image_scripts
from roslab.render.layers.conda_lines import TAKE, changed
from roslab.values.dataclass import replace

PLAIN = "name: a\ndependencies:\n- python=3.10\n- numpy\n"
FILE = "dependencies:\n- pytorch\n- pip\n- pip:\n  - numpy\n{}\n"
SCRIPTS = Path(image_scripts.__path__[0])


def without(folder: Path, text: str, *entries: str, others: bool = True) -> tuple[str, str]:
    """Return what conda and what pip are given after the commands that take these entries out of a conda file."""
    (folder / "environment.yml").write_text(PLAIN)
    plan = replace(plan_repository(folder).plan.python, conda_local=entries, conda_pip=others)
    file = folder / "changed.yml"
    file.write_bytes(text.encode())
    for command in changed(plan, str(file)):
        subprocess.run(["bash", "-c", command.replace(TAKE, f"bash {SCRIPTS / TAKE}.sh")], check=True)
    return file.read_text(), (folder / "changed.yml.pip").read_text()


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize(
    "line",
    [
        "  - sklearn",
        "  - sklearn  # metrics",
        "  - sklearn == 0.0",
        "  - \"sklearn; python_version >= '3.4'\"",
        "  - sklearn[extra]>=0.0",
        "  - pytorch",
        "  - -e ./own",
        "  - -e ./own[sim]",
        "  - -r lists/own.txt",
        "  - --requirement ./lists/own.txt",
    ],
)
def test_lines_for_pip_are_taken_out(tmp_path: Path, line: str, end: str) -> None:
    text = FILE.format(line).replace("\n", end)
    conda = "dependencies:\n- pytorch\n- pip\n"
    assert without(tmp_path, text, "own", "lists/own.txt", "sklearn", "pytorch") == (conda, "numpy\n")


def test_nothing_of_another_name_is_taken_out(tmp_path: Path) -> None:
    others = ("sklearn-extra", "owner", "scikit-sklearn==1.0", "lists/own.txt.in")
    text = FILE.format("\n".join(f"  - {each}" for each in others))
    assert without(tmp_path, text, "own", "sklearn")[1].split() == ["numpy", *others]


def test_where_nothing_is_left_for_pip_its_line_goes(tmp_path: Path) -> None:
    text = "dependencies:\n- numpy\n- pip:\n  - -e .\n- scipy\n"
    assert without(tmp_path, text, ".", others=False)[0] == "dependencies:\n- numpy\n- scipy\n"


@pytest.mark.parametrize("indent", ["", "  "])
@pytest.mark.parametrize("others", [True, False])
def test_lines_of_conda_s_own_stay_whatever_their_names(tmp_path: Path, indent: str, *, others: bool) -> None:
    more = f"{indent}    - click\n" if others else ""
    above = f"name: a\ndependencies:\n{indent}- tensorflow\n"
    below = f"{indent}- numpy=1.19\n{indent}- python=3.8\nprefix: /opt/a\n"
    part = f"{indent}- pip:\n{indent}    - tensorflow==2.20.0\n{more}{indent}    - numpy==9999\n"
    left, pip = without(tmp_path, f"{above}{part}{below}", "tensorflow", "numpy", others=others)
    assert left == above + below
    assert not others or pip == "click\n"
