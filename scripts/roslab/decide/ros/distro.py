"""The ROS distribution: evidence is ranked, and keys that the packages declare rule out older distributions."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.day import existed, there
from roslab.decide.decision import Choice, Reason, Warning_
from roslab.decide.reasons import because, configured, ranked, warn
from roslab.decide.ros.addresses import beside_packages
from roslab.decide.ros.by_code import by_code
from roslab.decide.ros.compared import by_comparison
from roslab.decide.ros.complete import complete
from roslab.decide.ros.distro_dates import dated
from roslab.decide.ros.distro_evidence import reasons_for, stale
from roslab.decide.ros.distro_weights import Weight
from roslab.decide.ros.gazebo import by_gazebo, without_library
from roslab.decide.ros.on_machines import on_machines
from roslab.decide.ros.required_versions import with_older
from roslab.decide.ros.source_names import plain
from roslab.decide.ros.workspace import packages_of
from roslab.decide.system.code_fits import misfits, unincluded, unlaunchable
from roslab.decide.system.names import Target
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.ros.conditions import holds
from roslab.knowledge.distros import (
    Distro,
    distro,
    distros,
    distros_of,
    distros_without_image,
    releases_of,
    successor,
)
from roslab.knowledge.libraries import library
from roslab.knowledge.released import released, rosdep_keys
from roslab.values.dataclass import replace
from roslab.values.origin import Place

NAMED_KEYS = 3
"""Most keys that a reason names."""


def decide_distro(evidence: Evidence, config: Config, kind: Kind) -> Choice[Distro | None]:
    """Return the ROS distribution that the repository is made for, ``None`` where it is not ROS."""
    if config.base.ros and (known := distro(config.base.ros.partition("-")[0])):
        said = configured(config, "ros_distro", known.name, "base.ros")
        return Choice(answer=known, reasons=ranked([said, *reasons_for(evidence, known.ros)], known.name))
    if config.base.ros and (later := successor(asked := config.base.ros.partition("-")[0])):
        said = configured(config, "ros_distro", later.name, "base.ros")
        warnings = (warn(_no_image(asked, later), config.origin("base.ros")),)
        return Choice(
            answer=later, reasons=ranked([said, *reasons_for(evidence, later.ros)], later.name), warnings=warnings
        )
    if kind not in {"ros1", "ros2"}:
        return Choice(answer=None)
    ros = 1 if kind == "ros1" else 2
    unknown = _unknown_keys(evidence, ros)
    lacking = misfits(evidence)
    unlaunched, code = unlaunchable(evidence), unincluded(evidence)
    headers = _headers(code, evidence)
    other = without_library(evidence)
    unknown = {n: m | unlaunched.get(n, frozenset()) | other.get(n, frozenset()) for n, m in unknown.items()}
    unknown = {name: missing for name, missing in unknown.items() if existed(evidence, name)} or unknown
    every = [*reasons_for(evidence, ros), *by_gazebo(evidence, ros), *by_comparison(evidence, ros)]
    every += [*on_machines(evidence, ros), *by_code(evidence, ros)]
    named = [reason for reason in there(evidence, every) if not stale(reason, evidence.day)]
    if dated(evidence) and all(_tells_nothing(reason, unknown, evidence) for reason in named):
        named = []
    older = with_older(evidence, ros)
    included = {n: m | headers.get(n, frozenset()) | older.get(n, frozenset()) for n, m in unknown.items()}
    fitted = (_fitted(reason, unknown if _built(reason) else included) for reason in named)
    reasons = [_compiling(reason, lacking) for reason in fitted]
    unknown = included
    if config.base.ubuntu and (fitting := distros_of(config.base.ubuntu, 1 if ros == 1 else 2)):
        inside = [reason for reason in reasons if reason.answer in fitting]
        answer = max(inside, key=_order).answer if inside else fitting[0]
        said = configured(config, "ros_distro", answer, "base.ubuntu")
        return Choice(answer=distros()[answer], reasons=ranked([said, *reasons], answer))
    excluded = {name: frozenset(lacking.get(found.ubuntu, ())) for name, found in distros().items()}
    unknown = {name: missing | excluded[name] for name, missing in unknown.items()}
    reasons += _nearest(reasons, unknown, lacking) or _fitting(reasons, unknown, _declared_keys(evidence, ros))
    if not reasons:
        from roslab.decide.ros.unnamed import of_unnamed  # noqa: PLC0415 - most trees name theirs

        # Nothing says that the rolling of another day is meant
        unknown = {name: missing | code.get(name, frozenset()) for name, missing in unknown.items()}
        return _after_ended(evidence, ros, unknown) or of_unnamed(evidence, kind, unknown)
    best = max(reasons, key=_order)
    if (full := complete(best, reasons, _declared_keys(evidence, ros), evidence)) is not best:
        reasons = [*reasons, full]
        best = full
    if (became := _became(evidence, best, unknown)) is not None:
        reasons = [*reasons, became]
        best = became
    chosen = distros()[best.answer]
    told = _too_new(chosen, lacking) if _moved(chosen.name, lacking) else ()
    return Choice(answer=chosen, reasons=ranked(reasons, chosen.name), warnings=told)


def _tells_nothing(reason: Reason, unknown: dict[str, frozenset[str]], evidence: Evidence) -> bool:
    """Tell whether the date of the last commit tells more: an example, or an address for what is old or lacks a key."""
    weak = unknown.get(reason.answer) or beside_packages(reason.file or "", evidence)
    return reason.weight <= (Weight.ADDRESS if weak else Weight.EXAMPLE)


def _too_new(rolling: Distro, lacking: dict[str, tuple[str, ...]]) -> tuple[Warning_, ...]:
    """Tell what today's rolling does not have, where no date tells which one the code is for."""
    what = lacking.get(rolling.ubuntu, ())[:1]
    advice = "set base.ros in roslab.yaml to the distribution that the code is for"
    return tuple(warn(f"today's ROS {rolling.name} has no {each}: {advice}") for each in what)


