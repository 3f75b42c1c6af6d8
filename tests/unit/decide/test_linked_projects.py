"""Projects of CMake in the tree that the built one links by a bare name are installed before it."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

TOP = "project(walk)\nadd_subdirectory(src)\nadd_executable(walk main.cpp)\ntarget_link_libraries(walk gait OddWords)\n"
ODD = (
    "project(OddWords)\nadd_library(OddWords SHARED words.cpp)\ninstall(TARGETS OddWords EXPORT odd DESTINATION lib)\n"
    "install(EXPORT odd FILE OddWordsConfig.cmake DESTINATION lib/cmake/OddWords)\n"
)
PAGE = "# Walk\n\nUses https://github.com/other/OddWords.\n"


def _planned(root: Path, top: str, odd: str, folder: str) -> str:
    files = {
        "README.md": PAGE,
        "CMakeLists.txt": top,
        "main.cpp": "int main() {}\n",
        "src/CMakeLists.txt": "add_library(gait gait.cpp)\n",
        "src/gait.cpp": "int gait;\n",
        f"{folder}/CMakeLists.txt": odd,
        f"{folder}/words.cpp": "int words;\n",
        f"{folder}/README.md": "From https://github.com/other/OddWords.\n",
    }
    for path, text in files.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    return dockerfile(plan_repository(root).plan)


@pytest.mark.parametrize("folder", ["OddWords", "libs/words"])
def test_a_library_of_the_tree_that_is_linked_by_name_is_installed_first(tmp_path: Path, folder: str) -> None:
    text = _planned(tmp_path, TOP, ODD, folder)
    installs, builds = text.index(f"/{folder} \\\n"), text.index("\n# The program\n")
    assert installs < text.index("install && ldconfig", installs) < builds
    assert "github.com/other/OddWords" not in text  # the copy of the tree comes before that


@pytest.mark.parametrize(
    ("top", "odd"),
    [
        (TOP + "add_subdirectory(OddWords)\n", ODD),  # it is a part of what is built
        (TOP.replace(" OddWords", ""), ODD),
        (TOP, ODD.replace("install(", "# install(")),  # nothing would find it
        (TOP + "add_library(OddWords other.cpp)\n", ODD),
    ],
)
def test_others_are_not(tmp_path: Path, top: str, odd: str) -> None:
    assert "install && ldconfig" not in _planned(tmp_path, top, odd, "OddWords")
