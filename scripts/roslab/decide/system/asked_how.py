"""How the tree asks for what apt installs, as its reason is told."""

from __future__ import annotations

from roslab.evidence.dependency import Dependency

_HOW = {
    "cmake": "find_package asks for {}",
    "pkg-config": "pkg-config asks for {}",
    "link": "{} is linked",
    "include": "{} is included",
    "import": "{} is imported",
    "ros": "the ROS package {} is used",
    "apt": "an install line names {}",
    "rosdep": "the key {} is named",
    "key": "the repository's own list for rosdep names {}",
    "fetch": "a CMake file clones, which needs {}",
    "run": "a CMake file calls a program of {}",
    "configure": "CMake runs a configure that looks for {}",
    "program": "CMake stops without a program of {}",
    "cuda": "CMake compiles for CUDA, which needs {}",
    "called": "a Python file calls a program of {}",
    "latex": "the default command has matplotlib set text by LaTeX, which needs {}",
    "in_script": "the script of the default command calls a program of {}",
    "session_script": "a script of a package, which starts launch files, calls a program of {}",
    "typelib": "a program asks for a library of GObject, which needs {}",
    "backend": "matplotlib draws its windows by a library that needs {}",
    "python3": "a program whose first line asks for Python 3 imports what {} has",
    "python3 elsewhere": "a program whose first line asks for Python 3 imports what {} has",
    "shebang": "the first line of a program names {}",
    "first_line": "the first line of a program that a page runs names one of {}",
    "named": "the page names {}",
    "linked": "a compiled file of the tree is linked with {}",
    "compiled": "a library compiled with the project needs {}",
    "make": "what compiles the project calls {}",
    "script": "a script that the page compiles with names {}",
    "octave": "a program that the page runs needs {}",
}


def how_asked(dependency: Dependency) -> str:
    """Return the words for it, with ``{}`` for its name."""
    return _HOW.get(dependency.role) or _HOW.get(dependency.namespace, "{} is named")
