"""Names of Python packages."""

from __future__ import annotations

import pytest
from packaging.utils import canonicalize_name as standard

from roslab.values.name import canonicalize_name


@pytest.mark.parametrize("name", ["PyYAML", "ruamel.yaml", "a-_.b", "__a__", "A..B", "", "zope.interface-Extra_1"])
def test_a_name_is_compared_as_the_standard_library_of_packaging_does(name: str) -> None:
    assert canonicalize_name(name) == standard(name)
