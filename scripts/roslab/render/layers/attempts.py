"""Building a workspace again where it fails in what is cloned: without what the repository does not need."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.plan.ros_build import WORKSPACE
from roslab.render import quote

NEEDED = "build-needed"
"""The script that builds again without packages that are not needed."""
WITHOUT_FAILED = "leave-out-failed"
"""The script that builds again without packages that failed."""
SCRIPTS = (WITHOUT_FAILED, NEEDED)


def tried(plan: Plan) -> str:
    """Return what stands before the command that builds the workspace, ``""`` where all that is cloned is wanted."""
    place = plan.workspace
    in_src = place.folder.startswith(f"{WORKSPACE}/src/")  # without packages of its own all clones are what is wanted
    may_go = place.sources or place.apart or place.may_fail or place.spare
    if not may_go or place.ros is None or place.ros.tool == "rosmake":
        return ""
    if not in_src and place.folder != WORKSPACE:
        return ""
    kept = "".join(f" --keep {quote.shell(name)}" for name in place.must_build)
    own = f"{place.folder.removeprefix(WORKSPACE)}/".removeprefix("/")
    folders = [f"src/{source.name}" for source in place.sources]
    folders += [f"{own}{folder}" for folder in dict.fromkeys((*place.apart, *place.may_fail))]
    spare = f" --most {place.most_spare}" if place.spare else ""
    spare += "".join(f" --spare {quote.shell(f'{own}{folder}')}" for folder in place.spare)
    stops = f" --own {quote.shell(own.rstrip('/'))}" if in_src and place.may_fail and not kept else ""
    without = f"{WITHOUT_FAILED}{kept}{spare}{stops}{''.join(f' {quote.shell(folder)}' for folder in folders)} -- "
    return f"{without}{_needed(plan, kept)}" if in_src and (place.sources or place.apart) else without


def _needed(plan: Plan, kept: str) -> str:
    """Return what builds again without packages of clones and submodules that are not needed, where the first fails."""
    place = plan.workspace
    options = "".join(f" --apart {quote.shell(folder)}" for folder in place.apart) + kept
    options += "".join(f" --tried {quote.shell(source.name)}" for source in place.sources if source.holding)
    return f"{NEEDED}{options} {quote.shell(place.folder.removeprefix(f'{WORKSPACE}/'))} "
