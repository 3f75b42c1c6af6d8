"""What a library of the table needs in turn is built before it, and what links it is in the image."""

from __future__ import annotations

from collections.abc import Callable

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MADE = "project(demo)\nfind_package(RBDyn 1.2.1 REQUIRED)\nadd_executable(a a.cpp)\n"
PAGE = "Needs [RBDyn](https://github.com/jrl-umi3218/RBDyn)"


def test_what_a_linked_library_needs_comes_before_it(tree: Tree) -> None:
    decision = tree({"CMakeLists.txt": MADE, "a.cpp": "int main() {}\n", "README.md": PAGE})
    assert [source.name for source in decision.source] == ["spacevecalg", "rbdyn"]
    assert all("-DPYTHON_BINDING=OFF" in source.cmake_options for source in decision.source)
    assert not any(source.unread for source in decision.source)
    assert {"libtinyxml2-dev", "libyaml-cpp-dev"} <= {*decision.apt, *decision.apt_guessed}
