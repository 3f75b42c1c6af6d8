"""Requirements that pip would refuse or a page takes from git: what is installed instead, and how the rest is."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from functools import cache
from types import MappingProxyType

from roslab.config.model import Kind
from roslab.decide.decision import Warning_
from roslab.decide.python.authors_builds import built
from roslab.decide.python.authors_builds import told as of_build
from roslab.decide.python.bare import bare, without_list
from roslab.decide.python.fetched import cloned_files, lacking
from roslab.decide.python.included_lists import gone, misplaced
from roslab.decide.python.manifests import with_includes
from roslab.decide.python.mistaken import mistaken
from roslab.decide.python.nightlies import dropped
from roslab.decide.python.nightlies import told as of_nightly
from roslab.decide.python.pins import DEVELOPMENT
from roslab.decide.python.pythons import ANY
from roslab.decide.python.too_new import in_python, loosened, told, unmet, written_for_newer
from roslab.decide.python.unread_lines import unread_lines
from roslab.decide.reasons import warn
from roslab.decide.ros.workspace import packages_of
from roslab.evidence import places
from roslab.evidence.facts import Evidence, RequirementFile
from roslab.evidence.python_project import PythonProject
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import ros_modules
from roslab.knowledge.not_on_index import NotOnIndex, not_on_index, of_ros
from roslab.knowledge.short_pins import numbered
from roslab.values.dataclass import dataclass, replace
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.specifier import specifiers
from roslab.values.version import Version

_SHORT = "pip has no {asked}, for its versions have more numbers: {taken} is installed"
_FURTHER = pattern(r"--(?:extra-)?index-url|--find-links")
_PLAIN = pattern(r"\d+(?:\.\d+)*")
NOTHING: Mapping[str, Requirement] = MappingProxyType({})


@dataclass(frozen=True, kw_only=True, slots=True)
class Repaired:
    """Requirements to install by name in place of files and of projects' dependencies."""

    requirements: tuple[Requirement, ...] = ()
    tried: tuple[Requirement, ...] = ()
    """Those of them that are installed one by one where that does not work together."""
    files: frozenset[str] = frozenset()
    """Requirement files that are not installed as they stand."""
    alone: tuple[str, ...] = ()
    """Folders of projects that pip installs without their dependencies."""
    warnings: tuple[Warning_, ...] = ()


def refused(asked: Requirement) -> NotOnIndex | None:
    """Return the table row of a name that pip cannot find or install; ``None`` for all others."""
    row = _row(asked)
    if row is None or asked.url or not ANY.may(asked):
        return None
    same = bool(row.instead) and not row.releases and asked.key.startswith(f"{canonicalize_name(row.instead)}-")
    return None if asked.specifier and same else row


def _row(asked: Requirement) -> NotOnIndex | None:
    return not_on_index().get(asked.key) or of_ros(asked.key)


def in_full(asked: Requirement) -> Requirement:
    """Return what is pinned to the first numbers of a version with more of them as any version that begins so.

    A nightly build that the index has dropped is the stable release of its number, and so is an author's own build.
    """
    if stable := dropped(asked) or built(asked):
        return stable
    row = numbered().get(asked.key)
    pins = [each.version for each in asked.specifier if each.operator == "=="]
    if row is None or len(pins) != 1 or pins[0].count(".") + 2 != row.numbers or pins != [asked.release]:
        return asked
    taken = specifiers(f"=={pins[0]}.*")
    if Version(pins[0]) < row.since or taken is None:
        return asked
    return replace(asked, written=asked.written.replace(f"=={pins[0]}", f"=={pins[0]}.*"), specifier=taken)


def right(requirements: Iterable[Requirement], of_pages: Mapping[str, Requirement] = NOTHING) -> Iterator[Requirement]:
    """Yield what pip can install, with wrong names corrected and with what pages take from git, by name."""
    for asked in map(in_full, requirements):
        row = refused(asked)
        if from_page(asked, of_pages):
            page = of_pages[asked.key]
            extras = f"[{','.join(asked.extras)}]" if asked.extras else ""
            written = f"{asked.name}{extras} @ {page.url}"
            yield replace(page, name=asked.name, written=written, extras=asked.extras, marker=asked.marker)
        elif row is None:
            yield asked
        elif row.instead:
            line = row.instead + (_releases(asked, row.releases) if row.releases else "")
            yield replace(stated(line, asked.origin, asked.file, asked.line), marker=asked.marker, role=asked.role)


