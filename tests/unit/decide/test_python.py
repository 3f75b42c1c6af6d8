"""Which Python with which packages, from small trees to an answer."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import Base, Config, Kind
from roslab.decide.cuda.version import decide_cuda
from roslab.decide.python.compiling import Compiling, decide_compiling
from roslab.decide.python.environment import decide_python
from roslab.decide.python.image_python import Python
from roslab.decide.python.installed import installed
from roslab.decide.python.own import decide_version
from roslab.decide.python.pins import pins
from roslab.decide.system.wheels import apt_for_wheels
from roslab.evidence.facts import Evidence
from roslab.evidence.prose import author_dockerfile as dockerfile
from roslab.evidence.prose import ci, readme
from roslab.evidence.python import conda, imports, requirements
from roslab.evidence.python import project as python_project
from roslab.evidence.python.programs import read as programs
from roslab.plan.python import PythonPlan, python_plan
from roslab.repository.checkout import Repository


def evidence_of(tmp_path: Path, files: dict[str, str]) -> Evidence:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    repository = Repository.open(tmp_path)
    prose = readme.read(repository)
    return Evidence(
        python=python_project.read(repository),
        requirements=requirements.read(repository),
        conda=conda.read(repository),
        dockerfiles=dockerfile.read(repository),
        code=imports.read(repository),
        programs=programs(repository),
        prose=prose.dependencies,
        prose_pip=prose.requirements,
        sources=prose.sources,
        mentions=prose.mentions,
    )


def chosen(evidence: Evidence, config: Config, kind: Kind, ubuntu: str | None = None, ros: str | None = None) -> Python:
    """Decide on Python alone, on an Ubuntu that is given."""
    mentioned = pins(evidence)
    cuda = decide_cuda(evidence, config, mentioned).answer.version
    own = decide_version(evidence, config, kind, pins=mentioned, ros_distro=ros, cuda=cuda)
    return decide_python(
        evidence, config, kind, pins=mentioned, own=own, ubuntu=ubuntu, ros_distro=ros, cuda=cuda
    ).answer


def decide(
    tmp_path: Path,
    files: dict[str, str],
    kind: Kind = "python",
    ubuntu: str | None = None,
    config: Config | None = None,
) -> PythonPlan:
    ros = "noetic" if kind == "ros1" else None
    return python_plan(chosen(evidence_of(tmp_path, files), config or Config(), kind, ubuntu, ros))


@pytest.mark.parametrize(
    ("files", "version"),
    [
        ({"requirements.txt": "torch==1.7.1\n"}, "3.8"),
        ({"requirements.txt": "torch==2.1.0\n"}, "3.10"),
        ({"requirements.txt": "tensorflow-gpu==1.4.0\n"}, "3.6"),
        ({"requirements.txt": "numpy==1.19.5\nscipy==1.4.1\n"}, "3.8"),
        ({"requirements.txt": "numpy==1.26.4\n", "README.md": "Python 3.11"}, "3.11"),
        ({"requirements.txt": "numpy==1.26.4\n", "README.md": "Python 2.7"}, "3.10"),
        ({"README.md": "conda create -n x python=3.7 -y"}, "3.7"),
        ({"requirements.txt": "numpy>=1.22\n", "README.md": "Python 3.7"}, "3.10"),
        ({"README.md": '  File "/opt/x/lib/python3.7/site-packages/y.py", line 3\n'}, "3.10"),
        ({"README.md": "I will drop Python 2.7 support"}, "3.10"),
        (
            {
                "README.md": "Runs with Python 2.7.",
                "setup.py": "from setuptools import setup\nsetup(classifiers=['Python :: 2.7', 'Python :: 3.5'])\n",
            },
            "3.7",
        ),
        ({"setup.py": "from setuptools import setup\nsetup(classifiers=['Python :: 2.7', 'Python :: 3'])\n"}, "3.10"),
        ({"setup.py": "from setuptools import setup\nsetup(classifiers=['Python :: 2.7', 'Python :: 2'])\n"}, "2.7"),
        ({"README.md": "Needs Python 3.5+.\n\nI use Python 3.6.\n"}, "3.6"),
        ({"README.md": "Python 3.6, 3.7 or 3.8 (3.8 recommended)"}, "3.8"),
        ({"README.md": "It is there for Python\n3.7 - 3.10."}, "3.10"),
        ({"environment.yml": "dependencies:\n  - python=3.9.1\n"}, "3.9"),
        ({"pyproject.toml": "[project]\nname='a'\nrequires-python='>=3.12'\n"}, "3.12"),
        ({"requirements.txt": "https://e.org/whl/torch-1.1.0-cp27-cp27mu-linux_x86_64.whl\n"}, "2.7"),
        ({"a.py": "import numpy\n"}, "3.10"),
    ],
)
def test_version(tmp_path: Path, files: dict[str, str], version: str) -> None:
    assert decide(tmp_path, files).version == version


def requires_python(requires: str) -> dict[str, str]:
    return {"pyproject.toml": f"[project]\nname = 'a'\nrequires-python = '{requires}'\n"}


@pytest.mark.parametrize(
    ("files", "version"),
    [
        (requires_python("~=3.8.2"), "3.8"),
        (requires_python(">=3.9,!=3.10.*"), "3.12"),
        (requires_python(">=3.6,<3.8.10"), "3.8"),
        (requires_python(">=3.8.2,<3.9"), "3.8"),
        (requires_python("==3.8.*"), "3.8"),
        (requires_python("<3.8.1,>3.7.99"), "3.8"),
        (requires_python("3.9"), "3.9"),
        (requires_python(">=3.11.*"), "3.12"),
        (
            {
                "pyproject.toml": "[tool.poetry]\nname = 'a'\n[tool.poetry.dependencies]\npython = '~3.8'\n"
                "[build-system]\nbuild-backend = 'poetry'\n"
            },
            "3.8",
        ),
        (
            {
                "pyproject.toml": "[tool.poetry]\nname = 'a'\n[tool.poetry.dependencies]\npython = '^3.11.2'\n"
                "[build-system]\nbuild-backend = 'poetry'\n"
            },
            "3.12",
        ),
        (
            {"setup.py": "from setuptools import setup\nsetup(name='a', python_requires='>=3.6,!=3.10.*,<3.11')\n"},
            "3.8",
        ),
        ({"setup.cfg": "[metadata]\nname = a\n[options]\npython_requires = ~=3.6.1\n"}, "3.6"),
    ],
)
def test_a_minor_version_fits_where_any_of_its_patches_does(
    tmp_path: Path, files: dict[str, str], version: str
) -> None:
    assert decide(tmp_path, files).version == version


def test_the_configuration_wins(tmp_path: Path) -> None:
    config = Config(base=Base(python="3.9"), requirements=("b.txt",), pip3=("six",))
    python = decide(tmp_path, {"requirements.txt": "numpy\n", "requirements-b.txt": "scipy\n"}, config=config)
    assert (python.version, python.requirements, python.pip) == ("3.9", (), ("six",))


def test_ros_takes_the_system_python(tmp_path: Path) -> None:
    python = decide(tmp_path, {"pkg/requirements.txt": "numpy==1.19.5\n"}, kind="ros1", ubuntu="focal")
    assert (python.version, python.manager, python.requirements) == (None, "system", ("pkg/requirements.txt",))


@pytest.mark.parametrize(
    ("files", "chosen"),
    [
        (("requirements.txt", "requirements_frozen.txt", "docs/requirements.txt"), ("requirements.txt",)),
        (("python/requirements.txt", "third_party/x/requirements.txt"), ("python/requirements.txt",)),
        (("requirements/base.txt", "requirements/dev.txt"), ("requirements/base.txt",)),
        (("requirement.txt",), ("requirement.txt",)),
        (("requirements-gpu.txt",), ("requirements-gpu.txt",)),
    ],
)
def test_the_plainest_requirement_file_nearest_to_the_root(
    tmp_path: Path, files: tuple[str, ...], chosen: tuple[str, ...]
) -> None:
    assert decide(tmp_path, dict.fromkeys(files, "six\n")).requirements == chosen


def test_files_and_projects_that_the_readme_installs(tmp_path: Path) -> None:
    files = {
        "README.md": "```\npip install -r requirements_sim.txt\ncd third_party/gym && pip install -e .\n```\n",
        "requirements_sim.txt": "six\n",
        "setup.py": "from setuptools import setup\nsetup(name='a')\n",
        "third_party/gym/setup.py": "from setuptools import setup\nsetup(name='gym')\n",
        "third_party/other/setup.py": "from setuptools import setup\nsetup(name='other')\n",
    }
    python = decide(tmp_path, files)
    assert python.requirements == ("requirements_sim.txt",)
    assert python.projects == (".", "third_party/gym")


def test_conda_where_nothing_plainer_is_said(tmp_path: Path) -> None:
    environment = "dependencies:\n  - python=3.9\n  - pytorch=1.12.1\n  - pip:\n    - einops==0.4\n"
    evidence = evidence_of(tmp_path / "a", {"conda_env.yaml": environment})
    python = chosen(evidence, Config(), "cuda", "jammy")
    assert (python.manager, python.conda_file) == ("conda", "conda_env.yaml")
    assert tuple(asked.told for asked in installed(evidence, python)) == ("einops==0.4", "torch==1.12.1")
    both = decide(tmp_path / "b", {"conda_env.yaml": environment, "requirements.txt": "torch==1.12.1\n"})
    assert both.conda_file is None


def test_guesses_come_from_prose_and_imports_and_never_twice(tmp_path: Path) -> None:
    files = {
        "requirements.txt": "opencv-python-headless\nnumpy\n",
        "README.md": "`pip install torch==1.10.0+cu113 -f https://download.pytorch.org/whl/cu113/torch_stable.html`",
        "a.py": "import cv2, numpy, yaml, unheard_of\n",
    }
    python = decide(tmp_path, files, kind="cuda")
    assert (python.pip, python.pip_guessed) == (("torch==1.10.0+cu113",), ("PyYAML",))
    assert python.options == ("--find-links https://download.pytorch.org/whl/cu113/torch_stable.html",)


def test_a_file_that_pip_would_refuse_is_installed_line_by_line(tmp_path: Path) -> None:
    python = decide(tmp_path, {"requirements.txt": '"numpy == 2.3.5"\nsix\n'})
    assert (python.requirements, python.pip) == ((), ("numpy==2.3.5", "six"))


def test_a_setup_py_that_imports_its_own_package_is_built_where_that_can_be_imported(tmp_path: Path) -> None:
    files = {
        "requirements.txt": "numpy==1.19.5\n",
        "setup.py": "import a\nimport sys\nfrom setuptools import setup\nsetup(name='a', install_requires=['numpy'])\n",
        "a/__init__.py": "import numpy\n",
        "pyproject.toml": "[build-system]\nrequires = ['setuptools>=40', 'wheel']\n",
    }
    assert decide(tmp_path, files).first == ("setuptools>=40", "numpy==1.19.5", "wheel")


def test_a_setup_py_that_imports_what_an_isolated_build_lacks(tmp_path: Path) -> None:
    files = {"setup.py": "import numpy\nimport mine\nfrom setuptools import setup\nsetup(name='a')\n", "mine.py": ""}
    assert decide(tmp_path, files).first == ("numpy",)
    (tmp_path / "pyproject.toml").write_text("[build-system]\nrequires = ['setuptools', 'numpy']\n")
    assert decide(tmp_path, {}).first == ()


def test_what_only_ci_runs_is_not_installed(tmp_path: Path) -> None:
    evidence = evidence_of(tmp_path, {".travis.yml": "install:\n  - pip install ros_buildfarm codecov six\n"})
    evidence = replace(evidence, prose_pip=ci.read(Repository.open(tmp_path)).requirements)
    assert [asked.text for asked in chosen(evidence, Config(), "python").pip_guessed] == ["six"]


def test_what_must_be_there_first(tmp_path: Path) -> None:
    files = {
        "requirements.txt": "torch==2.0.1\nflash-attn\n",
        "setup.py": "from torch.x import CUDAExtension\nimport setuptools\nsetuptools.setup(name='a')\n",
    }
    assert decide(tmp_path, files).first == ("torch==2.0.1", "packaging", "ninja", "numpy")


def test_what_one_manifest_pins_binds_what_another_one_installs_before_it(tmp_path: Path) -> None:
    asked = "torch==2.2.0", "torchvision==0.17.0", "einops"
    files = {
        "robot/requirements_robot.txt": "torchvision\ntorch\nh5py\nflash-attn\n",
        "pyproject.toml": f"[project]\nname = 'a'\ndependencies = {list(asked)}\n",
        "README.md": "```\npip install -e .\npip install -r requirements_robot.txt\n```\n",
    }
    found = decide(tmp_path, files, "cuda")
    assert found.first[0] == "torch==2.2.0"
    assert found.bounds == ("torch==2.2.0", "torchvision==0.17.0", "numpy<2")
    files["robot/requirements_robot.txt"] = "torch==1.9.0\ntorchvision\n"
    assert decide(tmp_path, files, "cuda").bounds == ("numpy<2",)


def test_what_a_guess_needs_first_is_as_optional_as_the_guess(tmp_path: Path) -> None:
    page = {"README.md": "```\npip install detectron2\n```\n", "a.py": "import torchvision\n"}
    found = decide(tmp_path, page, "cuda")
    assert found.first == ()
    assert [line.partition(" ")[0] for line in found.pip_guessed] == ["torch", "torchvision", "detectron2"]
    (tmp_path / "requirements.txt").write_text("torch==2.1.0\n")
    found = decide(tmp_path, {}, "cuda")
    assert found.first == ()
    assert [line.partition(" ")[0] for line in found.pip_guessed] == ["torchvision", "detectron2"]


def test_what_stops_without_another_package_gets_that_first(tmp_path: Path) -> None:
    assert decide(tmp_path, {"requirements.txt": "vtk==9.1.0\nmayavi\n"}).first == ("numpy", "vtk==9.1.0")


def test_wheels_bring_their_system_packages(tmp_path: Path) -> None:
    evidence = evidence_of(tmp_path, {"requirements.txt": "opencv-python\nmatplotlib\n"})
    python = chosen(evidence, Config(), "python")
    everything = installed(evidence, python)
    found = dict(apt_for_wheels(python, everything, "focal", evidence))
    assert {"libgl1", "libglib2.0-0", "python3-tk"} <= set(found)
    assert (found["libgl1"].file, found["libgl1"].line) == ("requirements.txt", 1)
    assert "libgl1-mesa-glx" in dict(apt_for_wheels(python, everything, "xenial", evidence))


@pytest.mark.parametrize(("asked", "needed"), [("opencv-python", False), ("opencv-python==4.1.2.30", True)])
def test_only_older_wheels_need_what_they_were_linked_with(tmp_path: Path, asked: str, needed: bool) -> None:
    evidence = evidence_of(tmp_path, {"requirements.txt": f"{asked}\n"})
    python = chosen(evidence, Config(), "python")
    found = dict(apt_for_wheels(python, installed(evidence, python), "focal", evidence))
    assert ("libxrender1" in found) == needed
    assert "libgl1" in found


@pytest.mark.parametrize(
    ("asked", "needed"),
    [("pillow==7.2.0\nnumpy==1.26", True), ("pillow==7.2.0\nnumpy==1.19.5", False), ("pillow\nnumpy==1.26", False)],
)
def test_a_release_without_a_wheel_for_the_python_is_compiled_with_its_libraries(
    tmp_path: Path, asked: str, needed: bool
) -> None:
    evidence = evidence_of(tmp_path, {"requirements.txt": f"{asked}\nmatplotlib==3.8.2\n" * needed or f"{asked}\n"})
    python = chosen(evidence, Config(), "python")
    found = dict(apt_for_wheels(python, installed(evidence, python), "focal", evidence))
    assert ({"libjpeg-dev", "zlib1g-dev"} <= set(found)) == needed


def test_imports_of_ros_code_come_from_apt(tmp_path: Path) -> None:
    evidence = evidence_of(tmp_path, {"n.py": "import numpy\nimport rospy\nimport ultralytics\n"})
    focal = chosen(evidence, Config(), "ros1", "focal", "noetic")
    everything = installed(evidence, focal)
    assert [name for name, _ in apt_for_wheels(focal, everything, "focal", evidence)] == ["python3-numpy"]
    assert [asked.text for asked in focal.pip_guessed] == ["ultralytics"]
    assert [name for name, _ in apt_for_wheels(focal, everything, "bionic", evidence)] == ["python-numpy"]


@pytest.mark.parametrize(("asked", "by_apt"), [("scipy==1.10.1", False), ("scipy", True), ("numpy==1.24.4", True)])
def test_what_pip_installs_in_one_release_is_not_asked_of_apt_too(tmp_path: Path, asked: str, by_apt: bool) -> None:
    files = {"requirements.txt": f"{asked}\n", "n.py": "import rclpy\nimport scipy\n"}
    evidence = evidence_of(tmp_path, files)
    python = chosen(evidence, Config(), "ros2", "jammy", "humble")
    found = dict(apt_for_wheels(python, installed(evidence, python), "jammy", evidence))
    assert ("python3-scipy" in found) == by_apt


def test_wheels_of_python_2_have_its_tk(tmp_path: Path) -> None:
    script = "import matplotlib\n\nif __name__ == '__main__':\n    print(matplotlib)\n"
    files = {"README.md": "Needs Python 2.7.", "CMakeLists.txt": "project(x)\n", "plot.py": script}
    evidence = evidence_of(tmp_path, files)
    python = chosen(evidence, Config(), "cpp", "bionic")
    found = dict(apt_for_wheels(python, installed(evidence, python), "bionic", evidence))
    assert (python.version, "python-tk" in found, "python3-tk" in found) == ("2.7", True, False)


@pytest.mark.parametrize(
    ("files", "guessed"),
    [
        ({"airsim/flight.py": "import airsim\n", "n.py": "import airsim\n"}, ("airsim",)),
        ({"airsim/flight.py": "import time\n", "n.py": "import airsim\n"}, ()),
        ({"airsim/__init__.py": "", "airsim/flight.py": "import airsim\n", "n.py": "import airsim\n"}, ()),
        ({"airsim/flight.py": "import airsim.flight\n", "n.py": "import airsim\n"}, ()),
    ],
)
def test_a_folder_whose_programs_import_the_package_of_its_name_is_not_that(
    tmp_path: Path, files: dict[str, str], guessed: tuple[str, ...]
) -> None:
    assert decide(tmp_path, {"requirements.txt": "tqdm\n", **files}).pip_guessed == guessed


def test_a_page_of_the_documentation_tells_what_to_install_but_not_what_developers_use(tmp_path: Path) -> None:
    page = {"CMakeLists.txt": "project(x)\n", "docs/install.md": "```\npip install cmake pytest\n```\n"}
    assert decide(tmp_path, page, kind="cpp").pip_guessed == ("cmake",)


@pytest.mark.parametrize(
    ("page", "ubuntu", "python"),
    [
        ("Compile it.", "jammy", ("3.10", "venv")),
        ("Compile it.", "focal", ("3.8", "venv")),
        ("Needs Python 3.9.", "jammy", ("3.9", "conda")),
        ("Needs Python 2.7.", "bionic", ("2.7", "system")),
        ("Needs Python 2.7.", "jammy", ("2.7", "conda")),
    ],
)
def test_scripts_beside_cpp_run_on_the_python_of_its_ubuntu(
    tmp_path: Path, page: str, ubuntu: str, python: tuple[str, str]
) -> None:
    script = "import numpy\n\nif __name__ == '__main__':\n    print(numpy)\n"
    files = {"README.md": page, "CMakeLists.txt": "project(x)\n", "plot.py": script}
    evidence = replace(evidence_of(tmp_path, files), pip_day="2021-05-05")
    found = chosen(evidence, Config(), "cpp", ubuntu)
    assert (found.version, found.manager) == python


@pytest.mark.parametrize(
    ("more", "python"),
    [
        ({"docs/INSTALLATION.md": "- Python 3.12\n"}, ("3.10", "venv")),
        ({".github/workflows/a.yml": "jobs: {a: {steps: [{with: {python-version: '3.12'}}]}}\n"}, ("3.10", "venv")),
        ({"docs/INSTALLATION.md": "- Python 3.12\n", "requirements.txt": "numpy\n"}, ("3.12", "conda")),
    ],
)
def test_a_python_that_is_named_aside_is_no_other_one_for_cpp(
    tmp_path: Path, more: dict[str, str], python: tuple[str, str]
) -> None:
    script = "import numpy\n\nif __name__ == '__main__':\n    print(numpy)\n"
    files = {"README.md": "Compile it.", "CMakeLists.txt": "project(x)\n", "plot.py": script, **more}
    found = chosen(evidence_of(tmp_path, files), Config(), "cpp", "jammy")
    assert (found.version, found.manager) == python


@pytest.mark.parametrize(
    ("pin", "ubuntu", "python"),
    [
        ("numpy==1.26.4", "noble", ("3.12", "venv")),
        ("numpy==1.26.4", "jammy", ("3.10", "venv")),
        ("numpy==1.26.4", "focal", ("3.10", "conda")),
        ("numpy==1.19.5", "bionic", ("3.6", "venv")),
    ],
)
def test_pins_beside_cpp_that_the_python_of_its_ubuntu_fits_ask_for_no_other(
    tmp_path: Path, pin: str, ubuntu: str, python: tuple[str, str]
) -> None:
    script = "import numpy\n\nif __name__ == '__main__':\n    print(numpy)\n"
    files = {"requirements.txt": f"{pin}\n", "CMakeLists.txt": "project(x)\n", "plot.py": script}
    found = chosen(evidence_of(tmp_path, files), Config(), "cpp", ubuntu)
    assert (found.version, found.manager) == python


def test_documentation_itself_is_installed_nowhere(tmp_path: Path) -> None:
    tools = {"CMakeLists.txt": "project(x)\n", "docs/install.sh": "pip install sphinx-thing\n"}
    assert decide(tmp_path, tools, kind="cpp").pip_guessed == ()


def compiling_of(tmp_path: Path, files: dict[str, str], cuda: str | None = None) -> Compiling:
    """Decide what the packages of a small CUDA or Python repository take to be built."""
    evidence = evidence_of(tmp_path, files)
    python = chosen(evidence, Config(), "cuda" if cuda else "python")
    projects = [project for project in evidence.python if (project.folder or ".") in python.projects]
    return decide_compiling(projects, (*installed(evidence, python), *python.first), cuda)


def test_packages_with_wheels_for_every_python_need_no_compiler(tmp_path: Path) -> None:
    assert compiling_of(tmp_path, {"requirements.txt": "numpy\nscipy>=1.5\nmatplotlib\n"}) == Compiling()
    assert compiling_of(tmp_path, {"requirements.txt": "numpy\nmpi4py\n"}).compiler


def test_git_lines_of_a_setup_py_need_git(tmp_path: Path) -> None:
    line = "fcl @ git+ssh://git@github.com/someone/fcl.git@v1"
    setup = f"from setuptools import setup\nsetup(name='a', install_requires=['numpy', '{line}'])\n"
    found = compiling_of(tmp_path, {"setup.py": setup})
    assert found.git
    assert found.hosts == ("github.com",)


def test_lines_in_a_conda_file_with_the_protocol_that_ended(tmp_path: Path) -> None:
    listed = "dependencies:\n- python=3.6\n- pip:\n  - git+git://github.com/someone/suite.git\n"
    found = compiling_of(tmp_path, {"environment.yml": listed + "  - git+ssh://git@code.example.org/a/b.git\n"})
    assert found.git
    assert found.hosts == ("github.com",)  # nobody says that the other answers to https


def test_a_rust_backend_needs_cargo(tmp_path: Path) -> None:
    text = "[build-system]\nrequires = ['maturin>=1']\nbuild-backend = 'maturin'\n[project]\nname = 'a'\n"
    found = compiling_of(tmp_path, {"pyproject.toml": text})
    assert found.rust
    assert found.compiler


def test_extensions_of_torch_are_compiled_without_a_gpu(tmp_path: Path) -> None:
    setup = (
        "from setuptools import setup\nfrom torch.utils.cpp_extension import CUDAExtension\n"
        "setup(name='a', ext_modules=[CUDAExtension('a', ['a.cu'])])\n"
    )
    assert compiling_of(tmp_path, {"setup.py": setup}, "11.3").architectures == "6.1;7.0;7.5;8.0;8.6+PTX"
    assert compiling_of(tmp_path, {"setup.py": setup}, "11.0").architectures == "6.1;7.0;7.5;8.0+PTX"
    older = {"setup.py": setup, "requirements.txt": "torch==1.5.1\n"}  # it stops at a name that it does not know
    assert compiling_of(tmp_path / "older", older, "11.0").architectures == "6.1;7.0;7.5+PTX"
    assert not compiling_of(tmp_path / "plain", {"requirements.txt": "torch\n"}, "11.3").architectures
    unknown = "git+https://github.com/someone/ops.git\n"  # it may be one
    assert compiling_of(tmp_path / "git", {"requirements.txt": f"torch\n{unknown}"}, "11.3").architectures
    assert not compiling_of(tmp_path / "none", {"requirements.txt": unknown}, "11.3").architectures


def test_a_package_that_reads_a_variable_of_its_own_is_told_the_gpus(tmp_path: Path) -> None:
    line = "git+https://github.com/NVlabs/tiny-cuda-nn/#subdirectory=bindings/torch\n"
    asked = {"requirements.txt": "torch==1.10.1\n" + line}
    assert compiling_of(tmp_path, asked, "11.3").gpus == (("TCNN_CUDA_ARCHITECTURES", "70;75;80;86"),)
    assert decide(tmp_path, asked, "cuda").first == ("torch==1.10.1", "packaging", "ninja")


def test_a_package_that_sees_no_gpu_is_told_by_an_option(tmp_path: Path) -> None:
    asked = {"requirements.txt": "torch==1.10.1\nMinkowskiEngine==0.5.4\n"}
    assert compiling_of(tmp_path, asked, "11.3").options == (("MinkowskiEngine==0.5.4", "--force_cuda"),)
    assert not compiling_of(tmp_path, asked, None).options
    cloned = {"requirements.txt": "torch==1.10.1\ngit+https://github.com/NVIDIA/MinkowskiEngine\n"}
    line = "git+https://github.com/NVIDIA/MinkowskiEngine"  # pip leaves one of the same version as it is
    assert compiling_of(tmp_path / "cloned", cloned, "11.3").options == ((line, "--force_cuda"),)


def test_the_environment_that_the_readme_creates_wins_over_a_project(tmp_path: Path) -> None:
    files = {
        "environment.yaml": "channels: [conda-forge]\ndependencies: [python=3.9, numpy]\n",
        "setup.py": "from setuptools import setup\nsetup(name='a', install_requires=['numpy'])\n",
    }
    assert decide(tmp_path / "unnamed", files).conda_file is None
    files["README.md"] = "```\nconda env create -f environment.yaml\nconda activate a\npip install -e .\n```\n"
    found = decide(tmp_path, files)
    assert found.conda_file == "environment.yaml"
    assert found.projects == (".",)


def test_an_environment_that_is_created_without_a_file_is_environment_yml(tmp_path: Path) -> None:
    files = {
        "environment.yml": "channels: [conda-forge]\ndependencies: [python=3.9, numpy]\n",
        "setup.py": "from setuptools import setup\nsetup(name='a', install_requires=['numpy'])\n",
        "README.md": "Create it with `conda env create`, or:\n```\nconda env create\nconda activate a\n```\n",
    }
    assert decide(tmp_path, files).conda_file == "environment.yml"


def test_requirements_that_the_readme_installs_first_win_over_its_environment(tmp_path: Path) -> None:
    files = {
        "environment.yml": "dependencies: [python=3.9, numpy]\n",
        "requirements.txt": "numpy\n",
        "README.md": "```\npip install -r requirements.txt\n```\nor\n```\nconda env create -f environment.yml\n```\n",
    }
    assert decide(tmp_path, files).requirements == ("requirements.txt",)
    files["README.md"] = "```\npip3 install -e .\n```\nAlternatively\n```\nconda env create -f environment.yml\n```\n"
    assert decide(tmp_path, files).requirements == ("requirements.txt",)


def test_conda_adds_its_default_channels(tmp_path: Path) -> None:
    start = "dependencies: [python=3.7, numpy]\n"
    assert decide(tmp_path / "a", {"environment.yml": "channels: [conda-forge]\n" + start}).conda_defaults
    assert not decide(tmp_path / "b", {"environment.yml": "channels: [x, nodefaults]\n" + start}).conda_defaults
    assert not decide(tmp_path / "c", {"environment.yml": "channels: [defaults]\n" + start}).conda_defaults


def test_a_backend_that_brings_what_it_compiles_with_is_isolated(tmp_path: Path) -> None:
    text = "[build-system]\nrequires = ['scikit-build-core', 'pybind11']\nbuild-backend = 'scikit_build_core.build'\n"
    assert decide(tmp_path, {"pyproject.toml": text + "[project]\nname = 'a'\ndependencies = ['numpy']\n"}).first == ()


def test_an_environment_of_another_system_is_not_taken(tmp_path: Path) -> None:
    text = "dependencies: [python=3.8, numpy]\n"
    files = {f"environment/{name}-env.yml": text for name in ("mac", "linux-gpu")}
    assert decide(tmp_path, files).conda_file == "environment/linux-gpu-env.yml"


@pytest.mark.parametrize(
    ("lines", "bounds"),
    [
        ("torch==1.11.0\nnumpy\n", ("numpy<2",)),
        ("torch==2.4.0\nnumpy\n", ()),
        ("torch==1.11.0\nnumpy<1.25\n", ()),
        ("tensorflow==2.10.0\nscipy\n", ("numpy<2",)),
        ("torch\nnumpy\n", ()),
        ("opencv-python==4.8.0.74\nscipy\n", ("numpy<2",)),
        ("opencv-python-headless==4.10.0.84\nscipy\n", ()),
        ("opencv-python==4.8.0.74\nnumpy>=2\n", ()),
    ],
)
def test_a_framework_older_than_numpy_2_keeps_it_out(tmp_path: Path, lines: str, bounds: tuple[str, ...]) -> None:
    assert decide(tmp_path, {"requirements.txt": lines}).bounds == bounds
