"""The distribution of the Ubuntu whose own Python a conda environment asks for: a sign, where nothing names any."""

from __future__ import annotations

from roslab.decide.ros.distro_dates import dated, supported
from roslab.evidence import places
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros_of
from roslab.knowledge.table import row


def by_python(evidence: Evidence, ros: int) -> tuple[str, str, CondaEnvironment] | None:
    """Return the distribution, why, and the environment that has exactly the last Python of an Ubuntu.

    conda's own newest patch is another one; the distribution must have been there at the last commit.
    """
    date = dated(evidence)
    for environment in evidence.conda:
        asked = next((each.release for each in environment.packages if each.name == "python"), None)
        found = row("system_pythons", asked) if asked and not places.aside(environment.file) else None
        for name in distros_of(found["ubuntu"], 1 if ros == 1 else 2)[:1] if found else ():
            if found and (date is None or supported(name, date.value)):
                why = (
                    f"no distribution is named; Python {asked} is that of Ubuntu {found['ubuntu']}, and {name} is there"
                )
                return name, why, environment
    return None