def _releases(asked: Requirement, releases: str) -> str:
    """Return what is said of its releases; a pin as one of its major release, as the other may lack this very one.

    Of a repository it is the tag of a pin, and nothing where no version is pinned.
    """
    if "{}" in releases:
        pins = [each.version for each in asked.specifier if each.operator == "==" and _PLAIN.fullmatch(each.version)]
        return f"@{releases.format(pins[0])}" if pins else ""
    said: list[str] = []
    for each in asked.specifier:
        if each.operator == "==" and _PLAIN.fullmatch(each.version):
            said += [f">={each.version}", f"<{int(each.version.partition('.')[0]) + 1}"]
        else:
            said.append(f"{each.operator}{each.version}")
    return ",".join(said)


def elsewhere(evidence: Evidence, kind: Kind, conda: str | None) -> set[str]:
    """Return the names of what pip would refuse and the packages' keys or the ``conda`` environment bring."""
    brought = {package.name for each in evidence.conda if each.file == conda for package in each.packages}
    if kind in {"ros1", "ros2"}:
        keys = (key for manifest in packages_of(evidence).built for key in manifest.dependencies)
        brought |= {key.name for key in keys if key.role not in {"test", "doc"} and key.name in ros_modules()}
    return {name for name in map(canonicalize_name, brought) if name in not_on_index()}


def of_pages(evidence: Evidence, own: Collection[str]) -> dict[str, Requirement]:
    """Return by name what pages, else manifests, have pip take from git, without the names in the tree: its ``own``."""
    found: dict[str, Requirement] = {}
    for asked in evidence.prose_pip:
        aside = asked.file.count("/") > 1 or DEVELOPMENT.search(asked.file)
        if asked.name and asked.vcs and asked.role in {"", "editable"} and asked.key not in own and not aside:
            found.setdefault(asked.key, asked)
    for asked in _of_manifests(evidence):
        if asked.name and asked.vcs and asked.package and asked.key not in own:
            found.setdefault(asked.key, replace(asked, role=""))
    return found


def further_index(option: str) -> bool:
    """Tell whether an option names a place for packages beside, or in place of, pip's index."""
    return bool(_FURTHER.match(option))


def _of_manifests(evidence: Evidence) -> Iterator[Requirement]:
    """Yield what the tree's own manifests ask for, the projects first."""
    yield from (asked for each in evidence.python if not places.vendored(each.file) for asked in each.requirements)
    yield from (asked for file in evidence.requirements if file.purpose == "run" for asked in file.requirements)
    yield from (asked for each in evidence.conda for asked in each.requirements)


def from_page(asked: Requirement, of_pages: Mapping[str, Requirement]) -> bool:
    """Tell whether a page's address stands for a declared name: one without a version, or that pip cannot find.

    That of another manifest stands for one with a version, too, as a list that pip wrote from what was installed from
    git names no address; but not for a package that tables know of the index, which that part wants otherwise.
    """
    if asked.key not in of_pages or asked.url:
        return False
    if of_pages[asked.key].origin in {"manifest", "conda"}:
        return refused(asked) is not None or asked.key not in _tabled()
    return not asked.specifier or refused(asked) is not None


@cache
def _tabled() -> frozenset[str]:
    return frozenset(canonicalize_name(package) for package, _ in imports().values() if package)


