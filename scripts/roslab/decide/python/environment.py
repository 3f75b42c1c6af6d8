"""Which Python, by which manager, with which packages."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.config.model import Config, Kind
from roslab.decide.cuda.toolkit import by_script, extends_torch
from roslab.decide.decision import Choice
from roslab.decide.python import conda_channels as channels
from roslab.decide.python.agreeing import agreeing
from roslab.decide.python.bare import bare_apart
from roslab.decide.python.bounds import decide_bounds
from roslab.decide.python.by_own_name import with_unknown_modules
from roslab.decide.python.chosen_reasons import reasons_of
from roslab.decide.python.conda_alone import conda_alone
from roslab.decide.python.conda_cuda import cuda_of_conda
from roslab.decide.python.conda_limits import limits_of
from roslab.decide.python.conda_part import conda_part
from roslab.decide.python.conda_pip import of_conda_pip, old_pip, pip_below
from roslab.decide.python.contradicted import contradicted
from roslab.decide.python.contradicting import contradicting
from roslab.decide.python.extension_code import decide_defines
from roslab.decide.python.extras import beside_lists
from roslab.decide.python.fetched import cloned_files, unseen
from roslab.decide.python.first import first_and_guesses, isolated
from roslab.decide.python.fitting_tags import fitting_tags
from roslab.decide.python.framework_pins import framework_pins, one_build
from roslab.decide.python.given_releases import Loose, gives_way
from roslab.decide.python.gone_lists import gone_lists
from roslab.decide.python.gpu_projects import asking, left_to_gpus
from roslab.decide.python.ignored_environments import ignored_environments
from roslab.decide.python.image_python import Python
from roslab.decide.python.imported_submodules import may_fail, unread
from roslab.decide.python.indexes import file_options, indexes_of
from roslab.decide.python.kept_by_build_types import kept_by_build_types
from roslab.decide.python.left_frameworks import left_frameworks
from roslab.decide.python.listed_frameworks import as_listed
from roslab.decide.python.locked import locked_releases, of_what_is_installed
from roslab.decide.python.lost import lost, without_history
from roslab.decide.python.machine_limits import machine_limits
from roslab.decide.python.machine_lists import machine_lists
from roslab.decide.python.manifests import beside, left_to_parts
from roslab.decide.python.named_frameworks import named_frameworks
from roslab.decide.python.native_parts import decide_native_parts
from roslab.decide.python.newer_than_ros import newer_than_ros
from roslab.decide.python.numpy_limit import numpy_limit
from roslab.decide.python.of_manifests import of_manifests, own_names
from roslab.decide.python.old_setuptools import setuptools_of
from roslab.decide.python.older_torch import older_torch, without_release
from roslab.decide.python.other_environments import left_to_others
from roslab.decide.python.other_indexes import consents
from roslab.decide.python.own import OwnPython, manager_of, of_ubuntu, outvoted
from roslab.decide.python.packages import Chosen, with_guess
from roslab.decide.python.pins import Pin, of_conda
from roslab.decide.python.pip_lists import pip_lists
from roslab.decide.python.pythons import interpreter_of
from roslab.decide.python.raised_pins import raised_pins
from roslab.decide.python.refused import Repaired, elsewhere, of_pages, repair, right, untold
from roslab.decide.python.requires import refused_python
from roslab.decide.python.too_new import in_python, loosened
from roslab.decide.python.torch_build import decide_build
from roslab.decide.python.undeclared import undeclared_in
from roslab.decide.python.wheel_pages import fitting_pages
from roslab.decide.ros.python3_nodes import not_for_python3
from roslab.decide.system.cmake_version import from_pip
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import python_of_ubuntu
from roslab.values.dataclass import replace
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement


def decide_python(
    evidence: Evidence,
    config: Config,
    kind: Kind,
    *,
    pins: tuple[Pin, ...],
    own: Choice[OwnPython],
    ubuntu: str | None,
    ros_distro: str | None,
    cuda: str | None,
) -> Choice[Python]:
    """Return the Python part of the image, its manager and its packages, for the chosen Python and base.

    ``ubuntu`` is the base's, ``None`` on Debian; ``cuda`` is the version that the frameworks need.
    """
    own = of_ubuntu(evidence, own, kind, ubuntu)
    chosen, number = _chosen(evidence, config, kind, own.answer, ubuntu, ros_distro=ros_distro), own.answer.version
    alone = conda_alone(evidence, own.answer)
    by_conda = {each.key for each in alone.asked}
    manager = "conda" if alone.specs else manager_of(config, kind, own.answer, ubuntu)
    interpreter = interpreter_of(runs := number or python_of_ubuntu().get(ubuntu or ""))
    lists, conda = pip_lists(config, ubuntu, number), chosen.conda if manager == "conda" else None
    loose = gives_way(evidence, kind, ubuntu, chosen.files, lists.requirements, manager=manager, python=runs)
    repaired = _repaired(evidence, chosen, runs, elsewhere(evidence, kind, conda), loose, ros_distro)
    manifests = [*loosened(of_manifests(evidence, chosen), runs, loose)]
    pixi = channels.by_specs(evidence, chosen.conda)
    part = conda_part(evidence, chosen, number, by_file=conda is not None and not pixi, by_name=repaired.files)
    declared = [*lists.requirements, *repaired.requirements, *part.declared]
    kept = dict(kept_by_build_types(evidence, [*declared, *chosen.guessed, *manifests]))
    declared, guessed = bare_apart([*declared, *kept], chosen.guessed)
    chosen = replace(chosen, guessed=guessed)
    extended = kind == "cuda" and manager != "system" and (extends_torch(evidence, chosen) or bool(by_script(evidence)))
    aged = older_torch((pin.requirement for pin in pins), cuda) if extended else None
    chosen = replace(chosen, guessed=without_release(chosen.guessed)) if aged else chosen
    named = named_frameworks(chosen.guessed if manager != "system" else (), number)
    declared += named.answer.first
    chosen = replace(chosen, guessed=tuple(each for each in chosen.guessed if each not in named.answer.first))
    everything = [asked for asked in (*declared, *chosen.guessed, *manifests) if interpreter.may(asked)]
    # The distribution's own packages are old enough: only what pip chooses needs a bound
    exact = framework_pins(pins if manager != "system" else (), everything, cuda, number, evidence.pip_day)
    conda_asked = [asked for each in evidence.conda if each.file == chosen.conda for asked in of_conda(each)]
    installed_by_conda = conda_asked if manager == "conda" else ()
    bounds = decide_bounds(
        (use for use in evidence.bounds if manager != "system" or use.bound.key != "numpy"),
        (*everything, *exact.answer, *named.answer.limits, *(each for each in installed_by_conda if each.limited)),
    )
    wheels = (
        _without((*exact.answer, *everything), installed_by_conda) if kind == "cuda" and manager != "system" else ()
    )
    locked = evidence.locked if manager != "system" and of_what_is_installed(evidence.locked, chosen) else ()
    build = decide_build(
        evidence,
        chosen,
        wheels,
        cuda,
        number,
        compiled=bool(wheels) and extended,
        aged=bool(aged),
        bounds=bounds.answer,
        locked=locked,
    )
    native = decide_native_parts(everything, chosen.guessed, chosen.projects, evidence.pip_day)
    made = (*exact.answer, *named.answer.limits, *build.answer[0], *native.answer.bounds)
    bounds = agreeing(bounds, made, number)
    limits = (*bounds.answer, *made)
    defines = decide_defines(evidence, chosen.projects, (*everything, *limits), number, aged)
    of_lock = locked_releases(locked, manifests, (*named.answer.first, *limits), number, chosen.guessed)
    own_asked = (*everything, *limits, *of_lock.answer) if manager != "system" else ()
    undeclared = undeclared_in(evidence, own_asked, conda, number)
    beside_guesses = machine_limits(evidence, chosen, (*everything, *limits))
    limits = (*limits, *of_lock.answer, *undeclared.answer.pip, *beside_guesses.answer)
    numpy = numpy_limit(
        evidence,
        kind,
        ubuntu,
        everything,
        limits=limits,
        of_conda=conda_asked,
        python=number,
        system=manager == "system",
    )
    indexes = [
        *indexes_of([*declared, *chosen.guessed, *manifests, *exact.answer], chosen.files),
        *(asked.written for asked in (pixi.requirements if pixi else ()) if asked.role == "option"),
    ]
    whole = [file for file in chosen.files if file.file not in repaired.files]
    older = setuptools_of((*everything, *conda_asked, *limits) if manager != "system" else ())
    in_conda, held = limits_of(evidence, conda, kind, own.answer), (*everything, *limits, *installed_by_conda)
    chosen = replace(chosen, guessed=tuple(each for each in chosen.guessed if not in_python(each, runs)))
    compiled_first, guessed = first_and_guesses(
        (*declared, *manifests, *native.answer.brought), chosen, interpreter, cmake=manager != "system"
    )
    options = fitting_pages(
        (
            *indexes,
            *build.answer[1],
            *file_options(
                evidence,
                chosen,
                repaired,
                by_name=bool(compiled_first or declared or chosen.guessed or chosen.projects),
            ),
            *chosen.options,
        ),
        (*limits, *everything),
    )
    answer = Python(
        version=number,
        manager=manager,
        day=evidence.pip_day if everything or lists.python2 or chosen.built_with else None,
        interpreter=interpreter,
        pip=tuple(dict.fromkeys(fitting_tags(declared, held, evidence.pip_day))),
        pip_tried=tuple(fitting_tags(repaired.tried, held, evidence.pip_day)),
        pip_guessed=tuple(
            dict.fromkeys((*one_build(fitting_tags(right(guessed), held, evidence.pip_day), cuda), *part.tried))
        ),
        by_name=chosen.by_name,
        requirements=tuple(file.file for file in whole),
        beside_files=beside_lists(right(chosen.guessed), whole),
        cloned_files=cloned_files(evidence, chosen.files),
        manifests=beside(evidence, whole, conda),
        projects=tuple(project.folder or "." for project in chosen.projects),
        unseen=unseen(evidence, chosen.projects),
        gpu_asked=asking(evidence, kind),
        imported=may_fail(chosen.projects, unseen(evidence, chosen.projects)),
        alone=repaired.alone,
        isolated=isolated(chosen.projects, compiled_first),
        conda_file=conda,
        conda_specs=(pixi.specs or pixi.on_linux) if pixi else alone.specs,
        conda_channels=(*channels.by_name(pixi, alone), *channels.further_channels(evidence, conda)),
        conda_local=part.local,
        conda_pip=part.others,
        conda_flow=channels.in_brackets(evidence, conda),
        conda_instead=part.instead,
        conda_no_channels=channels.no_channels(evidence, conda),
        conda_old_pip=old_pip(evidence, conda),
        conda_pip_below=pip_below(evidence, conda),
        conda_limits=(*in_conda.answer, *undeclared.answer.conda),
        conda_cuda=cuda_of_conda(evidence, kind, conda, cuda) if conda or alone.specs else "",
        setuptools=older.answer,
        conda_defaults=not pixi and channels.default_channels(evidence, conda),
        first=compiled_first,
        defines=defines.answer,
        bounds=(*limits, *numpy.answer),
        options=options.answer,
        pip_options=lists.options,
        python2=lists.python2,
        python2_options=lists.python2_options,
        native_parts=native.answer.parts,
        compiled_modules=native.answer.modules,
    )
    return Choice(
        answer=answer,
        reasons=(
            *own.reasons,
            *reasons_of(chosen, alone.asked),
            *of_conda_pip(answer),
            *kept.values(),
            *bounds.reasons,
            *exact.reasons,
            *named.reasons,
            *build.reasons,
            *numpy.reasons,
            *older.reasons,
            *in_conda.reasons,
            *of_lock.reasons,
            *undeclared.reasons,
            *beside_guesses.reasons,
            *native.reasons,
        ),
        warnings=(
            *channels.told(answer, evidence),
            *outvoted(own, ubuntu, ros_distro),
            *newer_than_ros(evidence, ubuntu, ros_distro),
            *refused_python(runs, chosen.projects),
            *not_for_python3(evidence, ros_distro),
            *repaired.warnings,
            *defines.warnings,
            *lists.warnings,
            *native.warnings,
            *bounds.warnings,
            *numpy.warnings,
            *options.warnings,
            *untold(chosen.guessed, by_conda | own_names(evidence)),
            *left_to_gpus(evidence, kind),
            *left_frameworks(evidence, kind, everything),
            *lost(evidence, kind, chosen, ubuntu if manager == "system" else None, ros_distro, brought=by_conda),
            *unread(chosen.projects),
            *(() if config.compatible else without_history(evidence)),
            *consents(chosen.guessed, evidence),
            *part.warnings,
            *ignored_environments(evidence, kind, chosen),
            *machine_lists(evidence, chosen.files),
            *(gone_lists(evidence) if kind in {"python", "cuda"} else ()),
            *left_to_parts(evidence, kind, chosen.files),
            *left_to_others(evidence, chosen.files),
            *contradicting(evidence, chosen.files, chosen.contradicting),
            *raised_pins(chosen.files),
            *contradicted((*everything, *installed_by_conda)),
        ),
    )


def _chosen(
    evidence: Evidence, config: Config, kind: Kind, own: OwnPython, ubuntu: str | None, *, ros_distro: str | None
) -> Chosen:
    """Return what was chosen, with what only the chosen Python or base decides."""
    own = replace(own, chosen=as_listed(evidence, own.chosen, own.version))
    chosen = with_unknown_modules(evidence, config, kind, own)
    newer = from_pip(evidence, kind, ubuntu, chosen.projects, ros_distro)
    return with_guess(chosen, newer) if newer else chosen


def _without(asked: Sequence[Requirement], of_conda: Sequence[Requirement]) -> tuple[Requirement, ...]:
    """Return what pip is asked for and conda's own packages do not bring: their build is the file's choice."""
    return tuple(each for each in asked if each.key not in {of.key for of in of_conda})


def _repaired(  # noqa: PLR0917 - what is known of it
    evidence: Evidence, chosen: Chosen, python: str | None, brought: set[str], loose: Loose, ros_distro: str | None
) -> Repaired:
    names = {canonicalize_name(project.name) for project in chosen.projects if project.name}
    names |= brought
    repaired = repair(evidence, chosen.files, chosen.projects, names, python, loose=loose, in_ros=bool(ros_distro))
    more = right(loosened(chosen.declared, python), of_pages(evidence, own_names(evidence)))
    return replace(repaired, requirements=(*repaired.requirements, *more))
