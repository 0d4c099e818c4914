"""Whether the default of an option is a value that a scene file could have given it."""

from __future__ import annotations

import math
import re

from . import option_types as types
from .describing import bounds_text, type_text
from .option_values import fits, numbers_in
from .options import MutableDefault, OptionSchema

_WORD = re.compile(r"""[^\s"'`\\]([^"'`\\\n]*[^\s"'`\\])?\Z""")
"""What a scene file can have, bare or in quotes."""


def option_fault(option: OptionSchema) -> str | None:
    """What is wrong with the words, bounds or default of an option; None if nothing is."""
    for word in option.words:
        if not isinstance(word, str) or not _WORD.match(word) or not word.isprintable():
            return f"has the word {word!r}, which cannot be written in a scene file"
    if isinstance(option.type, types.WordType) and not option.words:
        return 'is a word, but has no words: write `option(words=("left", "right"))`'
    limits = option.constraints
    least = max((x for x in (limits.minimum, limits.above) if x is not None), default=-math.inf)
    most = min((x for x in (limits.maximum, limits.below) if x is not None), default=math.inf)
    if least > most:
        return f"allows no value: {bounds_text(option)}"
    return _default_fault(option)


def _default_fault(option: OptionSchema) -> str | None:
    value = option.default
    if option.required or value is None or (isinstance(value, str) and value in option.words):
        return None
    if isinstance(value, MutableDefault):
        instead = "None" if value.kind in ("dict", "set") else "a tuple"
        return f"has a {value.kind} as default, which all uses would share: write {instead}"
    if types.is_list_of_words(option.type):
        is_right = isinstance(value, tuple) and all(word in option.words for word in value)
    else:
        is_right = fits(value, option.type)
    if not is_right:
        return f"has the default {value!r}; expected: {type_text(option)}"
    if not all(option.constraints.allow(number) for number in numbers_in(value)):
        return f"has the default {value!r}; expected: {bounds_text(option)}"
    return None
