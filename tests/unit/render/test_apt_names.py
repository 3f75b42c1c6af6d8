"""Names of packages that apt takes for patterns."""

from __future__ import annotations

import pytest

from roslab.render.layers.shell import apt_install


@pytest.mark.parametrize(
    ("packages", "exact"), [(("cmake", "g++-14"), True), (("libstdc++6",), True), (("cmake", "libeigen3-dev"), False)]
)
def test_a_name_with_a_plus_is_no_pattern(packages: tuple[str, ...], *, exact: bool) -> None:
    assert (" install -oAPT::Cmd::Pattern-Only=true --yes " in apt_install(packages)) is exact
