"""A library that a package is compiled against comes before pip, and the module is compiled while the image is made."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan
from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile
from roslab.render.layers import native_parts
from roslab.values.native_part import NativePart
from serving import served

SCRIPTS = Path(image_scripts.__path__[0])
PART = NativePart(
    name="Engine 2.0",
    package="engine-py",
    folder=".engine/engine200",
    archive="https://host.test/engine200_linux.zip",
    unpacks="engine200_linux",
    key=(".engine/key.txt", "https://host.test/key.txt"),
    variables=(("ENGINE_PATH", ".engine/engine200"), ("ENGINE_KEY", ".engine/key.txt")),
)
SETUP = "from setuptools import setup\nsetup(name='demo', install_requires=['mujoco-py==2.0.2.13'])\n"
CODE = "import mujoco_py\nif __name__ == '__main__':\n    print(mujoco_py)\n"


def planned(folder: Path, files: dict[str, str]) -> Plan:
    for path, text in files.items():
        (folder / path).write_text(text, encoding="utf-8")
    return plan_repository(folder).plan


def calls(text: str) -> list[int]:
    return [match.start() for match in re.finditer("compile-on-import python3 mujoco_py", text)]


def test_the_library_comes_before_pip_and_the_module_after_it(tmp_path: Path) -> None:
    text = dockerfile(planned(tmp_path, {"train.py": CODE, "requirements.txt": "mujoco-py==2.0.2.13\n"}))
    fetched = text.index("https://www.roboti.us/download/mujoco200_linux.zip")
    brought = text.index("COPY --from=native-parts")
    (compiled,) = calls(text)
    assert fetched < brought < text.index("# Requirement files") < compiled < text.index("# The source\n")
    assert "MUJOCO_PY_MUJOCO_PATH=/home/${NB_USER}/.mujoco/mujoco200 \\\n" in text
    library = 'LD_LIBRARY_PATH="/home/${NB_USER}/.mujoco/mujoco200/bin${LD_LIBRARY_PATH:+:${LD_LIBRARY_PATH}}"\n'
    assert library in text


def test_what_a_project_of_the_tree_installs_is_compiled_after_it(tmp_path: Path) -> None:
    text = dockerfile(planned(tmp_path, {"train.py": CODE, "setup.py": SETUP}))
    assert text.index("COPY --from=native-parts") < text.index("--editable .") < calls(text)[1]
    (line,) = (line for line in text.split("\n") if "--editable ." in line)
    assert 'HOME="/home/${NB_USER}" python3 -m pip install' in line  # where its setup.py looks for the library


@pytest.mark.parametrize(
    ("files", "more"),
    [({"setup.py": SETUP.replace("mujoco-py", "gym")}, ""), ({"setup.py": SETUP}, "secrets: [netrc]\n")],
)
def test_other_projects_are_installed_with_the_home_of_root(tmp_path: Path, files: dict[str, str], more: str) -> None:
    settings = {"roslab.yaml": f"format: 3\n{more}"} if more else {}
    text = dockerfile(planned(tmp_path, {"train.py": CODE.replace("mujoco_py", "gym"), **files, **settings}))
    assert "--editable ." in text
    assert 'HOME="/home/${NB_USER}" python3 -m pip' not in text


def test_a_conda_environment_is_made_with_the_library(tmp_path: Path) -> None:
    environment = "name: a\ndependencies: [python=3.8, pip, pip: ['mujoco-py<2.2,>=2.1']]\n"
    text = dockerfile(planned(tmp_path, {"train.py": CODE, "environment.yml": environment}))
    assert text.index("COPY --from=native-parts") < text.index("micromamba create") < calls(text)[0]


def test_an_image_without_it(tmp_path: Path) -> None:
    plan = planned(tmp_path, {"train.py": "import mujoco\n", "requirements.txt": "mujoco\n"})
    assert "native-parts" not in dockerfile(plan)
    assert "compile-on-import" not in dockerfile(plan)


def test_an_old_format_keeps_its_image(tmp_path: Path) -> None:
    plan = planned(tmp_path, {"roslab.yaml": "format: 3\ncompatible: later\nkind: python\npip: [mujoco-py]\n"})
    assert plan.compatible
    assert not plan.python.native_parts


@pytest.fixture
def fetched(tmp_path: Path, plan: Callable[..., Plan]) -> Callable[[], str]:
    """Return a function that runs the commands of the stage, where a small server serves the folder ``site``."""
    (tmp_path / "site").mkdir()
    (tmp_path / "image").mkdir()
    (tmp_path / "bin").mkdir()
    shutil.copy(SCRIPTS / "fetch-optional.sh", tmp_path / "bin/fetch-optional")
    (tmp_path / "bin/fetch-optional").chmod(0o755)
    run = native_parts.stage(plan(native_parts=(PART,))).partition("\nRUN fetch-optional")[2]

    def fetch() -> str:
        with served(tmp_path / "site") as address:
            commands = f"fetch-optional{run}".replace("https://host.test", address)
            path = f"{tmp_path / 'bin'}:{os.environ['PATH']}"
            argv = ["bash", "-eo", "pipefail", "-c", commands]
            done = subprocess.run(
                argv, cwd=tmp_path / "image", env={"PATH": path}, capture_output=True, text=True, check=True
            )
        return done.stdout

    return fetch


def test_the_folder_gets_the_name_that_the_package_looks_for(tmp_path: Path, fetched: Callable[[], str]) -> None:
    with zipfile.ZipFile(tmp_path / "site/engine200_linux.zip", "w") as archive:
        archive.writestr("engine200_linux/bin/libengine200.so", "so")
    (tmp_path / "site/key.txt").write_text("key", encoding="utf-8")
    assert "left out" not in fetched()
    files = {str(path.relative_to(tmp_path / "image")) for path in (tmp_path / "image").rglob("*") if path.is_file()}
    assert files == {".engine/engine200/bin/libengine200.so", ".engine/key.txt"}


def test_what_does_not_answer_is_told(fetched: Callable[[], str]) -> None:
    said = fetched()
    assert "roslab: left out: Engine 2.0 is missing, and engine-py does not work without it" in said
    assert "roslab: left out: the key of Engine 2.0 is missing" in said


FIRST = """\
import os
from pathlib import Path
here = Path(__file__).parent
(here / "library.o").touch()
(here / "compiled").write_text(os.environ["HOME"])
"""


def compiled(folder: Path, module: str | None) -> str:
    if module is not None:
        (folder / "engine_py").mkdir()
        (folder / "engine_py/__init__.py").write_text(module, encoding="utf-8")
    # Who runs the tests is the image's user
    given = {"NB_USER": "jovyan", "NB_UID": str(os.getuid()), "PYTHONPATH": str(folder), "PATH": os.environ["PATH"]}
    argv = ["bash", str(SCRIPTS / "compile-on-import.sh"), sys.executable, "engine_py"]
    return subprocess.run(argv, env=given, capture_output=True, text=True, check=True).stdout


def test_a_module_is_compiled_with_the_home_of_the_user(tmp_path: Path) -> None:
    assert compiled(tmp_path, FIRST) == "roslab: engine_py is compiled\n"
    assert (tmp_path / "engine_py/compiled").read_text(encoding="utf-8") == "/home/jovyan"
    assert not (tmp_path / "engine_py/library.o").exists()


def test_one_that_cannot_be_compiled_stops_nothing(tmp_path: Path) -> None:
    said = compiled(tmp_path, "raise OSError('no library')\n")
    assert said.startswith("roslab: left out: engine_py cannot be compiled or imported")


def test_one_that_is_not_installed_is_no_matter(tmp_path: Path) -> None:
    assert compiled(tmp_path, None) == ""
