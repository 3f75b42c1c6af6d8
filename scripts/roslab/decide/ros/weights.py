"""How much each reason for a source counts."""

from __future__ import annotations


class Weight:
    """Weights of the reasons for a source; sources do not compete, so they only order the report."""

    LISTED = 500  # a vcs file or a clone line
    RECIPE = 400  # the program's own table
    SOUGHT = 100  # a guess that the build tries
    SUBMODULE = 10  # it comes with the checkout and is not cloned
