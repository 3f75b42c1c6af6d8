"""Which of the programs that a README runs is meant by "run it": the order of commands by their pages and headings."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from roslab.decide.absent import variant
from roslab.decide.candidate import LAUNCHERS, Candidate, is_python, program_of
from roslab.decide.chores import without_chores
from roslab.decide.equally_meant import of_whole, without_robot
from roslab.decide.only_launched import launched_alone, only_launched, only_run
from roslab.decide.purposes import of_purpose, of_section
from roslab.decide.reasons import of_readme
from roslab.decide.sections import about_running, shows, starts
from roslab.decide.upkeep import upkeep
from roslab.evidence.prose.runners import SIMULATORS
from roslab.values.dataclass import replace
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

_SERVES = pattern(
    r"(?:^|[_.-])(?:down-?load\w*|convert\w*|conver[st]ion|pre[_-]?proc\w*|(?:comp|calc)\w*[_-](?:\w+[_-])?(?:stat(?:s|istics)|norm\w*)|(?:pre-?)?cach(?:e|ing)|prepare\w*|extract\w*|install\w*|set-?up|format|"
    r"(?:engine|model|weights?|data(?:sets?)?)[_-]generat\w*|"
    r"(?:\w*[^\W\d_]2|(?:2|to)_|(?:onnx|pth?|(?:py)?torch|keras|ckpt|weights?)_?(?:2|to)_?)(?:onnx|trt|tensorrt|engine|tflite|torchscript)|"
    r"record\w*|collect\w*|tokenize\w*|generate\w*|gen|export\w*|annotate\w*|"
    r"get[_-](?:repos?|repositor(?:y|ies)|dep(?:s|endenc(?:y|ies))|submodules?|data(?:sets?)?|weights|models?|assets)|"
    r"(?:add|init\w*|sync|pull)[_-](?:git[_-])?(?:repos?|repositor(?:y|ies)|submodules?)|"
    r"create[_-](?:conda[_-])?(?:v?env|environment)\w*|build|make|compile|config(?!urator)\w*|clone|update|fetch|clean|docker\w*|lint|tidy|udev\w*|stat(?:istic)?s|reset|kill\w*|stop|shut-?down)(?:[_.-]|$)|"
    r"^(?:(?:source|load|activate|export)[_-])?v?env$",
    re.IGNORECASE,
)
"""The name of a program that serves the one that is meant; a configurator is one to work with."""
_INTERFACE = pattern(r"(?:^|[/_.-])(?:v?can\d?|slcan\d?|can2usb)(?:[_.-][\w.-]*)?\.(?:ba)?sh$", re.IGNORECASE)
"""A script of the shell that sets up a CAN bus of the machine, which takes its administrator."""
_DATASET = pattern(r"(?:^|[_.-])(?:datasets?|data)(?:[_.-]|$)", re.IGNORECASE)
"""The name of a file of Python that makes data; a node or a compiled program of that name runs on data."""
_FORMAT = pattern(
    r"(?:_to_|_?2_?)(?:numpy|np[yz]|tf_?records?|hdf5|h5|zarr|csv|json|pickle|pkl|lmdb|coco|kitti|tum|(?:ros)?bag|mcap|rlds|"
    r"lerobot|txt|png|jpe?g|pcd|ply)(?:_?v\d+)?$",
    re.IGNORECASE,
)
"""The name of a file of Python that writes what it reads in another format: ``raw_to_numpy``, ``labelme2coco``."""
_AFTER = pattern(
    r"(?:^|(?<!with)[_.-])(?:calibrat\w*|evaluat\w*|eval|metrics?|plot\w*|bench\w*|profil\w*|check\w*|validat\w*|verif\w*|teleop\w*|keyboard|rqt|rviz2?)(?:[_.-]|$)",
    re.IGNORECASE,
)
"""The name of a program that looks at what another one did, not of what is started with one: ``mapping_with_rviz``."""
_DEVICE = pattern(r"(?:^|(?<=[_.-]))(?:keyboard|joystick|joy|gamepad)(?=[_.-]|$)", re.IGNORECASE)
"""What a program of two is steered with, in their names."""
_EVALUATION = pattern(r"(?:^|[_.-])(?:evaluat\w*|eval)(?:[_.-]|$)", re.IGNORECASE)
_TRAINS = pattern(r"(?:^|[_.-])train\w*?[_-](?:(?:and|n)[_-])?(?:eval\w*|test\w*)(?:[_.-]|$)", re.IGNORECASE)
"""The name of a program that trains first, and then looks at what came of it."""
_ANALYSES = pattern(
    r"(?:^|[_.-])(?:(?:comput|calc|summari|aggregat|gather|merg|average|parse|read|print)\w*[_-](?:\w+[_-])?results?|"
    r"analy[sz](?:e|is|ing))(?:[_.-]|$)",
    re.IGNORECASE,
)
"""The name of a file of Python that counts what others wrote down."""
_OF_RESULTS = pattern(r"(?:eval|evaluat\w*|metrics?)", re.IGNORECASE)
"""The name of a folder whose programs look at what another one made."""
_EVALUATES = pattern(
    r"--?(?:eval(?:uate|uation)?|test)(?:[_-](?:only|net|mode))?|--?only[_-](?:eval|test)", re.IGNORECASE
)
"""An option with which a program looks at what it made before."""
_SHOWS = pattern(
    r"(?:^|[_.-])(?:visuali[sz]\w*|vis|viz)(?:[_.-]|$)|^(?:view|show)[_-]\w|(?<=\w[_.-])viewers?$", re.IGNORECASE
)
"""The name of a file of Python that shows what another one made; a launch file of that name may be a demonstration."""
_TEST = pattern(r"(?:^|[_.-])tests?(?:[_.-]|$)", re.IGNORECASE)
"""The name of a test; a README of Python calls prediction so, and its tests are in folders of their own."""
_CLOUD = pattern(
    r"\b(?:azure|aws|gcp|cloud|clusters?|slurm|kubernetes|singularity|docker(?! container)|colab)\b", re.IGNORECASE
)
"""Sections about somebody else's machines; the container that a page starts it in is what the image makes."""
_DATA = pattern(r"(?:^|=)(?:\.{0,2}/|[\w.-]+/)|\.(?:bag|db3|mcap|pcap|zip|txt|ya?ml|png|mp4|avi|pcd|ply|obj|csv|json)$")
"""An argument that names a file."""
_PLANS = pattern(r"(?:^|/)(?:plans?|specs|superpowers|roadmaps?|backlog)/", re.IGNORECASE)
"""A folder with what is, or was, to be done."""
_HELP = pattern(r"^(?:--?help|-h|--?usage|--?version|--show-args|-s|--self-?(?:test|check))$")
_OF_ROSLAUNCH = frozenset({"--ros-args", "--nodes", "--files", "--dump-params"})
"""Options with which roslaunch prints something and starts nothing: https://wiki.ros.org/roslaunch/Commandline%20Tools"""
_TOPIC = pattern(r"(?!\w*(?:file|path|dir|folder|map|bag|conf|data|world|model|urdf|weight|vocab))\w+:=(?:/\w+)+")
"""An argument that names a topic or a namespace of ROS: ``image:=/camera/color/image_raw``."""
_VALUE = pattern(r"^-{0,2}[\w-]+:?=[-.]*$|^-{3,}$")
"""A value that the reader fills in: ``name:=---``."""
_SUFFIX = pattern(r"\.\w+$")
_HUMP = pattern(r"(?<=[a-z])(?=[A-Z])")


