"""What is allowed and probably not meant."""

from __future__ import annotations

from ...diagnostics import Code
from ..checker import Checker


def warn(checker: Checker) -> None:
    """Names that nobody uses, and names that a unit hides."""
    for declaration in checker.program.in_role("let"):
        name = declaration.name
        # A file that others include may well name more than each of them needs.
        in_main_file = name.span.source == checker.program.source
        if in_main_file and name.text not in checker.used:
            checker.report(Code.UNUSED_LET, name.span, name=name.text)
    for word, span in checker.divisors:
        if word in checker.program.declarations:
            checker.report(Code.UNIT_SHADOWS_NAME, span, name=word, text=span.text)