def _after_ended(evidence: Evidence, ros: int, unknown: dict[str, frozenset[str]]) -> Choice[Distro | None] | None:
    """Return the nearest distribution with an image to one that is named and never had any, the newest of those."""
    line = tuple(distros_without_image(ros))
    named = [m for m in evidence.mentions if m.topic == "distro" and m.value in line and not places.vendored(m.file)]
    for mention in sorted(named, key=lambda m: line.index(m.value), reverse=True):
        later = successor(mention.value)
        if later and not unknown.get(later.name):
            why = f"{mention.value} is named, which has no image, and {later.name} is the next one"
            warning = warn(_no_image(mention.value, later), Place(file=mention.file, line=mention.line))
            reason = because("ros_distro", later.name, why, mention, weight=Weight.SPEAKS_OF_IT)
            return Choice(answer=later, reasons=(reason,), warnings=(warning,))
    return None


def _no_image(name: str, later: Distro) -> str:
    return f"ROS {name} has no official image and no snapshot of its packages: {later.name}, the next one, is used"


def _became(evidence: Evidence, best: Reason, unknown: dict[str, frozenset[str]]) -> Reason | None:
    """Return what rolling became after the last commit: code of a year ago is for what rolling was then.

    If the code does not compile with that, it is the best distribution that it compiles with.
    """
    date = dated(evidence)
    if date is None or not distros()[best.answer].never_ends:
        return None
    later = _after(date)
    if not later:
        return None
    became = min(later, key=lambda found: found.released).name
    why = f"{best.reason}; the rolling of the last commit, of {date.value}, became {became}"
    past = [found for found in distros().values() if found.ros == 2 and found.eol and found.released <= date.value]
    if evidence.day and past:
        became = max(past, key=lambda found: found.released).name
        why = f"{best.reason}; nothing keeps the rolling of {evidence.day}, when {became} was the newest release"
    lacking = unincluded(evidence)
    fitting = [each for each, missing in unknown.items() if not missing and each not in lacking]
    if unknown.get(became) and fitting:
        lacks = min(unknown[became])
        became = max(fitting, key=_preference)
        why += f", which has no {lacks}; {became} has"
    return because("ros_distro", became, why, date, weight=best.weight + 1)


def _after(date: Mention | None) -> list[Distro]:
    """Return the distributions that were released after a day, which rolling then became."""
    return [d for d in distros().values() if date and d.ros == 2 and d.eol and d.released > date.value]


def _headers(code: dict[str, frozenset[str]], evidence: Evidence) -> dict[str, frozenset[str]]:
    """Return what the code includes and a distribution does not have; of rolling, where today's is meant."""
    past = bool(_after(dated(evidence)))
    return {n: m for n, m in code.items() if not (past and distros()[n].never_ends)}


def _order(reason: Reason) -> tuple[int, int]:
    return reason.weight, distros()[reason.answer].preference


def _preference(name: str) -> int:
    return distros()[name].preference


def _unknown_keys(evidence: Evidence, ros: int) -> dict[str, frozenset[str]]:
    """Return, for each distribution of a ROS version, the declared keys that were only added after it.

    A package needs what its authors' distribution has, so such keys rule out older ones. A key that an older one had
    and this one lacks tells nothing: its package may now be built from source. Rolling's list has gaps, so it rules out
    nothing; nor does a key that begins with the name of a repository that is cloned.
    """
    keys = _declared_keys(evidence, ros)
    line = [name for name, found in distros().items() if found.ros == ros and not found.never_ends]
    later: set[str] = set()
    unknown = {name: frozenset[str]() for name, found in distros().items() if found.ros == ros and found.never_ends}
    for name in sorted(line, key=lambda name: distros()[name].released, reverse=True):
        unknown[name] = frozenset(later - released(name) - _in_apt(evidence, name, later))
        later |= keys & released(name)
    return unknown


