"""``dataclasses`` with methods that are shared, for the quick start of a program with many small values.

The standard module compiles six methods for each class and imports what inspects source code: two fifths of the time
of a plan with Python 3.11 (``benchmarks/plan.py``). What a decorated class does is the same: fields, ``replace``,
``asdict``, keywords alone or not, equality and hash by the compared fields, no assignment to what is frozen. The
standard functions take its values too. Only ``slots`` is not followed: it would need a second class.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import attrgetter
from typing import TYPE_CHECKING, Any

__all__ = ["Field", "asdict", "dataclass", "field", "fields", "is_dataclass", "replace"]

_HASH = "__hash__"
"""Where a value keeps its hash, among its fields, of which none has such a name."""

if TYPE_CHECKING:  # the checker takes them for the standard ones
    from dataclasses import Field, asdict, dataclass, field, fields, is_dataclass, replace
else:

    class Field:
        """A field of a class: its name, the text of its type, its default, and what it takes part in."""

        __slots__ = ("compare", "default", "default_factory", "init", "name", "repr", "type")

        def __init__(self, default: Any, default_factory: Any, init: bool, repr_: bool, compare: bool) -> None:
            self.name = self.type = ""
            self.default, self.default_factory = default, default_factory
            self.init, self.repr, self.compare = init, repr_, compare

    def field(
        *,
        default: Any = ...,
        default_factory: Callable[[], Any] | None = None,
        init: bool = True,
        repr: bool = True,  # noqa: A002 - the standard names
        compare: bool = True,
    ) -> Any:
        """Return what stands behind a field's name in a class; ``...`` is no default."""
        return Field(default, default_factory, init, repr, compare)

    def dataclass(
        cls: type | None = None, /, *, frozen: bool = False, eq: bool = True, kw_only: bool = False, slots: bool = False
    ) -> Any:
        """Add to a class what its fields call for; with keywords alone, return the decorator that does so.

        Raises ``ValueError`` for a default that could be changed, ``TypeError`` for a default of no field.
        """
        del slots

        def decorate(cls: type) -> type:
            cls.__record_fields__ = found = _fields(cls)
            cls.__record_given__ = tuple(name for name, each in found.items() if each.init)
            cls.__dataclass_fields__ = _Standard()
            cls.__init__ = _init(cls, found, by_position=not kw_only)
            _add(cls, "__repr__", _repr(cls, found))
            if eq:
                key = _key([each.name for each in found.values() if each.compare])
                _add(cls, "__eq__", _eq(key))
                cls.__hash__ = _hash(key) if frozen else None
            _add(cls, "__getstate__", _state)
            if frozen:
                cls.__setattr__ = _frozen
                cls.__delattr__ = _frozen
            return cls

        return decorate(cls) if cls else decorate

    def fields(value: Any) -> tuple[Field, ...]:
        """Return the fields of a class or of a value of it, in the order in which they are written."""
        return tuple(value.__record_fields__.values())

    def is_dataclass(value: Any) -> bool:
        """Return whether a value, or a class, has fields; to ask for the standard ones would make them."""
        return hasattr(value, "__record_fields__")

    def replace(value: Any, /, **changes: Any) -> Any:
        """Return a value of the same class with some fields changed."""
        kept = value.__dict__
        given = {name: kept[name] for name in value.__record_given__}
        given.update(changes)
        return value.__class__(**given)

    def asdict(value: Any) -> Any:
        """Return the fields by name, and so on within them, through tuples, lists and mappings."""
        if is_dataclass(value):
            return {name: asdict(getattr(value, name)) for name in value.__record_fields__}
        if isinstance(value, (list, tuple)):
            return type(value)([asdict(each) for each in value])
        return {key: asdict(each) for key, each in value.items()} if isinstance(value, dict) else value


class _Standard:
    """Stands for the fields of a class as the standard module keeps them, made when it asks."""

    def __get__(self, value: Any, cls: Any) -> Mapping[str, Any]:
        import dataclasses  # noqa: PLC0415 - what this module is there to spare

        def standard(each: Any) -> tuple[str, str, Any]:
            default = dataclasses.MISSING if each.default is ... else each.default
            made: Any = dataclasses.field(
                default=default,
                default_factory=each.default_factory or dataclasses.MISSING,
                init=each.init,
                repr=each.repr,
                compare=each.compare,
            )
            return each.name, each.type, made

        described = [standard(each) for each in cls.__record_fields__.values()]
        twin: Any = dataclasses.make_dataclass(cls.__name__, described, init=False, repr=False, eq=False, kw_only=True)
        cls.__dataclass_fields__ = twin.__dataclass_fields__
        found: Mapping[str, Any] = cls.__dataclass_fields__
        return found