def first_of(candidates: Iterable[Candidate]) -> Candidate | None:
    """Return the command that a page of the author runs first, ``None`` if no page runs any.

    Pages nearer to the root come first, of them the README, then sections about running it, then the order of the
    page. What needs a file that the tree lacks comes after what needs none, except for Python, whose READMEs usually
    name data; another that is given with blanks to fill in comes last, one of Python after what other sections of its
    page run whole; programs that only serve others are never returned, unless pages start one launch file and nothing
    else. What is named like a test is returned where a section about running it has nothing else: the purpose may be to
    test. A quick start may evaluate. Of two calls of a program in one section, the one that needs no file which nothing
    brings. What starts a node that nothing installs comes last, if another is whole.
    """
    candidates = tuple(candidates)
    written = without_chores(c for c in candidates if c.strong and not helps(c) and not upkeep(c))
    written = written or launched_alone(c for c in candidates if not upkeep(c))
    written = [c for c in written if not _explains(c)] or [c for c in written if c.argv[0] not in LAUNCHERS]
    rest = [c for c in written if not _after(c)] or [
        c for c in written if is_python(c) or (_meant(c) > 0 and not _named(c, _AFTER))
    ]
    rest = rest or [c for c in written if _purpose(c)] or only_launched(written) or only_run(written, candidates)
    if before := _before_all(written, rest):
        return before[0]
    whole = {program_of(c.argv) for c in rest if not c.cut}
    pages = {file: place for place, file in enumerate(dict.fromkeys(c.file for c in rest))}
    given = {c.argv for c in rest if _filled_in(c, rest) is not c}
    kept = [replace(c, cut=False) if c.argv in given else c for c in rest]
    kept = [c for c in kept if not c.cut or program_of(c.argv) not in whole]
    gaps: dict[tuple[str, str], int] = {}
    for each in (c for c in kept if c.cut and (is_python(c) or c.installed)):
        section = (each.file, each.heading)
        gaps[section] = min(each.line, gaps.get(section, each.line))
    ordered = sorted(
        kept, key=lambda c: _order(c, pages[c.file], gap=c.line >= gaps.get((c.file, c.heading), c.line + 1))
    )
    ordered.sort(key=lambda c: c.alone and any(_has_master(each, c) for each in kept))
    whole_ones = [c for c in kept if not (c.unmade or c.elsewhere or c.cut or _lacks(c))]
    starts_whole, stands_alone = bool(whole_ones), any(not c.behind and _meant(c) >= 0 for c in whole_ones)
    ordered.sort(
        key=lambda c: (c.elsewhere, _inner(c), starts_whole and c.unmade, _stops(c, kept), stands_alone and c.behind)
    )
    first = without_robot(ordered, _rank) if ordered else None
    return variant(_filled_in(_by_another_device(first, written), rest), rest) if first else None


