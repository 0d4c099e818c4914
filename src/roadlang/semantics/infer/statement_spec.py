"""What the checker knows of a statement word."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from ...plugins.common_options import schema_of_common
from ...plugins.options import OptionSchema, schema_of
from ..checker import Checker


@dataclass(frozen=True, slots=True)
class StatementSpec:
    """`scenario_field` of `ir.Scenario` gathers what the statements of this word lower to."""

    word: str
    scenario_field: str
    lower: Callable[[Checker, StatementSpec, Any], Any]
    """From a `PlacedStatement` or `Declaration` to what it becomes; None, reported, if wrong."""
    form: str
    """How it is written, as the reference and `roadlang explain` show it."""
    help: str
    """What it means."""
    example: str
    """A scene file with it."""
    options: type | None = None
    verbs: Mapping[str, type | None] = field(default_factory=dict)
    """The verbs of the passes in its block, and the options that every kind of one has here."""
    once: bool = False
    """A file has at most one."""
    as_written: bool = False
    """In the order of the file; else what a thing depends on comes before it."""
    default_kind: str = ""
    """The kind of a statement that names none, where it is not the default of the verb."""

    @property
    def schema(self) -> tuple[OptionSchema, ...]:
        """The statement's own options."""
        return schema_of(self.options) if self.options is not None else ()

    def common_options(self, verb: str) -> tuple[OptionSchema, ...]:
        """The options that every kind of a verb has in this statement."""
        options = self.verbs.get(verb)
        return schema_of_common(options) if options is not None else ()
