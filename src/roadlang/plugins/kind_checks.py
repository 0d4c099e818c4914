"""Whether a class is a kind that can work: checked when it is loaded, not when it first fails."""

from __future__ import annotations

import inspect
import re
import sys
from functools import cache
from typing import Any

from ..diagnostics import nearest
from ..diagnostics.nearest import edits
from ..ir.category import AGENTS, OBJECTS, ROLES
from ..ir.units import parse_unit
from ..syntax.words import RESERVED
from .attribution import Reason
from .common_options import common_options
from .kinds import BASES, VERBS, Kind, Signal, base_of, implements
from .option_checks import option_fault
from .options import OptionSchema, schema_of

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z")
_WORDS: dict[str, dict[str, tuple[str, ...]]] = {
    "agent": {"category": ("", *AGENTS), "role": ROLES},
    "object": {"category": OBJECTS},
}
"""The values of attributes of kinds that are words of a list, by verb."""


class KindFault(Reason):
    """What keeps a class from being a kind, with its file and line.

    `kind` is the class as listings call it; `part` names the line: an option, method or attribute.
    """

    def __init__(self, reason: str, cls: type | None = None, part: str = "") -> None:
        place = "" if cls is None else _place_of(cls, part)
        super().__init__(f"{reason} ({place})" if place else reason)
        self.kind = "" if cls is None else _label(cls)


def check_name(name: object, what: str = "the name") -> None:
    """Raises `KindFault` for what cannot be written in a scene file."""
    if not isinstance(name, str) or not _NAME.match(name):
        raise KindFault(f"{what} {name!r} is not a name: use letters, digits and `_`")
    if name in RESERVED:
        raise KindFault(f"{what} `{name}` is a keyword")


def check_kind(cls: Any) -> type[Kind]:
    """The class itself. Raises `KindFault` with what keeps it from being a kind."""
    if not isinstance(cls, type) or not issubclass(cls, Kind) or cls in (Kind, *BASES):
        raise KindFault(f"{cls!r} does not derive from a base class of roadlang.api")
    kind: Any = cls
    _check(kind)
    return cls


@cache
def _check(cls: Any) -> None:
    if cls.verb not in VERBS or not issubclass(cls, base_of(cls.verb)):
        raise KindFault(f"{cls.__name__} has no verb: derive from `Perturber` or another base", cls)
    if not cls.name:
        raise KindFault(f"{cls.__name__} has no `name`", cls)
    try:
        check_name(cls.name, "its name")
    except KindFault as fault:
        raise KindFault(str(fault), cls, "name") from None
    _check_dataclass(cls)
    for option in _options(cls):
        _check_option(cls, option)
    _check_attributes(cls)
    _check_methods(cls)
    _check_spelling(cls)


def _check_dataclass(cls: type[Kind]) -> None:
    annotations = vars(cls).get("__annotations__", {})
    adds = any("ClassVar" not in str(annotation) for annotation in annotations.values())
    params = getattr(cls, "__dataclass_params__", None)
    if params is None or (adds and "__dataclass_params__" not in vars(cls)) or not params.frozen:
        raise KindFault(f"{cls.__name__} is not decorated with `@dataclass(frozen=True)`", cls)


def _options(cls: type[Kind]) -> tuple[OptionSchema, ...]:
    try:
        return schema_of(cls)
    except Exception as error:
        text = f"{error}" if isinstance(error, TypeError) else f"{type(error).__name__}: {error}"
        part = re.search(r"`(\w+)`", text)
        raise KindFault(text, cls, part[1] if part else "") from error


def _check_option(cls: type[Kind], option: OptionSchema) -> None:
    name = option.name
    fault = None
    if not _NAME.match(name) or name in RESERVED:
        fault = "cannot be written in a scene file"
    elif name in {common.name for common in common_options(cls.verb)}:
        fault = f"would hide the option `{name}` that every kind of `{cls.verb}` has"
    elif hasattr(base_of(cls.verb), name):
        fault = f"has the name of an attribute of {base_of(cls.verb).__name__}"
    fault = fault or option_fault(option)
    if fault is not None:
        raise KindFault(f"the option `{name}` of {cls.__name__} {fault}", cls, name)


