"""Definition files of Apptainer and Singularity, read as the Dockerfiles that they amount to.

https://apptainer.org/docs/user/latest/definition_files.html, 2026-11-27
"""

from __future__ import annotations

from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_NAME = pattern(r"(?:singularity|apptainer)(?:[-_.].*)?|.*\.(?:def|singularity)")
_NO_DEFINITION = pattern(r".*\.(?:md|rst|txt|sh|py|ya?ml|json|sif|simg|conf|zip|gz|dockerfile|containerfile)")
_BEGINS = pattern(r"(?i)(?:[ \t]*(?:#[^\n]*)?\n|[ \t]*(?!bootstrap\b)\w+[ \t]*:[^\n]*\n){0,40}[ \t]*bootstrap[ \t]*:")
_HEADER = pattern(r"(?i)^[ \t]*(bootstrap|from|osversion|mirrorurl)[ \t]*:[ \t]*(\S+)[ \t]*(?:#.*)?$")
_SECTION = pattern(r"^%(\w+)")
_EXPORT = pattern(r"^[ \t]*export[ \t]+(\w+=(?:\"[^\"]*\"|'[^']*'|\S*))[ \t]*$")
_NOTHING = "#"


def read(repository: Repository) -> list[File]:
    """Return the definition files of the tree: by their names, and by the header that each begins with."""
    names = (name for name in repository.by_name if is_definition(name))
    files = (file for file in repository.named(*names) if 0 < file.size <= MAX_SIZE)
    return [file for file in files if _BEGINS.match(repository.read(file))]


def is_definition(path: str) -> bool:
    """Tell whether a file is named as such a file is."""
    name = path.rpartition("/")[2].lower()
    return bool(_NAME.fullmatch(name)) and not _NO_DEFINITION.fullmatch(name)


def as_dockerfile(text: str) -> str:
    """Return the Dockerfile that a definition amounts to, each line of it in its place.

    All else is a comment there: what tests the image, labels, help, steps on the host, and the files that it takes, for
    no image is made with it.
    """
    section, taken, said = "", [], {}
    lines = text.split("\n")
    started = [line for line in _within("runscript", lines) if line.strip() and not line.lstrip().startswith("#")]
    continued = False
    for line in lines:
        header = _HEADER.match(line) if not section else None
        if opened := _SECTION.match(line):
            section, continued = opened[1].lower(), False
            taken.append(_NOTHING)
        elif header:
            said[header[1].lower()] = header[2]
            taken.append(f"FROM {base}" if header[1].lower() != "bootstrap" and (base := _base(said)) else _NOTHING)
        elif not line.strip() or line.lstrip().startswith("#"):
            taken.append(_NOTHING)
        else:
            taken.append(line if continued else _instruction(section, line, started))
            continued = section == "post" and line.rstrip().endswith("\\")
    return "\n".join(taken)


def _base(said: dict[str, str]) -> str:
    """Return the image of a header, ``""`` where it names none; each is returned once."""
    kind = said.get("bootstrap", "").lower()
    if kind in {"docker", "docker-daemon"} and "from" in said:
        return said.pop("from")
    if kind == "debootstrap" and "ubuntu" in said.get("mirrorurl", "") and "osversion" in said:
        return f"ubuntu:{said.pop('osversion')}"
    return ""


def _instruction(section: str, line: str, started: list[str]) -> str:
    """Return the instruction of one line of a section; of several lines that start a container none is the command."""
    if section == "post":
        return f"RUN {line.strip()}"
    if section == "environment" and (match := _EXPORT.match(line)):
        return f"ENV {match[1]}"
    if section == "runscript" and len(started) == 1:
        return f"CMD {line.strip().removeprefix('exec ')}".removesuffix(' "$@"')
    return _NOTHING


def _within(wanted: str, lines: list[str]) -> list[str]:
    found: list[str] = []
    section = ""
    for line in lines:
        if opened := _SECTION.match(line):
            section = opened[1].lower()
        elif section == wanted:
            found.append(line)
    return found
