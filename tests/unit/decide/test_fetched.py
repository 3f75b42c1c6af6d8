"""Folders that a conda file or a page installs and that a submodule brings are installed once they are cloned."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.pipeline import plan_repository
from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
MODULES = '[submodule "sub/knn"]\n\tpath = sub/knn\n\turl = https://github.com/somebody/knn.git\n'
CONDA = "name: a\ndependencies:\n  - python=3.8\n  - pytorch=1.12.1\n  - pip:\n    - sub/knn\n    - -e .\n    - munch\n"


def test_folders_of_a_conda_file_are_installed_after_the_source(tree: Tree) -> None:
    decision = tree(
        {
            ".gitmodules": MODULES,
            "environment.yml": CONDA,
            "run.py": "import torch\n",
            "setup.py": "from setuptools import setup\nsetup(name='a')\n",
        }
    )
    assert decision.python.conda_local == ("sub/knn", ".")
    assert decision.python.conda_pip
    assert set(decision.python.projects) == {".", "sub/knn"}
    assert "-devel" in decision.base_image


def test_a_page_installs_a_folder_of_a_submodule(tree: Tree) -> None:
    page = "```\npip install torch\npip install sub/knn\n```\n"
    decision = tree({".gitmodules": MODULES, "README.md": page, "run.py": "import torch\n"})
    assert decision.python.projects == ("sub/knn",)


def test_a_page_goes_into_a_submodule_below_a_folder_that_the_reader_knows(tree: Tree) -> None:
    page = "```\ncd {this_repo}/sub/knn\npip install -e .\ncd {this_repo}\npip install -e .\n```\n"
    setup = "from setuptools import setup\nsetup(name='a')\n"
    decision = tree({".gitmodules": MODULES, "README.md": page, "run.py": "import torch\n", "setup.py": setup})
    assert set(decision.python.projects) == {".", "sub/knn"}


@pytest.mark.parametrize("line", ["-e .", "-e ./lib", "-e lib", "./lib", "-e sub/knn"])
def test_a_requirement_file_names_a_folder(tree: Tree, line: str) -> None:
    setup = "from setuptools import setup\nsetup(name='{}')\n"
    files = {"setup.py": setup.format("a"), "lib/setup.py": setup.format("lib"), ".gitmodules": MODULES}
    python = tree({**files, "requirements.txt": f"munch==2.0\n{line}\n", "run.py": "import munch\n"}).python
    assert python.requirements == ()  # the folder is not there when the file would be read
    assert [each.written for each in python.pip] == ["munch==2.0"]
    folder = line.removeprefix("-e ").removeprefix("./")
    assert set(python.projects) == {".", folder}


@pytest.mark.parametrize(("more", "first"), [("import torch", True), ("import jax", False)])
def test_a_folder_of_a_submodule_needs_torch_first_only_beside_torch(tree: Tree, more: str, first: bool) -> None:
    page = "```\npip install jax[cuda12_pip]==0.4.20\npip install sub/knn\n```\n"
    python = tree({".gitmodules": MODULES, "README.md": page, "run.py": f"{more}\n"}).python
    assert python.projects == ("sub/knn",)
    assert any(each.key == "torch" for each in python.first) == first


def test_a_page_installs_a_folder_that_is_copied_from_elsewhere(tree: Tree) -> None:
    setup = "from setuptools import setup\nsetup(name='b', packages=['b'])\n"
    files = {"pyproject.toml": "[project]\nname='a'\nversion='1'\n", "thirdparty/b/setup.py": setup}
    decision = tree({**files, "README.md": "```\npip install -e thirdparty/b\npip install -e .\n```\n"})
    assert set(decision.python.projects) == {".", "thirdparty/b"}


def test_the_folders_are_taken_out_of_the_file_before_conda_reads_it(tmp_path: Path) -> None:
    (tmp_path / "environment.yml").write_text(CONDA.replace("    - munch\n", ""), encoding="utf-8")
    (tmp_path / ".gitmodules").write_text(MODULES, encoding="utf-8")
    (tmp_path / "run.py").write_text("import torch\n", encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    command = next(line for line in text.splitlines() if "take-pip-part /tmp" in line)
    command = command.strip().removeprefix("RUN ").removeprefix("&& ").removesuffix(" \\")
    script = Path(image_scripts.__path__[0]) / "take-pip-part.sh"
    command = command.replace("/tmp/manifests", str(tmp_path)).replace("take-pip-part", f"bash {script}")
    subprocess.run(["bash", "-c", command], check=True)
    left = (tmp_path / "environment.yml").read_text(encoding="utf-8")
    assert left == "name: a\ndependencies:\n  - python=3.8\n  - pytorch=1.12.1\n"
    assert "environment.yml.pip" not in text


@pytest.mark.parametrize(
    ("line", "apt"),
    [
        ("dlib==19.17.0", {"cmake", "build-essential"}),
        ("box2d-py", {"swig", "build-essential"}),
        ("munch", {"build-essential"}),
    ],
)
def test_what_the_pip_part_of_a_conda_file_is_compiled_with_is_there_before(
    tmp_path: Path, line: str, apt: set[str]
) -> None:
    conda = f"name: a\ndependencies:\n  - python=3.8\n  - pip:\n    - {line}\n"
    (tmp_path / "environment.yml").write_text(conda, encoding="utf-8")
    (tmp_path / "run.py").write_text("print('runs')\n", encoding="utf-8")
    plan = plan_repository(tmp_path).plan
    assert apt == {"cmake", "swig", "build-essential"} & set(plan.apt)
    text = dockerfile(plan)
    assert all(text.index(f"      {name} ") < text.index("micromamba create") for name in apt)


@pytest.mark.parametrize(("name", "kind"), [("detector", "cuda"), ("detector_ros", "ros2"), ("ROS2-detector", "ros2")])
def test_what_is_named_after_ros_is_no_wrapper(tmp_path: Path, name: str, kind: str) -> None:
    files = {
        "x/a/package.xml": "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
        "x/a/CMakeLists.txt": "project(a)\nfind_package(ament_cmake REQUIRED)\nadd_executable(a a.cpp)\n",
        "requirements.txt": "torch\n",
        "x/run.py": "import torch\n",
    }
    assert decide(gather(tree_of(tmp_path, files)), Config(), folder_name=name).kind == kind


@pytest.mark.parametrize("file", ["environment.yml", "requirements.txt"])
def test_the_python_of_conda_brings_tk(tree: Tree, file: str) -> None:
    text = "name: a\ndependencies:\n  - python=3.8\n  - matplotlib\n" if file.endswith("yml") else "matplotlib\n"
    decision = tree({file: text, "run.py": "import matplotlib\n"})
    assert ("python3-tk" in decision.apt_guessed) == (file == "requirements.txt")


@pytest.mark.parametrize(
    "lines", ["pip install -r sub/knn/requirements.txt", "cd sub/knn\npip install -r requirements.txt"]
)
def test_a_page_installs_the_requirement_file_of_a_submodule(tmp_path: Path, lines: str) -> None:
    (tmp_path / ".gitmodules").write_text(MODULES, encoding="utf-8")
    link = "Our [knn](https://github.com/somebody/knn) is a submodule.\n"
    (tmp_path / "README.md").write_text(f"{link}```\npip install einops\n{lines}\n```\n", encoding="utf-8")
    (tmp_path / "run.py").write_text("import knn\nimport torch\n", encoding="utf-8")
    plan = plan_repository(tmp_path, folder_name="demo").plan
    assert plan.python.cloned_files == ("sub/knn/requirements.txt",)
    assert not any("knn" in line for line in plan.python.pip_guessed)
    text = dockerfile(plan)
    install = text.index("-- /home/${NB_USER}/demo/sub/knn/requirements.txt")
    assert (
        text.index("git clone https://github.com/somebody/knn") < install < text.index("install-optional-pip python3")
    )
    (tmp_path / "sub/knn").mkdir(parents=True)
    (tmp_path / "sub/knn/requirements.txt").write_text("munch\n", encoding="utf-8")
    assert plan_repository(tmp_path, folder_name="demo").plan.python.cloned_files == ()


@pytest.mark.parametrize(("line", "cloned"), [("sub/knn/requirements.txt", True), ("parts/more.txt", False)])
def test_a_requirement_file_includes_what_is_not_there(tree: Tree, line: str, cloned: bool) -> None:
    files = {".gitmodules": MODULES, "requirements.txt": f"munch==2.0\n-r {line}\n", "run.py": "import munch\n"}
    found = tree(files)
    assert found.python.requirements == (), "pip would stop at it"
    assert [each.written for each in found.python.pip] == ["munch==2.0"]
    assert found.python.cloned_files == ((line,) if cloned else ())
    told = [each for each in found.warnings if each.message.startswith(f"{line} is included")]
    assert [(each.file, each.line) for each in told] == ([] if cloned else [("requirements.txt", 2)])


@pytest.mark.parametrize("path", ["path/to/demo", "/path/to/demo", "your/path/to/demo"])
def test_a_path_of_the_reader_s_leaves_the_folder_that_the_page_was_in(tree: Tree, path: str) -> None:
    page = f"```\ncd sub/knn\npip install -e .\n```\n```\ncd {path}\npip install -e .\n```\n"
    setup = "from setuptools import setup\nsetup(name='demo')\n"
    decision = tree({".gitmodules": MODULES, "README.md": page, "run.py": "import munch\n", "setup.py": setup})
    assert set(decision.python.projects) == {".", "sub/knn"}


def test_a_folder_below_the_one_that_the_page_is_in_stays_there(tree: Tree) -> None:
    page = "```\ncd sub/knn\n```\n```\ncd path/inner\npip install -e .\n```\n"
    decision = tree({".gitmodules": MODULES, "README.md": page, "run.py": "import munch\n"})
    assert decision.python.projects == ("sub/knn/path/inner",)


@pytest.mark.parametrize(
    ("there", "said"), [(("setup.py",), "pip"), (("pyproject.toml",), "pip"), ((), "left out")], ids=str
)
def test_a_folder_that_nobody_has_seen_is_installed_if_it_is_a_project(
    tmp_path: Path, there: tuple[str, ...], said: str
) -> None:
    (tmp_path / ".gitmodules").write_text(MODULES, encoding="utf-8")
    (tmp_path / "README.md").write_text("```\npip install sub/knn\npip install -e .\n```\n", encoding="utf-8")
    (tmp_path / "run.py").write_text("import munch\n", encoding="utf-8")
    (tmp_path / "setup.py").write_text("from setuptools import setup\nsetup(name='a')\n", encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    _, _, block = text.partition("# The repository's own Python packages")
    assert "--editable .\n" in block  # a project that was read is installed, whatever comes
    _, _, command = block.partition("if [ -e ./sub/knn/")
    command = f"if [ -e ./sub/knn/{command.partition('; fi')[0]}; fi"
    for name in there:
        (tmp_path / "sub/knn").mkdir(parents=True)
        (tmp_path / "sub/knn" / name).touch()
    stand_in = 'python3() { echo "pip $*"; }; pip-cache() { echo --no-cache-dir; };\n'
    done = subprocess.run(["bash", "-c", stand_in + command], cwd=tmp_path, check=True, capture_output=True, text=True)
    assert said in done.stdout
    assert ("--editable ./sub/knn" in done.stdout) == bool(there)


@pytest.mark.parametrize(
    ("goes", "program"),
    [("cd sub/knn\n", "src/train.py"), ("cd demo/sub/knn\ncd sub/knn\n", "src/train.py"), ("", "sub/knn/src/train.py")],
)
def test_a_page_starts_a_program_of_a_submodule(tree: Tree, goes: str, program: str) -> None:
    page = f"# Use\n```\n{goes}python {program} --steps 5\n```\n"
    decision = tree({".gitmodules": MODULES, "README.md": page, "lib/part.py": "import munch\n"})
    assert decision.command_candidates[0] == ("python", "sub/knn/src/train.py", "--steps", "5")
    started = "cd sub/knn && exec python src/train.py --steps 5"
    assert decision.command == (started if goes else decision.command_candidates[0])


def test_a_program_that_nothing_has_is_not_started(tree: Tree) -> None:
    page = "# Use\n```\ncd sub\npython src/train.py\n```\n"
    decision = tree({".gitmodules": MODULES, "README.md": page, "lib/part.py": "import munch\n"})
    assert not decision.command_candidates


def test_a_package_of_a_submodule_is_not_taken_from_the_index_too(tree: Tree) -> None:
    modules = MODULES.replace("sub/knn", "sub/trimesh").replace("knn", "trimesh")
    page = "```\npip install -e sub/trimesh\n```\n"
    found = tree({".gitmodules": modules, "README.md": page, "run.py": "import trimesh\nimport tqdm\n"}).python
    assert found.projects == ("sub/trimesh",)
    assert [each.written for each in found.pip_guessed] == ["tqdm"]


@pytest.mark.parametrize(
    ("file", "cloned"),
    [("ros2_ws/requirements.txt", ()), ("other/requirements.txt", ("sub/knn/build/ros2_ws/requirements.txt",))],
)
def test_a_page_that_goes_back_to_the_root_in_words(tree: Tree, file: str, cloned: tuple[str, ...]) -> None:
    page = "```\ncd sub/knn\nmkdir build\ncd build\ncmake ..\n```\nBack in the main folder:\n"
    page += "```\ncd ros2_ws\npip install -r requirements.txt\n```\n"
    found = tree({".gitmodules": MODULES, "README.md": page, file: "munch==2.0\n", "run.py": "import munch\n"})
    assert found.python.cloned_files == cloned
