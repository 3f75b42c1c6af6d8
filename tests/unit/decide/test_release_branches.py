"""What the branches of an install script are for: an Ubuntu or a distribution of ROS."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.dependency import Dependency
from roslab.evidence.prose.release_branches import headed

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
SCRIPT = "release=$(lsb_release -rs)\nif {}; then\n  sudo apt install -y libfoo0\n{}\nfi\n"


@pytest.mark.parametrize(
    ("condition", "rest", "installed"),
    [
        ('[ "$release" = "18.04" ]', "else\n  sudo apt install libbar1", False),
        ('[[ "${release}" == 18.04 ]]', "elif [[ $release == 20.04 ]]; then\n  sudo apt install libbar1", False),
        ('[ "$ROS_DISTRO" = "melodic" ]', "else\n  sudo apt install libbar1", False),
        ('[ "$release" = "18.04" ]', "  sudo apt install libbar1", True),
        ('[ "$release" = "18.04" ] || [ "$release" = "20.04" ]', "else\n  sudo apt install libbar1", True),
        ('[ "$release" != "18.04" ]', "else\n  sudo apt install libbar1", True),
        ('[ "$1" = "install" ]', "else\n  sudo apt install libbar1", True),
        ("[ -d build ]", "else\n  sudo apt install libbar1", True),
    ],
)
def test_packages_for_another_release(tree: Tree, condition: str, rest: str, installed: bool) -> None:
    files = {
        "package.xml": PACKAGE,
        "CMakeLists.txt": "project(demo)\n",
        "README.md": "# Demo\nFor ROS Noetic\n",
        "install.sh": SCRIPT.format(condition, rest),
    }
    decision = tree(files)
    assert decision.ros_distro == "noetic"
    assert ("libfoo0" in decision.apt_guessed) is installed


def test_the_other_branch_stays(tree: Tree) -> None:
    rest = "else\n  if ! dpkg -s git; then\n    sudo apt install git\n  fi\n  sudo apt install libbar1"
    script = SCRIPT.format('[ "$release" = "18.04" ]', rest)
    files = {"package.xml": PACKAGE, "README.md": "# Demo\nFor ROS Noetic\n", "install.sh": script}
    assert "libbar1" in tree(files).apt_guessed


def test_what_more_is_asked_leaves_the_rest_without_a_title() -> None:
    script = SCRIPT.format('[ "$release" = "18.04" ] && [ -d a ]', "else\n  sudo apt install libbar1")
    asked = tuple(
        Dependency(namespace="apt", name=name, strength="prose", file="install.sh", line=line)
        for name, line in (("libfoo0", 3), ("libbar1", 5))
    )
    assert {each.heading for each in headed(asked, script)} == {""}


def test_many_blocks_are_read_once() -> None:
    script = 'if [ "$a" = "18.04" ]; then\n' + "if a; then\n" * 20_000 + "sudo apt install libfoo0\n" * 20_000
    asked = tuple(
        Dependency(namespace="apt", name="libfoo0", strength="prose", file="install.sh", line=20_001 + line)
        for line in (1, 20_000)
    )
    assert {each.heading for each in headed(asked, script)} == {"bionic"}


@pytest.mark.parametrize(
    "inside",
    [
        "  sudo apt install libfoo0; fi\n",
        "  cat > a.py <<'EOF'\nif a:\n  b\nelse:\n  c\nEOF\nfi\n",
        "  a\nelse sudo apt install libbar1; fi\n",
        "  if a; then b; fi\n  for a in b; do if c; then d; fi; done\n  echo wi fi\nfi\n",
    ],
)
def test_what_follows_a_block_has_no_title(inside: str) -> None:
    script = f'if [ "$release" = "18.04" ]; then\n{inside}sudo apt install libend1\n'
    last = script.count("\n")
    asked = Dependency(namespace="apt", name="libend1", strength="prose", file="install.sh", line=last)
    assert headed((asked,), script) == (asked,)


def test_a_block_of_one_line_stands_in_the_one_around_it() -> None:
    script = (
        'if [ "$release" = "18.04" ]; then\n  for a in b; do if c; then d; fi; done\n  sudo apt install libin1\nfi\n'
    )
    asked = Dependency(namespace="apt", name="libin1", strength="prose", file="install.sh", line=3)
    assert [each.heading for each in headed((asked,), script)] == ["bionic"]