def _check_attributes(cls: type[Kind]) -> None:
    """Class attributes have the type that the base gives them, and values that mean something."""
    base = base_of(cls.verb)
    for name in _public(base):
        default, value = getattr(base, name), getattr(cls, name)
        if not callable(default) and not _is_like(value, default):
            noun = (
                "a tuple of words" if isinstance(default, tuple) else f"a {type(default).__name__}"
            )
            raise KindFault(f"`{name}` of {cls.__name__} is {value!r}, not {noun}", cls, name)
    if cls.domain not in ("road", "drive"):
        raise KindFault(f'`domain` is {cls.domain!r}, not "road" or "drive"', cls, "domain")
    for name, words in _WORDS.get(cls.verb, {}).items():
        _check_word(cls, name, words)
    options = {option.name for option in schema_of(cls)}
    if cls.rest and cls.rest not in options:
        raise KindFault(f"`rest` is {cls.rest!r}, which is not an option", cls, "rest")
    for attribute in ("lane_options", "sensor_options"):
        for name in getattr(cls, attribute, ()):
            if name not in options:
                reason = f"`{attribute}` has {name!r}, which is not an option"
                raise KindFault(reason, cls, attribute)
    for role in getattr(cls, "reads", ()):
        if role not in ("image", "network", "road"):
            raise KindFault(f'`reads` has {role!r}: "image", "network" or "road"', cls, "reads")
    if issubclass(cls, Signal) and not implements(cls, "dimension_of"):
        try:
            parse_unit(cls.unit)
        except ValueError:
            reason = f"`unit` is {cls.unit!r}, which is not a unit, such as `m` or `m/s^2`"
            raise KindFault(reason, cls, "unit") from None


def _check_word(cls: type[Kind], name: str, words: tuple[str, ...]) -> None:
    value = getattr(cls, name)
    if value not in words:
        meant = nearest(value, words)
        advice = f"did you mean {meant!r}?" if meant else f"use {', '.join(filter(None, words))}"
        raise KindFault(f"`{name}` of {cls.__name__} is {value!r}: {advice}", cls, name)


def _is_like(value: object, default: object) -> bool:
    if isinstance(default, tuple):
        return isinstance(value, tuple) and all(isinstance(item, str) for item in value)
    if isinstance(default, float):
        return isinstance(value, int | float) and not isinstance(value, bool) and value >= 0
    return isinstance(value, type(default))


def _check_methods(cls: type[Kind]) -> None:
    base, required = base_of(cls.verb), cls.required_methods
    if required and not any(implements(cls, name) for name in required):
        reason = f"{cls.__name__} does not implement " + " or ".join(f"`{n}`" for n in required)
        for stranger in _strangers(cls):
            meant = nearest(stranger, required)
            if meant is not None:
                raise KindFault(f"{reason}; `{stranger}`: did you mean `{meant}`?", cls, stranger)
        raise KindFault(reason, cls)
    for name in _public(base):
        if callable(getattr(base, name)) and implements(cls, name):
            _check_method(cls, base, name)


def _check_method(cls: type[Kind], base: type[Kind], name: str) -> None:
    method, default = inspect.getattr_static(cls, name), getattr(base, name)
    if not callable(getattr(cls, name)):
        raise KindFault(f"`{name}` of {cls.__name__} is not a method", cls, name)
    if not inspect.isfunction(method) or not inspect.isfunction(default):
        return  # a class or static method: called through the class
    expected = list(inspect.signature(default).parameters)
    parameters = inspect.signature(method)
    try:
        parameters.bind(*expected)
    except TypeError:
        accepted, passed = ", ".join(parameters.parameters), ", ".join(expected)
        reason = f"`{name}` of {cls.__name__} takes ({accepted}), but is called with ({passed})"
        raise KindFault(reason, cls, name) from None


def _check_spelling(cls: type[Kind]) -> None:
    """What is almost the name of something that the base has would be ignored silently."""
    base = base_of(cls.verb)
    unused = [name for name in _public(base) if getattr(cls, name) is getattr(base, name)]
    for stranger in _strangers(cls):
        meant = next(
            (name for name in unused if len(name) > 3 and edits(stranger, name, 1) == 1), None
        )
        if meant is not None:
            reason = f"{cls.__name__} does not use `{stranger}`: did you mean `{meant}`?"
            raise KindFault(f"{reason} If not, begin its name with `_`", cls, stranger)


def _public(cls: type) -> list[str]:
    return [name for name in dir(cls) if not name.startswith("_")]


def _strangers(cls: type[Kind]) -> list[str]:
    """Public names of the class that neither its base nor its options have."""
    known = {*dir(base_of(cls.verb)), *(option.name for option in schema_of(cls))}
    return [name for name in _public(cls) if name not in known]


def _label(cls: type) -> str:
    verb, name = getattr(cls, "verb", ""), getattr(cls, "name", "")
    return f"{verb} {name}" if verb and name and isinstance(name, str) else cls.__name__


def _place_of(cls: type, part: str) -> str:
    """`acme/kinds.py:12`, from the top-level package on; empty where no source is found."""
    module = sys.modules.get(cls.__module__)
    path = str(getattr(module, "__file__", None) or "").replace("\\", "/").split("/")
    if path == [""]:
        return ""
    file = "/".join(path[-(cls.__module__.count(".") + 1 + (path[-1] == "__init__.py")) :])
    try:
        lines, first = inspect.getsourcelines(cls)
    except (OSError, TypeError):
        return file
    found = re.compile(rf"\s*(def\s+)?{part}\b") if part else None
    inside = (number for number, line in enumerate(lines) if found and found.match(line))
    return f"{file}:{first + next(inside, 0)}"