def repair(
    evidence: Evidence,
    files: Iterable[RequirementFile],
    projects: Iterable[PythonProject],
    own: Iterable[str],
    python: str | None = None,
    *,
    loose: Mapping[Requirement, Warning_] = MappingProxyType({}),
    in_ros: bool = False,
) -> Repaired:
    """Return how to install what is declared if pip would refuse some of its lines; ``own`` are names in the tree.

    What a page has pip take from git comes from there, too: the index may have another package of that name, or none.
    So it does with a folder (``-e .``): files are installed before the source is there, and pip looks for a folder
    from where it is started (https://pip.pypa.io/en/stable/reference/requirements-file-format/, read 2026-11-23).
    A release that never was for the image's ``python`` gives way to one that was, and so do ``loose`` lines of files.
    Of a list that is for a newer Python than that of ROS the other lines may have no release for it either.
    """
    names = set(own)
    pages = of_pages(evidence, names)
    kept: list[Requirement] = []
    tried: list[Requirement] = []
    broken: set[str] = set()
    alone: list[str] = []
    warnings: list[Warning_] = []
    for file in files:
        found = [asked for each in with_includes(evidence, [file]) for asked in each.requirements]
        spelled = [asked for asked in found if asked.role == "repaired"]
        taken = [asked for asked in found if from_page(asked, pages)]
        missing = [asked for asked in found if refused(asked) and not from_page(asked, pages)]
        if any(map(further_index, file.options)):  # one of ROS's packages for pip, perhaps
            missing = [asked for asked in missing if not of_ros(asked.key)]
        short = [asked for asked in found if in_full(asked) is not asked]
        absent, astray = lacking(evidence, [file]), misplaced(evidence, file)
        unread = unread_lines(evidence, file)
        newer = [each for each in found if each in loose or unmet(each, python) or in_python(each, python)]
        wrong = mistaken(found)
        folders = any(asked.role == "project" for asked in found)
        pinned = [asked for asked in found if asked.url and bare(asked)]
        if not any((spelled, unread, short, taken, missing, absent, astray, newer, wrong, folders, pinned)):
            continue
        found = [asked for asked in found if asked not in wrong]
        broken.add(file.file)
        named = _kept((each for each in loosened(found, python, loose) if each.role != "project"), names, pages)
        kept += named
        for_newer = [*written_for_newer(found, python)] if in_ros else []
        tried += named if spelled or unread or absent or for_newer else []
        text = f"pip would refuse this line; the packages of {file.file} are installed one by one"
        warnings += [*(warn(text, asked) for asked in spelled[:1]), *unread]
        warnings += map(_in_full, short)
        warnings += [*gone(absent, cloned_files(evidence, [file])), *astray]
        warnings += [unfit(asked) for asked in missing if asked.key not in names]
        warnings += [*(loose.get(asked) or told(asked, python) for asked in newer), *for_newer, *wrong.values()]
        warnings += map(without_list, pinned)
    for project in projects:
        found = [asked for asked in project.requirements if asked.role in {"", "source", "member"}]
        taken = [asked for asked in found if from_page(asked, pages)]
        missing = [asked for asked in found if refused(asked) and not from_page(asked, pages)]
        missing = [asked for asked in missing if asked.key not in names]
        newer = [each for each in found if each in loose or unmet(each, python) or in_python(each, python)]
        short = [asked for asked in found if in_full(asked) is not asked]
        wrong = mistaken(found)
        pinned = [asked for asked in found if asked.url and bare(asked)]
        # A role: pip would look for it in the wrong place
        if any((taken, missing, short, newer, wrong, pinned, any(asked.role for asked in found))):
            alone.append(project.folder or ".")
            kept += _kept(loosened((asked for asked in found if asked not in wrong), python, loose), names, pages)
            warnings += [*wrong.values(), *map(without_list, pinned)]
            warnings += [*map(unfit, missing), *map(_in_full, short)]
            warnings += (loose.get(asked) or told(asked, python) for asked in newer)
    return Repaired(
        requirements=tuple(_once(kept)),
        tried=tuple(dict.fromkeys(tried)),
        files=frozenset(broken),
        alone=tuple(alone),
        warnings=tuple(dict.fromkeys(warnings)),
    )


def _once(kept: Iterable[Requirement]) -> Iterator[Requirement]:
    """Yield the requirements, what comes from one address under two spellings of its name once."""
    seen: set[tuple[str, str]] = set()
    for asked in kept:
        if not asked.url or asked.marker or (asked.key, asked.url) not in seen:
            yield asked
        seen.add((asked.key, asked.url))


def untold(guessed: Iterable[Requirement], brought: Collection[str]) -> Iterator[Warning_]:
    """Yield a warning for each guess that pip cannot install and that nothing else, such as conda, has ``brought``."""
    for asked in guessed:
        if (row := refused(asked)) and not row.instead and asked.key not in brought and asked.origin != "import":
            yield unfit(asked)


def _kept(found: Iterable[Requirement], own: set[str], pages: Mapping[str, Requirement]) -> list[Requirement]:
    """Return the requirements without those for packages of the tree itself, or that come from elsewhere."""
    return [asked for asked in right((each for each in found if each.key not in own), pages) if asked.key not in own]


def told_in_full(found: Iterable[Requirement]) -> Iterator[Warning_]:
    """Yield a warning for each of these of which another version is taken than is written."""
    return (_in_full(asked) for asked in found if in_full(asked) is not asked)


def _in_full(asked: Requirement) -> Warning_:
    if stable := dropped(asked):
        return of_nightly(asked, stable)
    if release := built(asked):
        return of_build(asked, release)
    return warn(_SHORT.format(asked=asked.written, taken=in_full(asked).written), asked)


def unfit(asked: Requirement) -> Warning_:
    """Return the warning about a name that pip cannot install, with what is installed in its place."""
    if row := of_ros(asked.key):
        message = f"{row.why}, which its own packages bring and pip does not; it is left out here ({row.source})"
        return warn(f"{asked.key} is not installed by pip: {message}", asked)
    row = not_on_index()[asked.key]
    how = "" if row.why.endswith(" alone") else ", install it with `custom` or `pip` in roslab.yaml"
    without = f"the image is built without it{how} ({row.source})"
    does = f"{row.instead} is installed" if row.instead else without
    return warn(f"pip cannot install {asked.key}: {row.why}; {does}", asked)
