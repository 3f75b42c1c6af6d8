"""What a path tells about a file: vendored, documentation, a test, an example."""

from __future__ import annotations

import re
from collections.abc import Container
from functools import cache

from roslab.values.pattern import pattern

_VENDORED = frozenset(
    (
        *("third_party", "third-party", "thirdparty", "third_parties", "third-parties", "thirdparties"),
        *("3rd", "3rdparty", "3rd_party", "3rd-party", "vendor", "vendored", "external", "externals", "extern", "ext"),
        *("deps", "_deps", "submodule", "submodules", "site-packages", "node_modules"),
        *("pybind11", "googletest", "gtest", "contrib", "attic", "deprecated", "archive", "archived", "old", "legacy"),
    )
)
_DOCUMENTATION = frozenset(
    (
        *("doc", "docs", *(f"{name}{number}" for name in ("doc", "docs") for number in range(10)), ".doc", ".docs"),
        *(f".{name}{number}" for name in ("doc", "docs") for number in range(10)),
        *("documentation", "readthedocs", "site", "website", "sphinx", "tutorial", "tutorials", "doxygen"),
    )
)
_TEST = frozenset(
    ("test", "tests", "testing", "ci", ".ci", ".github", ".circleci", "benchmark", "benchmarks"),
)
_EXAMPLE = frozenset(
    f"{name}{plural}" for name in ("example", "demo", "sample", "template", "tutorial") for plural in ("", "s")
)
OF_CI = (".yml", ".yaml")
"""How files of CI end, among those that install or clone something: most often they are for another machine."""
_CI_FILES = (
    ".travis.yml", ".travis.yaml", ".gitlab-ci.yml", "azure-pipelines.yml", "Jenkinsfile",
    "appveyor.yml", ".appveyor.yml", "bitbucket-pipelines.yml", ".drone.yml",
    "circle.yml", ".cirrus.yml", "wercker.yml", "shippable.yml", ".shippable.yml", ".woodpecker.yml", ".build.yml",
)  # fmt: skip
_CI_FOLDERS = pattern(
    r"^(?:\.github/workflows|\.github/actions/[^/]+|\.circleci|\.gitlab(?:-ci)?|\.azure-pipelines|"
    r"\.jenkins|\.ci|\.semaphore|\.buildkite|\.woodpecker|\.builds)/[^/]+\.ya?ml$"
)
_LEFT_BEHIND = pattern(
    r"(?:^|/)(?:old(?:er)?|(?:old|legacy)[_-][\w-]{1,40}|[\w-]{1,40}[_-](?:old|legacy)|legacy|deprecated?(?:[_-][\w-]{1,40})?|"
    r"archived?|attic|obsolete|unused|back-?ups?|bak)/",
    re.IGNORECASE,
)
"""A folder of what its author no longer uses."""
_SCRIPTS = pattern(r"(?:scripts?|notebooks?|tools?|experiments?|benchmarks?)/", re.IGNORECASE)


def vendored(path: str) -> bool:
    """Tell whether a path belongs to vendored code, copied from another project."""
    return not _VENDORED.isdisjoint(_folders(path.rpartition("/")[0]))


def left_behind(path: str) -> bool:
    """Tell whether a path lies in a folder of what its author no longer uses: ``launch/old-launch/a.launch``."""
    return bool(_LEFT_BEHIND.search(path))


def documentation(path: str) -> bool:
    """Tell whether a path lies in a documentation folder."""
    return not _DOCUMENTATION.isdisjoint(_folders(path.rpartition("/")[0]))


def test(path: str) -> bool:
    """Tell whether a path belongs to tests or CI."""
    return not _TEST.isdisjoint(_folders(path.rpartition("/")[0]))


def ci(path: str) -> bool:
    """Tell whether a service of CI reads a file: only at the root, or in a folder of its own there."""
    return path in _CI_FILES or bool(_CI_FOLDERS.match(path))


def example(path: str) -> bool:
    """Tell whether a path belongs to an example."""
    return not _EXAMPLE.isdisjoint(_folders(path.rpartition("/")[0]))


def sample(path: str) -> bool:
    """Tell whether a path belongs to an example or to tests."""
    return example(path) or test(path)


def aside(path: str) -> bool:
    """Tell whether a path belongs to vendored code, an example or tests, and so is no part of the program itself."""
    return vendored(path) or sample(path)


def beside(path: str) -> bool:
    """Tell whether a path belongs to what only lies beside a library: its scripts, notebooks, examples or tests."""
    return bool(_SCRIPTS.match(path)) or sample(path)


@cache
def _folders(folder: str) -> frozenset[str]:
    """Return the names in the path of a folder, which many files share, lower-cased."""
    return frozenset(folder.lower().split("/"))


def innermost(path: str, folders: Container[str]) -> str | None:
    """Return the innermost of some folders that a path lies in or is, ``""`` for the root; ``None`` for none."""
    while path not in folders:
        if not path:
            return None
        path = path.rpartition("/")[0]
    return path