def _inner(candidate: Candidate) -> bool:
    """Tell whether a command is of those who write the code: a plan runs it, or a file called private, ``_boot.sh``."""
    name = program_of(candidate.argv)[-1].rpartition("/")[2]
    return bool(_PLANS.search(candidate.file)) or (name.startswith("_") and not name.startswith("__"))


def _has_master(launch: Candidate, node: Candidate) -> bool:
    """Tell whether a launch file that the same page starts before a node without a master has one for it."""
    before = launch.file == node.file and launch.line < node.line and launch.argv[0] == "roslaunch"
    return before and not (launch.cut or launch.unmade or launch.behind or _lacks(launch)) and _meant(launch) >= 0


def _stops(candidate: Candidate, others: Iterable[Candidate]) -> bool:
    """Tell whether a program stops without what was left out, and the same page starts another one whole.

    One that may go on without it is only behind a program that is given files of the tree.
    """
    if candidate.demands in {"", "given"}:
        return False
    whole = [c for c in others if c.file == candidate.file and not c.cut and not _lacks(c)]
    whole = [c for c in whole if is_python(c) or c.installed]
    given = (not {*c.files}.isdisjoint(c.argv[len(program_of(c.argv)) :]) for c in whole)
    return bool(whole) if candidate.demands == "required" else any(given)


def _before_all(written: Sequence[Candidate], rest: Sequence[Candidate]) -> list[Candidate]:
    """Return the programs of Python that are named like an evaluation and that a page starts whole before any other.

    A section that starts something has to start them, and nothing else may be whole: no other leaves them its results.
    """
    if any(not c.cut for c in rest):
        return []
    pages = list(dict.fromkeys(c.file for c in written))
    foremost = {c.file: c.line for c in sorted(rest, key=lambda c: -c.line)}
    before = pages[: min(map(pages.index, foremost), default=0)]
    own = [c for c in written if is_python(c) and not c.cut and _after(c) and starts(c.heading)]
    return [c for c in own if c.file in before or c.line < foremost.get(c.file, 0)]


def _filled_in(first: Candidate, candidates: Iterable[Candidate]) -> Candidate:
    """Return the command in which a page gives all that the first leaves to the reader or lacks, else the first."""
    blanks = {*first.blanks, *first.lacking}
    same = (c for c in candidates if program_of(c.argv) == program_of(first.argv) and not (c.cut or c.blanks))
    given = (c for c in same if blanks <= {word.partition(":=")[0] for word in c.argv if ":=" in word})
    return next(given, first) if blanks else first


def _by_another_device(first: Candidate, written: Iterable[Candidate]) -> Candidate:
    """Return what the page runs before the first and has its name but for the device that steers it, else the first."""
    *package, _ = program_of(first.argv)
    name = _stem(program_of(first.argv))
    for each in written if _DEVICE.search(name) else ():
        same = program_of(each.argv)[:-1] == (*package,) and each.file == first.file and each.line < first.line
        if same and not each.cut and _meant(each) >= _meant(first):
            other = _stem(program_of(each.argv))
            if _DEVICE.search(other) and _DEVICE.sub("", other) == _DEVICE.sub("", name):
                return each
    return first