def _fields(cls: type) -> dict[str, Field[Any]]:
    """Return the fields of a class, those of the classes it stands on first; defaults become the class's attributes."""
    found: dict[str, Any] = {}
    for base in reversed(cls.__mro__[1:]):
        found.update(vars(base).get("__record_fields__", {}))
    own = vars(cls)
    for name, annotation in cls.__annotations__.items():
        if "ClassVar" in str(annotation):
            continue
        given = own.get(name, ...)
        each: Any = given if given.__class__ is Field else field(default=given)
        if each.default is not ... and each.default.__class__.__hash__ is None:
            raise ValueError(f"{cls.__qualname__}: the default of {name} could be changed: use default_factory")
        if each is given:
            if each.default is not ...:
                setattr(cls, name, each.default)
            else:
                delattr(cls, name)
        each.name, each.type = name, annotation
        found[name] = each
    for name, given in own.items():
        if given.__class__ is Field:
            raise TypeError(f"{cls.__qualname__}: {name} has no type")
    return found


def _add(cls: type, name: str, method: Callable[..., Any]) -> None:
    """Add a method that the class itself does not have."""
    if name not in vars(cls):
        setattr(cls, name, method)


def _init(cls: type, found: dict[str, Any], *, by_position: bool) -> Callable[..., None]:
    shape: _Shape | None = None  # made with the first value: of most classes no plan makes one

    def __init__(self: Any, /, *words: Any, **given: Any) -> None:  # noqa: N807 - it becomes one
        nonlocal shape
        if shape is None:
            shape = _Shape(cls, found)
        if words:
            named = dict(zip(shape.taken if by_position else (), words, strict=False))
            if len(named) < len(words) or named.keys() & given.keys():
                raise TypeError(f"{cls.__qualname__}: {len(words)} fields by position")
            given |= named
        values = self.__dict__
        values.update(shape.defaults)
        for name, make in shape.factories:
            if name not in given:
                values[name] = make()
        values.update(given)
        all_there = len(values) == shape.number and shape.required <= given.keys()  # quicker than to compare the names
        if not all_there or (shape.refused and not shape.refused.isdisjoint(given)):
            missing, unknown = sorted(shape.required - given.keys()), sorted(given.keys() - set(shape.taken))
            raise TypeError(f"{cls.__qualname__}: missing fields {missing}, unknown fields {unknown}")
        if shape.after:
            shape.after(self)

    return __init__


class _Shape:
    """What the fields of a class say of how a value is made."""

    def __init__(self, cls: type, found: dict[str, Any]) -> None:
        self.defaults = {name: each.default for name, each in found.items() if each.default is not ...}
        self.factories = [(name, each.default_factory) for name, each in found.items() if each.default_factory]
        self.taken = [name for name, each in found.items() if each.init]
        self.required = {name for name in self.taken if not (name in self.defaults or found[name].default_factory)}
        self.number = len(self.required | self.defaults.keys() | {name for name, _ in self.factories})
        self.refused = found.keys() - self.taken
        self.after = getattr(cls, "__post_init__", None)


def _repr(cls: type, found: dict[str, Any]) -> Callable[[Any], str]:
    def __repr__(self: Any) -> str:  # noqa: N807 - it becomes one
        shown = (f"{name}={getattr(self, name)!r}" for name, each in found.items() if each.repr)
        return f"{cls.__qualname__}({', '.join(shown)})"

    return __repr__


def _key(names: list[str]) -> Callable[[Any], Any]:
    """Return what gives the compared fields of a value, one or many."""
    return attrgetter(*names) if names else lambda _: ()


def _eq(key: Callable[[Any], Any]) -> Callable[[Any, Any], Any]:
    return lambda self, other: key(self) == key(other) if other.__class__ is self.__class__ else NotImplemented


def _hash(key: Callable[[Any], Any]) -> Callable[[Any], int]:
    """Return a method that works out the hash of a frozen value once: some hold thousands of others."""

    def __hash__(self: Any) -> int:  # noqa: N807 - it becomes one
        kept: dict[str, Any] = self.__dict__
        if _HASH not in kept:
            kept[_HASH] = hash(key(self))
        found: int = kept[_HASH]
        return found

    return __hash__


def _state(self: Any) -> dict[str, Any]:
    """Return what ``copy`` and ``pickle`` keep of a value: not its hash, which is another one in another process."""
    kept: dict[str, Any] = self.__dict__
    return {name: value for name, value in kept.items() if name != _HASH} if _HASH in kept else kept


def _frozen(self: Any, name: str, *_: Any) -> None:
    from dataclasses import FrozenInstanceError  # noqa: PLC0415 - a bug of ours

    raise FrozenInstanceError(f"{name} of {type(self).__qualname__} is not to be changed")
