"""What building packages of ROS 2 needs in a version that pip might replace."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from roslab.decide.decision import Reason
from roslab.decide.python.weights import PackageWeight as Weight
from roslab.decide.reasons import because
from roslab.decide.ros.workspace import packages_of, ros_versions, types
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import kept_for_build_types
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def kept_by_build_types(evidence: Evidence, asked: Sequence[Requirement]) -> Iterator[tuple[Requirement, Reason]]:
    """Yield what building the packages needs in a version that pip might replace, if pip installs anything."""
    named = {each.key for each in asked}
    for manifest in packages_of(evidence).built if asked else ():
        for build_type in sorted(types(manifest, 2)) if 2 in ros_versions(manifest) else ():
            for line, why in kept_for_build_types().get(build_type, ()):
                kept = stated(line, "table", manifest.file, manifest.line)
                if kept.key not in named:
                    named.add(kept.key)
                    yield kept, because("dependencies", line, f"{build_type}: {why}", manifest, weight=Weight.MANIFEST)
