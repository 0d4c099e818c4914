"""What the reference says of each statement: its form, its meaning, its options, an example."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..plugins.options import OptionSchema
from .lower.statements import STATEMENTS


@dataclass(frozen=True, slots=True)
class StatementReference:
    """A statement as the reference and `roadlang explain` show it."""

    word: str
    form: str
    help: str
    example: str

    @property
    def options(self) -> tuple[OptionSchema, ...]:
        """The options of its block."""
        return STATEMENTS[self.word].schema if self.word in STATEMENTS else ()

    @property
    def passes(self) -> Mapping[str, tuple[OptionSchema, ...]]:
        """The verbs of the passes in its block, each with the options that all its kinds have."""
        if self.word not in STATEMENTS:
            return {}
        spec = STATEMENTS[self.word]
        return {verb: spec.common_options(verb) for verb in spec.verbs}


REFERENCE = (
    StatementReference(
        "scenario",
        'scenario NAME "title"',
        "Names the scenario. Optional; by default its name is that of the file.",
        'scenario hairpin "A hairpin, bent at random"',
    ),
    StatementReference(
        "include",
        'include "FILE" { PARAM: value }',
        "Adds the declarations of another scene file and sets its params. Paths are relative to "
        "this file.",
        'include "street.rl"',
    ),
    StatementReference(
        "override",
        "override NAME { ... }",
        "Replaces options and passes of an image, network, road, agent or object that an included "
        "file declares. An option replaces that option; passes of a verb (`drive with`, ...) "
        "replace all passes of that verb; the rest stays.",
        'include "street.rl" as left\noverride left.street { width: 6m }',
    ),
    *(
        StatementReference(spec.word, spec.form, spec.help, spec.example)
        for spec in STATEMENTS.values()
    ),
)
"""The statements in the order of the language reference."""

BY_WORD = {statement.word: statement for statement in REFERENCE}
