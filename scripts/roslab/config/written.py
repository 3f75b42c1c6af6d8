"""Writes a ``Config`` in today's format from the model alone: the fallback of ``migrate``."""

from __future__ import annotations

from typing import Any

from roslab.config.model import Base, Config, Custom, ProofGoals, ProofLimits, Source
from roslab.values.dataclass import asdict
from roslab.values.yaml import yaml

FOLDERS = {"source": "source", "home": "home", "root": "/"}
"""Today's words for the folders in which custom commands run."""


def written(config: Config) -> str:
    """Return a text in today's format that is read as the same model."""
    python2 = config.pip_python == "2"
    said: dict[str, Any] = {
        "format": 3,
        "compatible": config.compatible,
        "name": config.name,
        "kind": config.kind,
        "date": config.date,
        "pip_date": config.pip_date,
        "base": base(config.base),
        "repo": list(config.repositories),
        "apt": list(config.apt),
        "pip2" if python2 else "pip": _pip(config.pip_options, config.pip),
        "pip3": _pip(config.pip3_options, config.pip3),
        "requirements": _files(config.requirements),
        "conda": config.conda,
        "vcs": _files(config.vcs),
        "source": [_source(source) for source in config.source],
        "build": config.build,
        "build_args": list(config.build_args),
        "cmake_options": config.cmake_options,
        "skip_keys": list(config.skip_keys),
        "skip_packages": list(config.skip_packages),
        "custom": custom(config.custom) if config.custom else None,
        "env": dict(config.env),
        "command": list(config.command) if isinstance(config.command, tuple) else config.command,
        "test": list(config.test) if isinstance(config.test, tuple) else config.test,
        "dockerfile": config.dockerfile,
        "context": config.context,
        "args": dict(config.args),
        "target": config.target,
        "secrets": list(config.secrets),
        "repair": config.repair,
        "lock": config.lock,
        "submodules": config.submodules,
        "tags": _said(config.tags, ("prefix", "suffix")),
        "pr": config.pr,
        "proof": {**_unusual(config.goals), **_unusual(config.proof)},
        "gui": config.gui,
        "gpu": config.gpu,
        "volume": [_said(v, ("host_path", "container_path", "options")) for v in config.volume],
        "ports": list(config.ports),
        "platforms": _files(config.platforms),
        "notebook": config.notebook,
        "slim": config.slim,
        "matlab": _said(config.matlab, ("host_path", "mac_address")) if config.matlab else None,
    }
    kept = {key: value for key, value in said.items() if value is False or value not in (None, "", {}, [])}
    for key in ("requirements", "vcs", "platforms"):
        if said[key] == []:
            kept[key] = []  # an empty list means none, a missing key means undecided
    text: str = yaml.safe_dump(kept, sort_keys=False, allow_unicode=True, width=10_000)
    return text


def base(base: Base) -> dict[str, Any]:
    """Return what the image starts from, in today's format."""
    said = {
        "image": base.image,
        "ubuntu": base.ubuntu,
        "ros": base.ros,
        "opengl": base.opengl,
        "cuda": "-".join(filter(None, (base.cuda, base.cuda_flavour))),
        "cudnn": base.cudnn,
        "python": base.python,
        "icub": "binary" if base.icub else None,
        "cmake_update": base.cmake_update,
    }
    return {key: value for key, value in said.items() if value}


def custom(custom: Custom) -> dict[str, Any]:
    """Return custom commands as a mapping that states explicitly who runs them, where and how."""
    return {
        "user": "root" if custom.as_root else "jovyan",
        "folder": FOLDERS[custom.workdir],
        "chained": custom.chained,
        "commands": list(custom.commands),
    }


def _unusual(settings: ProofLimits | ProofGoals) -> dict[str, Any]:
    """Return the settings that differ from the defaults."""
    usual = asdict(type(settings)())
    return {name: value for name, value in asdict(settings).items() if value != usual[name]}


def _pip(options: tuple[str, ...], lines: tuple[str, ...]) -> list[str]:
    return ([" ".join(options)] if options else []) + list(lines)


def _files(files: tuple[str, ...] | None) -> list[str] | None:
    return None if files is None else list(files)


def _said(thing: object, names: tuple[str, ...]) -> dict[str, Any]:
    """Return the fields that are not empty."""
    said = {name: getattr(thing, name) for name in names}
    return {name: value for name, value in said.items() if value not in (None, "", False, ())}


def _source(source: Source) -> dict[str, Any]:
    names = ("name", "repo", "zip", "ref", "build", "cmake_options", "cmake_folder", "make_command", "keep_source")
    said = _said(source, names)
    return {**said, "depends": list(source.depends)} if source.depends else said
