"""Options are the fields of a kind: what each is, its default, its bounds, its line of help."""

from __future__ import annotations

import dataclasses
import inspect
import sys
import typing
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cache
from types import SimpleNamespace
from typing import Any

from .annotations import read_annotation
from .option_types import ListType, OptionType, is_of_anything

_KEY = "roadlang"


class _Required:
    def __repr__(self) -> str:
        return "required"


REQUIRED: Any = _Required()


@dataclass(frozen=True, slots=True)
class Constraints:
    """What `option` says in addition to type and default."""

    help: str = ""
    minimum: float | None = None
    maximum: float | None = None
    above: float | None = None
    below: float | None = None
    words: tuple[str, ...] = ()
    example: str = ""
    at_least: int = 0
    if_negative: str = ""

    @property
    def default_unit(self) -> str:
        """The unit in which the option is usually written, as in its example: `mm/h`."""
        first = self.example.split("..")[0]  # of `5m..9m`
        return first.lstrip("0123456789.") if first[:1].isdigit() else ""

    @property
    def least(self) -> float | None:
        """What is not below the minimum: unit conversion leaves the last digit to chance, as `5cm`
        is 0.05 and `0.3ft` is not exact."""
        return None if self.minimum is None else self.minimum - 1e-12 * abs(self.minimum)

    @property
    def most(self) -> float | None:
        """What is not above the maximum, in the same way."""
        return None if self.maximum is None else self.maximum + 1e-12 * abs(self.maximum)

    def allow(self, number: float) -> bool:
        """Whether a number, in SI units, is within the bounds."""
        low, high = self.least, self.most
        return (
            (low is None or number >= low)
            and (high is None or number <= high)
            and (self.above is None or number > self.above)
            and (self.below is None or number < self.below)
        )


@dataclass(frozen=True, slots=True)
class MutableDefault:
    """Stands for a default that could be changed in place; `kind` is its type. It is refused."""

    kind: str


def option(  # noqa: PLR0913 - the words with which authors of plugins describe an option
    default: Any = REQUIRED,
    *,
    help: str = "",
    minimum: float | None = None,
    maximum: float | None = None,
    above: float | None = None,
    below: float | None = None,
    words: Iterable[str] = (),
    example: str = "",
    at_least: int = 0,
    if_negative: str = "",
) -> Any:
    """A field of a kind that a scene file can set.

    `minimum` and `maximum` are allowed values, `above` and `below` are not, all in SI units.
    `words` may be written instead of a value (`auto`); the field then holds the word as a
    string. A list has `at_least` so many items. A `None` default means "not given". `example` is a
    value as a scene file has it; its unit is suggested where a number has none. `if_negative` is
    help for those who write a negative number where none is allowed.
    """
    constraints = Constraints(
        help, minimum, maximum, above, below, tuple(words), example, at_least, if_negative
    )
    metadata = {_KEY: constraints}
    if default is REQUIRED:
        return dataclasses.field(metadata=metadata)
    if type(default).__hash__ is None:
        default = MutableDefault(type(default).__name__)
    return dataclasses.field(default=default, metadata=metadata)


@dataclass(frozen=True, slots=True)
class OptionSchema:
    """One option of a kind, as the checker, the reference page and `roadlang plugins` see it."""

    name: str
    type: OptionType
    default: Any
    constraints: Constraints

    @property
    def required(self) -> bool:
        """Whether a scene file has to set this option."""
        return self.default is REQUIRED

    @property
    def help(self) -> str:
        """One sentence for the reference."""
        return self.constraints.help

    @property
    def words(self) -> tuple[str, ...]:
        """The words that are accepted; empty if any value of the type is."""
        return self.constraints.words


def schema_of(kind: type) -> tuple[OptionSchema, ...]:
    """The options of a kind, in the order of its fields.

    Raises `TypeError` with the field's name where a field is no option.
    """
    return _schema_of(kind)


def draws_numbers(distribution: type) -> bool:
    """Whether a distribution can draw numbers only: no option holds things to choose among."""
    return not any(is_of_anything(option.type) for option in schema_of(distribution))


@cache
def _schema_of(kind: Any) -> tuple[OptionSchema, ...]:
    name = getattr(kind, "__name__", kind)
    if not dataclasses.is_dataclass(kind) or _is_undecorated(kind):
        raise TypeError(f"{name} is not decorated with `@dataclass(frozen=True)`")
    hints = _field_types(kind)
    options = []
    for field in dataclasses.fields(kind):
        try:
            annotation = read_annotation(hints[field.name])
        except TypeError as error:
            raise TypeError(f"field `{field.name}` of {name}: {error}") from None
        constraints = field.metadata.get(_KEY, Constraints())
        constraints = replace(constraints, words=(*constraints.words, *annotation.words))
        type_ = annotation.type
        if constraints.at_least and isinstance(type_, ListType):
            type_ = ListType(type_.item, constraints.at_least)
        default = REQUIRED if field.default is dataclasses.MISSING else field.default
        if field.default_factory is not dataclasses.MISSING:
            default = MutableDefault("default_factory")
        options.append(OptionSchema(field.name, type_, default, constraints))
    return tuple(options)


def _field_types(kind: Any) -> dict[str, Any]:
    """What the annotations of the fields mean. Those of class variables, which every kind has more
    of, are not evaluated."""
    names = {field.name for field in dataclasses.fields(kind)}
    found: dict[str, Any] = {}
    for owner in reversed(kind.__mro__):
        written = inspect.get_annotations(owner)
        fields = SimpleNamespace(__annotations__={n: written[n] for n in written if n in names})
        module = getattr(sys.modules.get(owner.__module__), "__dict__", {})
        # In this order the names of the module count before those of the fields, as for a class.
        found |= typing.get_type_hints(fields, dict(vars(owner)), module, include_extras=True)
    return found


def _is_undecorated(kind: Any) -> bool:
    """Whether a class adds fields that no `@dataclass` has seen: its base is a dataclass."""
    attributes = vars(kind)
    annotations = attributes.get("__annotations__", {}).values()
    adds = any("ClassVar" not in str(annotation) for annotation in annotations)
    return adds and "__dataclass_params__" not in attributes


__all__ = ["REQUIRED", "Constraints", "OptionSchema", "option", "schema_of"]