def _explains(candidate: Candidate) -> bool:
    """Tell whether a program only prints its arguments or tests itself: a page that runs it otherwise, too, means that.

    An option with a value does something else: ``-h 480`` is a height.
    """
    if candidate.argv[0] == "roslaunch" and not _OF_ROSLAUNCH.isdisjoint(candidate.argv):
        return True
    words = zip(candidate.argv, (*candidate.argv[1:], "-"), strict=True)
    return candidate.argv[0] not in SIMULATORS and any(_HELP.match(word) and then[:1] == "-" for word, then in words)


def _order(candidate: Candidate, page: int, *, gap: bool) -> tuple[int, ...]:
    """Return the place of a command in the order, ``page`` that of its page; equal ones keep theirs.

    ``gap``: the section left the reader something to fill in up to here, and what it runs later cannot do without.
    """
    python = is_python(candidate) or candidate.installed
    return (
        bool(_CLOUD.search(candidate.heading)),
        candidate.argv[0] == "jupyter",  # of a page that runs programs, too, notebooks explain them
        candidate.cut and not python,
        _lacks(candidate) and not python,
        *_rank(candidate),
        not of_whole(candidate),
        page,
        gap,
        candidate.line,
    )


def _rank(candidate: Candidate) -> tuple[int, int]:
    """Return the place of a command's page and section in the order; pages beside the README come after it."""
    return candidate.file.count("/") - of_readme(candidate.file), -_meant(candidate)


def _meant(candidate: Candidate) -> int:
    """Return 1 for a command that is to be run: its section or the sentence above it says so; -1 for one aside."""
    return 1 if _tried(candidate) else about_running(candidate.heading, python=is_python(candidate))


def _tried(candidate: Candidate) -> bool:
    """Tell whether a page has the reader run it to see whether it works, in a section that is not about that alone."""
    return candidate.tried and about_running(candidate.heading) >= 0


def serves(candidate: Candidate) -> bool:
    """Tell whether a program only serves the one that is meant: it converts, downloads, records, plots."""
    return helps(candidate) or _after(candidate)


def helps(candidate: Candidate) -> bool:
    """Tell whether a program only prepares what the one that is meant needs: it converts, downloads, sets up a bus."""
    found = _found(candidate, _SERVES)
    if _tried(candidate) or (found and (of_purpose(candidate, found[0]) or of_section(candidate))):
        return False
    if _INTERFACE.search(program_of(candidate.argv)[-1]):
        return True
    if found is not None or not is_python(candidate):
        return found is not None
    converts = any(of_purpose(candidate, word) for word in ("convert", "conversion"))
    return _named(candidate, _DATASET) or (_named(candidate, _FORMAT) and not converts)


def _after(candidate: Candidate) -> bool:
    if _tried(candidate):
        return False
    python = is_python(candidate)
    if python and shows(candidate.heading) and _named(candidate, _EVALUATION):
        return False  # of a model that is trained already
    place = program_of(candidate.argv)[-1].rpartition("/")[0].rpartition("/")[2]
    of_results = bool(python and _OF_RESULTS.fullmatch(place))
    of_results = of_results or (python and any(map(_EVALUATES.fullmatch, candidate.argv)))
    if of_results or (python and _named(candidate, _ANALYSES)):
        return True
    if _named(candidate, _TRAINS):
        return False
    if found := _found(candidate, _AFTER) or (python and _found(candidate, _SHOWS)):
        return not of_purpose(candidate, found[0])
    return not (candidate.of_python or python) and _named(candidate, _TEST)


def _purpose(candidate: Candidate) -> bool:
    """Tell whether a node or a launch file has the name of its package: what that is called is what it is for."""
    words = program_of(candidate.argv)
    return words[0] in LAUNCHERS and bare_name(words[-1]).startswith(bare_name(words[-2]))


def _named(candidate: Candidate, names: re.Pattern[str]) -> bool:
    return _found(candidate, names) is not None


def _found(candidate: Candidate, names: re.Pattern[str]) -> re.Match[str] | None:
    return names.search(_stem(program_of(candidate.argv)))


def _stem(words: tuple[str, ...]) -> str:
    """Return the name of a program without its folder and ending, its parts joined by ``_``."""
    name = words[-1].rpartition("/")[2]
    name = name.rpartition(".")[2] if words[1:2] == ("-m",) else _SUFFIX.sub("", name)
    return _HUMP.sub("_", name)


def _lacks(candidate: Candidate) -> bool:
    """Tell whether an argument names a file that the tree does not have, or a value to fill in."""
    arguments = candidate.argv[len(program_of(candidate.argv)) :]
    named = (word for word in arguments if word not in candidate.files and not _TOPIC.fullmatch(word))
    return any(map(_DATA.search, named)) or any(map(_VALUE.match, arguments))
