"""The image's own Python: its version, and whether it is the distribution's, a virtual environment or conda's."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.cuda.version import DEFAULT as CUDA
from roslab.decide.decision import Choice, Reason, Warning_
from roslab.decide.python.base import cuda_ubuntu
from roslab.decide.python.image_python import Manager
from roslab.decide.python.packages import Chosen, choose
from roslab.decide.python.pins import Pin
from roslab.decide.python.pythons import DEFAULT, PREFERRED
from roslab.decide.python.version import Wanted, python_version, read_by
from roslab.decide.python.weights import VersionWeight
from roslab.decide.reasons import because, warn
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.evidence.python import version_file
from roslab.knowledge.days import existed, usual
from roslab.knowledge.distros import distro, python_of_ubuntu, ubuntus_with_python2
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Place

OLDEST = "3.5"
"""The default for code older than any Python 3 that is still in use; what needs Python 2 shows it by its syntax."""
_SURE = VersionWeight.SAID["readme"]
"""From this weight on, a Python that the evidence names is worth a warning if the image has another."""


@dataclass(frozen=True, kw_only=True, slots=True)
class OwnPython:
    """The Python that the image needs, with what is installed for it."""

    version: str | None
    """``None`` for the distribution's Python 3, whichever that is."""
    system: bool
    """It is the distribution's Python: ROS, C++ and plain CUDA programs need no other."""
    wanted: str | None
    """What the repository asks for."""
    chosen: Chosen
    fitting: tuple[str, ...] = ()
    """Those that fit all it says, where nothing names one."""


def decide_version(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    *,
    pins: tuple[Pin, ...],
    ros_distro: str | None,
    cuda: str | None,
) -> Choice[OwnPython]:
    """Return the Python that the image needs; it is decided before the base, which depends on it."""
    chosen = choose(evidence, config, kind, pins, known.ubuntu if (known := distro(ros_distro)) else None)
    said = python_version(evidence, config, pins, chosen.projects, chosen.conda)
    if kind in {"ros1", "ros2"} or _plain(evidence, config, kind, chosen):
        meant = None if _only_bounded(said) else said.answer.version
        number, first = _of_ros(evidence, ros_distro, meant)
        own = OwnPython(version=number, system=True, wanted=said.answer.version, chosen=chosen)
        return Choice(answer=own, reasons=(*first, *said.reasons))
    number = said.answer.version or _then(evidence.day) or _default(config, kind, cuda, _usual(evidence.pip_day))
    if said.answer.version is None and kind != "cpp" and (newer := read_by(evidence, number)):
        said = replace(newer, reasons=(*newer.reasons, *said.reasons))
    wanted = said.answer.version
    number = wanted or number
    own = OwnPython(version=number, system=False, wanted=wanted, chosen=chosen, fitting=said.answer.fitting)
    if wanted:
        return Choice(answer=own, reasons=said.reasons)
    which = f"one that was usual on {evidence.pip_day}" if evidence.pip_day else "the Python of the base"
    why = because("python", number, f"nothing names a version: {which}", weight=VersionWeight.DEFAULT)
    return Choice(answer=own, reasons=(why, *said.reasons))


def of_ubuntu(evidence: Evidence, own: Choice[OwnPython], kind: Kind, ubuntu: str | None) -> Choice[OwnPython]:
    """Return the Ubuntu's own Python where C++ chose the Ubuntu and nothing names another: CMake finds no other.

    A version that a page below the root, CI or a script names is another machine's where nothing is declared for it.
    """
    number = python_of_ubuntu().get(ubuntu or "")
    if kind != "cpp" or number is None or own.answer.system or own.answer.chosen.conda:
        return own
    why = because("python", number, f"nothing names a version: that of {ubuntu}", weight=VersionWeight.DEFAULT)
    if own.answer.wanted and _said_aside(evidence, own):
        why = because("python", number, f"that of {ubuntu}, for which CMake compiles", weight=_SURE)
        return Choice(answer=replace(own.answer, version=number), reasons=(why, *own.reasons))
    if own.answer.wanted:
        if number not in own.answer.fitting:
            return own
        why = because("python", number, f"that of {ubuntu}, and it fits every pin below", weight=VersionWeight.PINS)
    return Choice(answer=replace(own.answer, version=number), reasons=(why, *own.reasons[1:]))


