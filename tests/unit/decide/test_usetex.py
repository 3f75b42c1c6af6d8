"""Text of plots that LaTeX sets."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from trees import decided

Tree = Callable[[dict[str, str]], Decision]
LATEX = {"cm-super", "dvipng", "texlive-fonts-recommended", "texlive-latex-extra"}
RUN = "# A\n```\npython main.py\n```\n"
MAIN = "import matplotlib\nimport matplotlib.pyplot as plt\n{}\nif __name__ == '__main__':\n    plt.plot([1])\n"


def packages(decision: Decision) -> set[str]:
    return {*decision.apt, *decision.apt_guessed} & LATEX


@pytest.mark.parametrize(
    "line",
    [
        "plt.rcParams['text.usetex'] = True",
        'matplotlib.rcParams["text.usetex"]=True',
        "plt.rc('text', usetex=True)",
        "plt.rcParams.update({'font.size': 9, 'text.usetex': True})",
        "plt.rcParams.update({\n    'text.usetex': True,\n})",
        "def style():\n    plt.rc('text', usetex=True)\nstyle()",
    ],
)
def test_the_default_command_has_latex(tree: Tree, line: str) -> None:
    decision = tree({"main.py": MAIN.format(line), "README.md": RUN})
    assert packages(decision) == LATEX
    assert not [each for each in decision.warnings if "LaTeX" in each.message]


@pytest.mark.parametrize(
    "line",
    [
        "# plt.rc('text', usetex=True)",
        "plt.rc('text', usetex=False)",
        "if shutil.which('latex'):\n    plt.rc('text', usetex=True)",
        "def style():\n    plt.rc('text', usetex=True)",
    ],
)
def test_what_sets_nothing(tree: Tree, line: str) -> None:
    decision = tree({"main.py": MAIN.format(line), "README.md": RUN})
    assert not packages(decision)
    assert not [each for each in decision.warnings if "LaTeX" in each.message]


@pytest.mark.parametrize(
    ("path", "said"),
    [
        ("plots.py", "import plots"),
        ("draw/plots.py", "from draw.plots import show"),
        ("draw/plots.py", "from draw import plots"),
        ("draw/plots/__init__.py", "import draw.plots as p"),
        ("src/draw/plots.py", "from draw.plots import show"),
    ],
)
def test_a_module_that_the_command_imports(tree: Tree, path: str, said: str) -> None:
    plots = "import matplotlib as mpl\nmpl.rcParams['text.usetex'] = True\n"
    assert packages(tree({path: plots, "main.py": MAIN.format(said), "README.md": RUN})) == LATEX


def test_a_module_that_python_starts(tree: Tree) -> None:
    page = "# A\n```\npython -m paper.figure\n```\n"
    files = {"paper/figure.py": MAIN.format("plt.rc('text', usetex=True)"), "README.md": page}
    assert packages(tree(files)) == LATEX


@pytest.mark.parametrize("command", ["roslaunch plots draw.launch", "rosrun plots draw.py"])
def test_a_node_that_the_command_starts(tree: Tree, command: str) -> None:
    files = {
        "package.xml": "<package><name>plots</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(plots)\nfind_package(catkin REQUIRED)\n",
        "scripts/draw.py": MAIN.format("import rospy\nplt.rc('text', usetex=True)"),
        "launch/draw.launch": "<launch><node pkg='plots' type='draw.py' name='draw'/></launch>",
        "README.md": f"# A\nROS Noetic\n```\n{command}\n```\n",
    }
    decision = tree(files)
    assert "dvipng" in packages(decision)
    assert not [each for each in decision.warnings if "LaTeX" in each.message]


def test_another_program_is_told(tree: Tree) -> None:
    files = {
        "main.py": MAIN.format(""),
        "paper/figure.py": MAIN.format("plt.rc('text', usetex=True)"),
        "README.md": RUN,
    }
    decision = tree(files)
    assert not packages(decision)
    assert [(each.file, each.line) for each in decision.warnings if "LaTeX" in each.message] == [("paper/figure.py", 3)]


def test_what_a_page_installs_is_not_told(tree: Tree) -> None:
    files = {"main.py": MAIN.format(""), "paper/figure.py": MAIN.format("plt.rc('text', usetex=True)")}
    page = "# A\n```\nsudo apt install texlive-full\npython main.py\n```\n"
    assert not [each for each in tree({**files, "README.md": page}).warnings if "LaTeX" in each.message]


def test_what_roslab_yaml_installs_is_not_told(tmp_path: Path) -> None:
    paper = {"paper/figure.py": MAIN.format("plt.rc('text', usetex=True)")}
    files = {"main.py": MAIN.format(""), **paper, "README.md": RUN}
    decision = decided(tmp_path, files, config=Config(apt=tuple(sorted(LATEX))))
    assert not [each for each in decision.warnings if "LaTeX" in each.message]
