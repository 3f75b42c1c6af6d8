"""Environment markers, from every reader to what is installed, proved and decided."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import Planned, plan_repository

OLD = "importlib-metadata; python_version<'3.8'"
WINDOWS = 'pywin32; sys_platform=="win32"'
MAIN = "if __name__ == '__main__':\n    print(1)\n"
BACKEND = "[build-system]\nbuild-backend = 'x'\n"
SETUP = "from setuptools import setup\nsetup(name='a', "


def planned(folder: Path, files: dict[str, str]) -> Planned:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    return plan_repository(folder)


def proved(found: Planned) -> set[str]:
    """Return the packages without which the image gets no tag."""
    named = [proof.command for proof in found.plan.proofs if "Python packages" in proof.name]
    return {word for command in named for word in command[3:]}


@pytest.mark.parametrize(
    "files",
    [
        {"requirements.txt": f"six\n{OLD}\n{WINDOWS}\n"},
        {"requirements.txt": f"-r base.txt\n{WINDOWS}\n", "base.txt": f"six\n{OLD}\n"},
        {"pyproject.toml": f"[project]\nname = 'a'\ndependencies = ['six', \"{OLD}\", '{WINDOWS}']\n"},
        {
            "pyproject.toml": "[tool.poetry]\nname = 'a'\n[tool.poetry.dependencies]\nsix = '*'\n"
            "importlib-metadata = {version = '*', python = '<3.8'}\n"
            "pywin32 = [{version = '*', platform = 'win32'}, {version = '1', markers = \"sys_platform == 'cygwin'\"}]\n"
            + BACKEND
        },
        {"setup.py": f"{SETUP}install_requires=['six', \"{OLD}\", '{WINDOWS}'])\n"},
        {
            "setup.py": f"{SETUP}install_requires=['six'], extras_require={{':python_version<\"3.8\"': "
            "['importlib-metadata'], ':sys_platform==\"win32\"': ['pywin32'], 'gui:python_version>\"3\"': ['pyqt5']})\n"
        },
        {"setup.cfg": f"[metadata]\nname = a\n[options]\ninstall_requires =\n  six\n  {OLD}\n  {WINDOWS}\n"},
        {"environment.yml": f"dependencies:\n- pip:\n  - six\n  - \"{OLD}\"\n  - '{WINDOWS}'\n"},
        {
            "environment.yml": "dependencies:\n- numpy\n",
            "roslab.yaml": f"format: 3\npip:\n- six\n- \"{OLD}\"\n- '{WINDOWS}'\n",
        },
        {"roslab.yaml": f"format: 3\nkind: python\npip:\n- six\n- \"{OLD}\"\n- '{WINDOWS}'\n"},
    ],
    ids=[
        "file",
        "included",
        "pep621",
        "poetry",
        "setup.py",
        "extras",
        "setup.cfg",
        "conda",
        "conda-pip",
        "roslab.yaml",
    ],
)
def test_what_does_not_hold_in_the_image_is_proved_nowhere(tmp_path: Path, files: dict[str, str]) -> None:
    found = planned(tmp_path, {"main.py": MAIN, **files})
    assert {"importlib-metadata", "pywin32", "pyqt5"} & proved(found) == set()
    installed = {asked.key for asked in found.decision.pip}
    assert "six" in (installed if found.decision.python.conda_file else proved(found)), "conda proves no names of pip's"
    assert {"importlib-metadata", "pywin32"} & installed == set()


@pytest.mark.parametrize("lines", ["RUN pip install six {0} {1}\n", "RUN pip3 install six \\\n {0} \\\n {1}\n"])
@pytest.mark.parametrize("where", ["README.md", "docker/Dockerfile"])
def test_an_install_line_with_markers(tmp_path: Path, where: str, lines: str) -> None:
    text = lines.format(f'"{OLD}"', f"'{WINDOWS}'")
    text = f"FROM ubuntu:22.04\n{text}" if "Docker" in where else f"```\n{text.removeprefix('RUN ')}```\n"
    found = planned(tmp_path, {"main.py": MAIN, where: text})
    assert {"six"} == {asked.key for asked in found.decision.pip}
    assert found.decision.python.version == "3.10"


def test_what_holds_is_proved_with_its_marker(tmp_path: Path) -> None:
    lines = "numpy; python_version >= '3.8'\nsix; platform_system == 'Linux'\nattrs; platform_machine == 'x86_64'\n"
    assert proved(planned(tmp_path, {"requirements.txt": lines})) == {"numpy", "six"}, "attrs is on one platform only"


def test_one_platform_needs_what_holds_on_it(tmp_path: Path) -> None:
    files = {
        "requirements.txt": "attrs; platform_machine == 'x86_64'\n",
        "roslab.yaml": "format: 3\nplatforms: [linux/amd64]\n",
    }
    assert proved(planned(tmp_path, files)) == {"attrs"}


def test_a_framework_for_another_system_makes_no_cuda_image(tmp_path: Path) -> None:
    found = planned(
        tmp_path, {"requirements.txt": "torch==1.13.1; sys_platform=='darwin'\nsix\n", "a.py": "import six\n"}
    )
    assert found.plan.kind == "python"
    assert "nvidia" not in found.plan.base_image
    assert found.decision.cuda is None
    assert found.plan.platforms == ("linux/amd64", "linux/arm64")


def test_a_wheel_for_the_other_machine_refuses_no_platform(tmp_path: Path) -> None:
    line = "https://e.org/thing-1.0-cp310-cp310-linux_x86_64.whl ; platform_machine == 'x86_64'\n"
    assert planned(tmp_path, {"requirements.txt": line}).plan.platforms == ("linux/amd64", "linux/arm64")
    assert planned(tmp_path, {"requirements.txt": line.partition(" ;")[0]}).plan.platforms == ("linux/amd64",)


def test_files_that_are_included_lie_beside_those_that_include_them(tmp_path: Path) -> None:
    files = {"requirements.txt": "-r base.txt\n-c pins.txt\n", "base.txt": "six\n", "pins.txt": "six<2\n"}
    assert planned(tmp_path, files).plan.python.manifests == ("base.txt", "pins.txt")