def _said_aside(evidence: Evidence, own: Choice[OwnPython]) -> bool:
    """Tell whether a Python 3 is only named beside a program, in which nothing is declared for it."""
    chosen, best = own.answer.chosen, next(iter(own.reasons), None)
    if best is None or best.weight >= _SURE or chosen.files or chosen.projects or chosen.declared:
        return False
    said = {(m.file, m.line) for m in evidence.mentions if m.topic == "python" and m.value.startswith("3.")}
    return (best.file, best.line) in said and best.file != version_file.NAME


def manager_of(config: Config, kind: Kind, own: OwnPython, ubuntu: str | None) -> Manager:
    """Return the manager of the Python: conda if there is an environment file or the base lacks that version.

    ``ubuntu`` is the base's, ``None`` on Debian, whose image was chosen by its Python.
    """
    if own.system:
        return "system"
    if kind == "cpp" and not own.chosen.conda and own.version == "2.7" and ubuntu in ubuntus_with_python2():
        return "system"  # CMake finds its headers, and C++ that embeds it the packages beside them
    if own.chosen.conda or (own.version or "").startswith("2"):
        return "conda"
    if config.base.image and kind in {"cuda", "python"}:
        ubuntu = config.base.ubuntu  # an image that the author chose has its own Python
    return "venv" if ubuntu is None or python_of_ubuntu().get(ubuntu) == own.version else "conda"


def outvoted(own: Choice[OwnPython], ubuntu: str | None, ros_distro: str | None) -> tuple[Warning_, ...]:
    """Return a warning if the repository clearly asks for another Python than its ROS has."""
    wanted, ours = own.answer.wanted, own.answer.version or python_of_ubuntu().get(ubuntu or "")
    best = next(iter(own.reasons), None)
    if not (own.answer.system and ros_distro and wanted and ours and best) or wanted == ours:
        return ()
    if not best.decisive or best.weight < _SURE:
        return ()
    message = f"Python {wanted} is asked for: {best.reason}; the Python of ROS {ros_distro} is {ours}, and what pip"
    message += " brings is installed for that one"
    return (warn(message, Place(file=best.file, line=best.line) if best.file else None),)


def _plain(evidence: Evidence, config: Config, kind: Kind, chosen: Chosen) -> bool:
    """Tell whether it is a compiled program without any Python of its own."""
    installs = chosen.files or chosen.projects or chosen.declared or chosen.guessed or chosen.conda
    if config.base.python or config.pip or config.pip3 or evidence.programs:
        return False
    return kind == "cpp" or (kind == "cuda" and not installs)


def _of_ros(evidence: Evidence, ros_distro: str | None, said: str | None) -> tuple[str | None, tuple[Reason, ...]]:
    """Return Python 2 if the distribution's nodes run on it, and why; ``None`` for Python 3.

    They do if the author says so, or says nothing and starts a node by that number, or a program by ``python``, which
    is Python 2 there.
    """
    known = distro(ros_distro) if ros_distro else None
    if known is None or known.ros != 1 or not known.python.startswith("2"):
        return None, ()
    if said:
        return (known.python if said == known.python else None), ()
    node = next((d for d in evidence.code if d.role == "shebang" and not places.vendored(d.file)), None)
    numbered = next((each for each in evidence.mentions if each.topic == "python2_node"), None)
    if numbered is not None:
        why = f"the first line of a node starts {numbered.value}"
        return known.python, (because("python", known.python, why, numbered, weight=VersionWeight.DEFAULT),)
    if node is None:
        return None, ()
    why = f"its first line starts `python`, which is Python 2 on ROS {known.name}"
    return known.python, (because("python", known.python, why, node, weight=VersionWeight.DEFAULT),)


def _only_bounded(said: Choice[Wanted]) -> bool:
    """Tell whether nothing names a Python or asks for a newer one: what the code uses is gone from the newest alone."""
    return bool(said.answer.fitting) and all(each.answer.startswith(("<", "≤")) for each in said.reasons[1:])


def _then(day: str | None) -> str | None:
    """Return the preferred Python of a day on which the default was not there yet."""
    if day is None or existed(DEFAULT, day):
        return None
    return next((python for python in PREFERRED if existed(python, day)), None)


def _usual(day: str | None) -> str:
    """Return the default, or for packages of a day the preferred Python among those that had wheels then."""
    if day is None:
        return DEFAULT
    return next((python for python in PREFERRED if usual(python, day)), OLDEST)


def _default(config: Config, kind: Kind, cuda: str | None, default: str) -> str:
    """Return the Python of the base: of the CUDA image's Ubuntu, of the configured one, else the default."""
    ubuntu = cuda_ubuntu(cuda or CUDA, config.base.ubuntu, default) if kind == "cuda" else config.base.ubuntu
    return python_of_ubuntu().get(ubuntu or "", default)
