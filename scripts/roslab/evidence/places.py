"""What a path tells about a file: vendored, documentation, a test, an example."""

from __future__ import annotations

import re

from roslab.values.pattern import pattern

_VENDORED = pattern(
    r"(?:^|/)(?:third[_-]?part(?:y|ies)|3rd(?:[_-]?party)?|thirdparty|vendor(?:ed)?|externals?|extern|ext|deps|"
    r"submodules?|_deps|site-packages|node_modules|"
    r"pybind11|googletest|gtest|contrib|attic|deprecated|archived?|old|legacy)(?:/|$)",
    re.IGNORECASE,
)
_DOCUMENTATION = pattern(
    r"(?:^|/)(?:\.?docs?\d?|documentation|site|website|sphinx|tutorials?|doxygen)(?:/|$)", re.IGNORECASE
)
_TEST = pattern(r"(?:^|/)(?:tests?|testing|ci|\.ci|\.github|\.circleci|benchmarks?)(?:/|$)", re.IGNORECASE)
_EXAMPLE = pattern(r"(?:^|/)(?:examples?|demos?|samples?|templates?|tutorials?)(?:/|$)", re.IGNORECASE)


def vendored(path: str) -> bool:
    """Tell whether a path belongs to vendored code, copied from another project."""
    return bool(_VENDORED.search(path.rpartition("/")[0]))


def documentation(path: str) -> bool:
    """Tell whether a path lies in a documentation folder."""
    return bool(_DOCUMENTATION.search(path.rpartition("/")[0]))


def test(path: str) -> bool:
    """Tell whether a path belongs to tests or CI."""
    return bool(_TEST.search(path.rpartition("/")[0]))


def example(path: str) -> bool:
    """Tell whether a path belongs to an example."""
    return bool(_EXAMPLE.search(path.rpartition("/")[0]))
