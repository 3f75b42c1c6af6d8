"""``dataclasses.dataclass`` with methods that are shared, for the quick start of a program with many small values.

The standard one compiles six methods for each class: two fifths of the time of a plan with Python 3.11
(``benchmarks/plan.py``). What a decorated class does is the same: fields, ``replace``, ``asdict``, keywords alone,
equality and hash by the compared fields, no assignment to what is frozen. Only ``slots`` is not followed: it would need
a second class.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from operator import attrgetter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass  # noqa: PLC0414 - the checker takes it for the standard one
else:

    def dataclass(*, frozen: bool = False, eq: bool = True, kw_only: bool = False, slots: bool = False) -> Any:
        """Return a decorator for a class whose fields are given by keyword.

        Raises ``TypeError``, as the standard one does, if a class asks for anything else.
        """
        if not kw_only:
            raise TypeError("fields by position are the standard dataclass's")
        del slots

        def decorate(cls: type) -> type:
            # Without methods of its own the standard one compiles nothing
            cls = dataclasses.dataclass(init=False, repr=False, eq=False, kw_only=True)(cls)
            cls.__init__ = _init(cls)
            _add(cls, "__repr__", _repr(cls))
            if eq:
                key = _key([field.name for field in dataclasses.fields(cls) if field.compare])
                _add(cls, "__eq__", _eq(key))
                cls.__hash__ = (lambda self: hash(key(self))) if frozen else None
            if frozen:
                cls.__setattr__ = _frozen
                cls.__delattr__ = _frozen
            return cls

        return decorate


def _add(cls: type, name: str, method: Callable[..., Any]) -> None:
    """Add a method that the class itself does not have."""
    if name not in vars(cls):
        setattr(cls, name, method)


def _init(cls: type) -> Callable[..., None]:
    fields = dataclasses.fields(cls)
    taken = frozenset(field.name for field in fields if field.init)
    defaults = {field.name: field.default for field in fields if field.default is not dataclasses.MISSING}
    factories = [
        (field.name, field.default_factory) for field in fields if field.default_factory is not dataclasses.MISSING
    ]
    required = taken - defaults.keys() - {name for name, _ in factories}
    after = getattr(cls, "__post_init__", None)

    def __init__(self: Any, **given: Any) -> None:  # noqa: N807 - it becomes one
        if not required <= given.keys() or not given.keys() <= taken:
            missing, unknown = sorted(required - given.keys()), sorted(given.keys() - taken)
            raise TypeError(f"{cls.__qualname__}: missing fields {missing}, unknown fields {unknown}")
        values = vars(self)
        values.update(defaults)
        for name, make in factories:
            if name not in given:
                values[name] = make()
        values.update(given)
        if after:
            after(self)

    return __init__


def _repr(cls: type) -> Callable[[Any], str]:
    names = [field.name for field in dataclasses.fields(cls) if field.repr]
    return lambda self: f"{cls.__qualname__}({', '.join(f'{name}={getattr(self, name)!r}' for name in names)})"


def _key(names: list[str]) -> Callable[[Any], Any]:
    """Return what gives the compared fields of a value, one or many."""
    return attrgetter(*names) if names else lambda _: ()


def _eq(key: Callable[[Any], Any]) -> Callable[[Any, Any], Any]:
    return lambda self, other: key(self) == key(other) if other.__class__ is self.__class__ else NotImplemented


def _frozen(self: Any, name: str, *_: Any) -> None:
    raise dataclasses.FrozenInstanceError(f"{name} of {type(self).__qualname__} is not to be changed")
