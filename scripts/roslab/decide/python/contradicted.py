"""Packages that the author limits to releases which another one does not work with.

Of most the other one does not say so itself: pip takes such a pair, and what imports that one stops: TensorFlow 2
beside stable-baselines. What is made for one release of a framework says so, and pip refuses another: torch 1.8 beside
torchvision 0.8.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from roslab.decide.decision import Warning_
from roslab.decide.python.bounds import excluded
from roslab.decide.python.undeclared import older
from roslab.decide.reasons import warn
from roslab.knowledge.frameworks import instead_of, last_below, tabled, unstated
from roslab.knowledge.undeclared_limits import undeclared_limits
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version


def contradicted(asked: Iterable[Requirement]) -> Iterator[Warning_]:
    """Yield a warning for each such pair in ``asked``, once, at the line to change, with what to write there."""
    named = [each for each in asked if each.name and not each.url]
    told: set[tuple[str, str]] = set()
    seen: set[tuple[str, str]] = set()
    for each in named:
        for need in _needs(each):
            if (each.key, need.written) in seen:
                continue
            seen.add((each.key, need.written))
            other = _excluding(need, named)
            if other is None or (each.key, other.key) in told:
                continue
            told.add((each.key, other.key))
            place = f" ({each.file}:{each.line})" if each.file else ""
            what = f"{each.written}{place} needs {need.written} but does not say so: {other.written} does not meet it"
            yield warn(f"{what}: what imports {each.name} stops; {_advice(each, need, other)}", other)
    yield from _unmatched(named)


def _unmatched(named: Sequence[Requirement]) -> Iterator[Warning_]:
    """Yield a warning for each package that is pinned to what was made for another release of a pinned framework."""
    from roslab.knowledge.released_with import released_with  # noqa: PLC0415 - few trees name such packages

    pins = {each.key: (each, release) for each in reversed(named) if (release := _pinned(each))}
    for each, release in pins.values():
        framework, of = released_with().get((each.key, release), ("", ""))
        if framework not in pins:
            continue
        other, there = pins[framework]
        if Version(there) == Version(of):
            continue
        fits = [own for (key, own), made in released_with().items() if (key, made) == (each.key, (framework, there))]
        write = f"`{each.name}=={max(fits, key=Version)}`" if fits else f"the release of {each.name} for that one"
        what = f"{each.written} is made for {framework} {of}, and {other.written} is asked for: pip refuses such a pair"
        yield warn(f"{what}, and what the image gets of it may not work; write {write} here", each)


def _pinned(asked: Requirement) -> str:
    """Return the release that a package is pinned to, without its build (``+cu111``), ``""`` where it is not pinned."""
    exact = any(each.operator == "==" and "*" not in each.version for each in asked.specifier)
    return (asked.release or "").partition("+")[0] if exact and not asked.marker else ""


def _needs(asked: Requirement) -> Iterator[Requirement]:
    """Yield the limits that a package needs and that nothing says."""
    found = stated(needs) if (needs := unstated().get(asked.key)) else None
    if found and found.limited:
        yield found
    yield from (known.limit for known in undeclared_limits().get(asked.key, ()) if older(asked, known))


def _excluding(need: Requirement, asked: Sequence[Requirement]) -> Requirement | None:
    """Return what is asked for in no release that a need leaves; a framework's builds are the same package."""
    same = (each for each in asked if tabled(each.key) == tabled(need.key))
    return next((each for each in same if excluded(stated(f"{each.name}{need.specifier}"), (each,))), None)


def _advice(each: Requirement, need: Requirement, other: Requirement) -> str:
    series = last_below(tabled(need.key), need.below) if need.below else None
    python = f", with a Python of {series.python_max} or older (`base.python` in roslab.yaml)" if series else ""
    instead = instead_of(each.key)
    change = f"move the code to {instead}" if instead else f"take a release of {each.name} that is made for it"
    return f"write {other.name}{need.specifier} there{python}, or {change}"
