"""Scripts that stop on other releases of Ubuntu than those that they name, and lists of releases in pages."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.evidence.gather import gather
from roslab.evidence.prose import mentions, only_on
from roslab.repository.checkout import Repository

CHAIN = """sudo apt-get install -y cmake
source /etc/lsb-release
if [[ $DISTRIB_CODENAME == *"trusty"* ]] ; then
  if [ -n "$MORE" ]; then
    echo more
  fi
elif [[ $DISTRIB_CODENAME == *"vivid"* ]] ; then
  echo vivid
elif [[ $DISTRIB_CODENAME == *"xenial"* ]]; then
  echo xenial
else
  echo "not supported"
  exit 1
fi
"""


@pytest.mark.parametrize(
    ("script", "ubuntus"),
    [
        (CHAIN, ["xenial"]),
        (CHAIN.replace("  exit 1\n", ""), []),
        (CHAIN.replace("else\n", "fi\nif true; then\n"), []),
        ('version=$(lsb_release -a)\nif [[ $version == *"14.04"* ]]; then\n a\nelse\n exit\nfi\n', ["trusty"]),
        ('if [ "$(lsb_release -sr)" = "18.04" ]; then\n a\nelse\n exit\nfi\n', ["bionic"]),
        ('if [ "$VERSION_ID" != "18.04" ]; then\n a\nelse\n exit\nfi\n', []),
        ('if [ "$1" = "18.04" ]; then\n a\nelse\n exit\nfi\n', []),
        ('if [ "$VERSION" = "1.2" ]; then\n a\nelse\n exit\nfi\n', []),
    ],
)
def test_a_script_that_stops_elsewhere_names_its_ubuntu(script: str, ubuntus: list[str]) -> None:
    assert [said.value for said in only_on.read(script, "build.sh")] == ubuntus


def test_plain_cpp_is_built_on_the_ubuntu_of_its_build_script(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt").write_text("project(a)\nadd_executable(a a.cpp)\n", encoding="utf-8")
    (tmp_path / "a.cpp").write_text("int main() {}\n", encoding="utf-8")
    (tmp_path / "build.sh").write_text(CHAIN, encoding="utf-8")
    assert decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo").base_image == "ubuntu:16.04"


def test_a_list_of_releases_goes_on_after_one_without_long_support() -> None:
    said = mentions.read("* Ubuntu 14.04, 15.04 or 16.04", "README.md", "readme")
    assert [each.value for each in said if each.topic == "ubuntu"] == ["14.04", "16.04"]


@pytest.mark.parametrize(
    ("line", "versions"),
    [
        ("rm -f /usr/local/bin/python3.11", []),
        ("sudo rm -rf /usr/lib/python3.11 && python3.9 run.py", ["3.9"]),
        ("brew unlink python@3.12; brew install python-3.10", ["3.10"]),
        ("alarm python3.8", ["3.8"]),
    ],
)
def test_a_python_that_is_removed_is_none_to_take(line: str, versions: list[str]) -> None:
    said = mentions.read(f"run: |\n  {line}\n", ".github/workflows/ci.yml", "ci")
    assert [mention.value for mention in said if mention.topic == "python"] == versions
