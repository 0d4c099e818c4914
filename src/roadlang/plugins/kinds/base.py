"""The class that all kinds derive from."""

from __future__ import annotations

import warnings
from typing import Any, ClassVar

_RENAMED = {
    "is_whole": "is_integer",
    "usual_width": "default_width",
    "usual_marking": "default_marking",
}
"""class attributes of kinds, whose old names work for one more minor version"""


class Kind:
    """What a plugin provides. The first line of the class docstring is its help text.

    A kind is a frozen dataclass that derives from the base class of its verb.
    """

    verb: ClassVar[str] = ""
    """set by the base class"""
    name: ClassVar[str] = ""
    """what scene files write: letters, digits and `_`, and no word of the language"""
    also_called: ClassVar[tuple[str, ...]] = ()
    """names that other tools have for it: errors suggest `name` instead"""
    rest: ClassVar[str] = ""
    """of a kind that is written as a call: the list option that takes all arguments without a name,
    as `items` of `choice(1m, 2m, 3m)`"""
    is_default: ClassVar[bool] = False
    """only for kinds that ship with roadlang: the kind that is used if a file names none for the
    verb, such as the distribution of `1m..2m` (its options are `low` and `high`) or what draws
    without `sample`"""
    is_random: ClassVar[bool] = False
    """it draws random numbers other than its options, so that each candidate differs"""
    cost: ClassVar[float] = 0.0
    """work for a station, where that of a displacement is 1: cheap requirements are tried first"""
    member: ClassVar[bool] = False
    """a number or signal of an agent or object, written `ego.speed` instead of `speed(ego)`"""
    is_integer: ClassVar[bool] = False
    """a number or signal whose values are integers"""
    domain: ClassVar[str] = "road"
    """whether it is about roads ("road") or about drives ("drive")"""
    geometry_is_user_input: ClassVar[bool] = False
    """a `GeometryError` that it raises is about what the scene file asks for (RL472), not a fault
    of the plugin (RL470)"""
    required_methods: ClassVar[tuple[str, ...]] = ()
    """a kind implements at least one of these methods of its base"""

    def __init_subclass__(cls, **options: Any) -> None:
        super().__init_subclass__(**options)
        for old in _RENAMED.keys() & vars(cls).keys():
            text = f"`{old}` is now `{_RENAMED[old]}`; the next minor version removes the old name"
            warnings.warn(text, DeprecationWarning, stacklevel=2)
            setattr(cls, _RENAMED[old], vars(cls)[old])
