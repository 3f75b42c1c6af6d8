"""Libraries of the tree that its own script or page copies into the system, and that CMake links by bare names."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
X86 = "\x7fELF\x02\x01\x01" + "\0" * 9 + "\x03\0\x3e\0"
ARM = X86.replace("\x3e", "\x28")  # 32 bits; no text holds the byte of those of 64
FILES = {
    "CMakeLists.txt": "project(a)\nadd_executable(a a.cpp)\ntarget_link_libraries(a acme)\n",
    "a.cpp": "int main() {}\n",
    "sdk/libacme.so": X86,
    "sdk/libacme_io.so.1.2": X86,
    "sdk/other/libacme.a": "",
}
INSTALL = "install -D --mode=755 --target-directory={} {} && ldconfig"
BOTH = "sdk/libacme.so sdk/libacme_io.so.1.2"


@pytest.mark.parametrize(
    ("changed", "commands"),
    [
        ({"install_libs.sh": "sudo cp sdk/libacme.so /usr/lib\ncp sdk/libacme_io.so.1.2 /usr/lib\nsudo ldconfig\n"},
         [INSTALL.format("/usr/lib", BOTH)]),
        ({"README.md": "```\nsudo cp -P ./sdk/libacme*.so* /usr/local/lib/ && sudo ldconfig\n```\n"},
         [INSTALL.format("/usr/local/lib", BOTH)]),
        ({"sdk/setup.sh": "cp $(pwd)/libacme.so \\\n  /usr/lib/x86_64-linux-gnu/\n"},
         [INSTALL.format("/usr/lib/x86_64-linux-gnu", "sdk/libacme.so")]),
        ({"install_libs.sh": "cp $SDK/libacme.so /usr/lib\ncp ../libacme.so /usr/lib\n"}, []),
        ({"install_libs.sh": "cp sdk/libacme.so /opt/acme/lib\n"}, []),
        ({"install_libs.sh": "cp sdk/libacme_io.so.1.2 /usr/lib\n"}, []),
    ],
)  # fmt: skip
def test_what_is_linked_is_copied(tree: Tree, changed: dict[str, str], commands: list[str]) -> None:
    decision = tree({**FILES, **changed})
    assert [script.command for script in decision.scripts] == commands
    assert ("linux/arm64" in dict(decision.platforms_refused)) == bool(commands)


@pytest.mark.parametrize(("library", "refused"), [(f"!<arch>\n{X86}", True), ("!<arch>\n", False), ("", False)])
def test_an_archive_alone_is_of_a_processor_if_it_says_so(tree: Tree, library: str, refused: bool) -> None:
    files = {**FILES, "sdk/libacme.so": "", "sdk/other/libacme.a": library, "install.sh": "cp sdk/other/*.a /usr/lib\n"}
    assert ("linux/arm64" in dict(tree(files).platforms_refused)) == refused


def test_one_for_arm_may_be_among_them(tree: Tree) -> None:
    decision = tree({**FILES, "sdk/libacme_io.so.1.2": ARM, "install.sh": "cp sdk/libacme* /usr/lib\n"})
    assert len(decision.scripts) == 1
    assert decision.platforms_refused == ()


def test_the_plan_of_a_workspace(tmp_path: Path) -> None:
    manifest = "<package><name>a</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    tree_of(tmp_path, {**FILES, "package.xml": manifest, "install.sh": "cp sdk/libacme.so /usr/lib\n"})
    plan = plan_repository(tmp_path).plan
    assert [(each.command, each.copies, each.after) for each in plan.workspace.scripts] == [
        (INSTALL.format("/usr/lib", "sdk/libacme.so"), True, False)
    ]
