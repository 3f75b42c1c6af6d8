"""Packages of the system that code alone asks for."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
GTK = ["gir1.2-gst-plugins-base-1.0", "gir1.2-gtk-3.0"]


@pytest.mark.parametrize(
    ("code", "asked"),
    [
        ("gi.require_version('Gst', '1.0')", ["gir1.2-gstreamer-1.0"]),
        ('gi.require_version("Gtk", "3.0")\ngi.require_version( "GstApp" , "1.0" )', GTK),
        ("gi.require_version('Unheard', '1.0')", []),
        ("asked.require_version(3)", []),
    ],
)
@pytest.mark.parametrize("ros", [False, True])
def test_the_libraries_of_gobject_that_a_program_asks_for(tree: Tree, code: str, asked: list[str], ros: bool) -> None:
    xml = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {"show.py": f"import gi\n{code}\nfrom gi.repository import Gst\n"}
    files |= {"package.xml": xml, "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n"} if ros else {}
    found = tree(files).apt_guessed
    assert [name for name in found if name.startswith("gir1.2")] == asked