def _declared_keys(evidence: Evidence, ros: int) -> frozenset[str]:
    """Return the keys that only a distribution of ROS can have: no package of the tree, no clone, no system library."""
    packages = packages_of(evidence)
    variables = {"ROS_VERSION": str(ros)}
    declared = (d for m in packages.built for d in m.dependencies if d.role != "doc" and holds(d.condition, variables))
    keys = {d.name for d in declared} - packages.names - {source.name for source in evidence.sources} - rosdep_keys()
    cloned = tuple(f"{plain(each.name)}_" for each in evidence.sources if each.kind != "link")
    return frozenset(key for key in keys if library("cmake", key, None) is None and not plain(key).startswith(cloned))


def _in_apt(evidence: Evidence, name: str, keys: set[str]) -> set[str]:
    """Return the keys whose packages for a distribution a page, a script, CI or a Dockerfile installs by apt."""
    said = [*evidence.prose, *(each for authored in evidence.dockerfiles for each in authored.dependencies)]
    lines = {each.name for each in said if each.namespace == "apt"}
    return {key for key in keys if Target(ros_distro=name, ubuntu=None).ros(key) in lines}


def _fitted(reason: Reason, unknown: dict[str, frozenset[str]]) -> Reason:
    """Lower the weight of a distribution without a declared key: its mention is older than the packages."""
    missing = sorted(unknown.get(reason.answer, ()))
    if not missing:
        return reason
    text = f"{reason.reason}; but {reason.answer} has no {', '.join(missing[:NAMED_KEYS])}"
    return replace(reason, reason=text, weight=max(Weight.DEFAULT, reason.weight - Weight.LACKS_A_KEY))


def _compiling(reason: Reason, lacking: dict[str, tuple[str, ...]]) -> Reason:
    """Lower the weight of a distribution that a page or a branch names and whose libraries the code does not fit.

    Where CI or the author's image builds it, the libraries may come from elsewhere, but no CMake that pip lacks too.
    """
    missing = () if _moved(reason.answer, lacking) else lacking.get(distros()[reason.answer].ubuntu, ())
    if _built(reason):
        missing = tuple(what for what in missing if what.startswith("CMake "))
    if not missing:
        return reason
    text = f"{reason.reason}; but {reason.answer} comes without {missing[0]}"
    return replace(reason, reason=text, weight=max(Weight.DEFAULT, reason.weight - Weight.LACKS_A_KEY))


def _built(reason: Reason) -> bool:
    """Tell whether CI or the author's image builds with a distribution: what it lacks may come from elsewhere."""
    return reason.weight > Weight.RECOMMENDED and reason.weight != Weight.BRANCH


def _moved(name: str, lacking: dict[str, tuple[str, ...]]) -> bool:
    """Tell whether it is rolling, and one of its Ubuntus before today's has what the code needs."""
    return distros()[name].never_ends and any(ubuntu not in lacking for ubuntu in releases_of().get(name, ()))


def _nearest(
    reasons: list[Reason], unknown: dict[str, frozenset[str]], lacking: dict[str, tuple[str, ...]]
) -> list[Reason]:
    """Add the distribution released nearest to a named one that the code does not compile with, a newer one first."""
    line = sorted(unknown, key=lambda name: distros()[name].released)
    named = [r for r in reasons if lacking.get(distros()[r.answer].ubuntu) and r.weight <= Weight.DEFAULT]
    fitting = [name for name in line if not unknown[name]]
    if len(named) < len(reasons) or not named or not fitting:
        return []
    place = line.index(max(named, key=_order).answer)
    best = min(fitting, key=lambda name: (abs(line.index(name) - place), line.index(name) < place))
    why = f"of those that the code compiles with, it is the nearest to {line[place]}"
    return [because("ros_distro", best, why, weight=Weight.HAS_EVERY_KEY)]


def _fitting(reasons: list[Reason], unknown: dict[str, frozenset[str]], keys: frozenset[str]) -> list[Reason]:
    """Add the best distribution with every declared key that tells one, if a named one lacks some.

    ``keys``: all that the packages declare; which of them it does not have either, the reason says.
    """
    if not any(unknown.get(reason.answer) for reason in reasons):
        return []
    fitting = [name for name, missing in unknown.items() if not missing]
    if not fitting:
        return []
    best = max(fitting, key=_preference)
    others = sorted(keys - released(best))
    more = f" and {len(others) - NAMED_KEYS} more" if len(others) > NAMED_KEYS else ""
    but = f" but {', '.join(others[:NAMED_KEYS])}{more}" if others else ""
    why = f"it has every key that the packages declare{but}, and the code compiles with its libraries"
    return [because("ros_distro", best, why, weight=Weight.HAS_EVERY_KEY)]
