"""Clones that hold packages which others have too: rosdep finds nothing where two have one name, so one is hidden."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render.layers import shell
from roslab.render.layers.called import with_called
from roslab.render.layers.workspace import WITHOUT_DOUBLES, WS, without_doubles


def before_rosdep(plan: Plan) -> str:
    """Hide such packages of sister repositories before rosdep reads what is cloned; once more before the build.

    Nothing where only one repository is cloned, which lists no others: rosdep reads the repository's own manifests
    apart from it.
    """
    place = plan.workspace
    alone = len(place.sources) + len(place.submodules) == 1 and not any(source.lists for source in place.sources)
    if plan.rosdep is None or place.ros is None or not place.ros.unsure or alone:
        return ""
    scripts = "".join(map(shell.copy_script, with_called([WITHOUT_DOUBLES])))
    run = shell.run(f"cd {WS}", without_doubles(place.ros))
    return f"# Packages that two clones have\nUSER ${{NB_USER}}\n{scripts}{run}\nUSER root"
