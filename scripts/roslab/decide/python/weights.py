"""What each sign of a Python version, and of a Python package, weighs."""

from __future__ import annotations

from typing import ClassVar


class VersionWeight:
    """How much each reason for a Python version counts: what is run counts more than what is only written."""

    CONDA: ClassVar = {
        0: 80,
        1: 51,
    }  # by folders above it: made to be installed; a page at the root that creates one counts more
    CONDA_DEEP = 20
    BELIEVED = 70  # from here on a version counts although a pinned package has no wheel for it
    REQUIRES = 45  # requires-python of the project
    REQUIRES_BELOW = 35  # of a project in a folder
    WHEEL = 42  # a wheel for one version is named
    VERSION_FILE = 50  # .python-version, which uv and pyenv obey; a page that creates an environment counts more
    SAID: ClassVar = {"readme": 40, "dockerfile": 24, "script": 16, "ci": 12}
    SAID_ELSEWHERE = 8
    DEEPER = 4  # what each folder takes from what is said, up to three
    CREATES = 12  # added for a line that creates an environment with it
    RECOMMENDED = 4  # added where the sentence recommends it among others
    AT_LEAST = 8  # what a sentence loses that names only the oldest one
    PRINT_STATEMENT = 39  # Python 2, unless the classifiers have Python 3
    PINS = 30  # plus the trust of the pin; also for the version that fits all pins
    LOWER_BOUND = 29  # plus the trust of the pin
    USED = 20  # names that the code uses, if no version is named
    IMAGE = 16  # the Python of the Ubuntu that a Dockerfile starts from
    CLASSIFIERS = 10  # hardly anybody keeps them up to date
    DEFAULT = 1


class PackageWeight:
    """What tells that a package is installed, the surest first."""

    CONDA_FILE = 45
    MANIFEST = 40  # a requirements file, a project, and what the build itself needs
    BOUND = 30  # a limit on a package that is installed anyway
    GUESS = 10  # an import, a line of a page
