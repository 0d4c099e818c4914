"""A token that does not fit, as a mistake with help: RL001."""

from __future__ import annotations

from ...diagnostics import Code, diagnose
from .error_position import Edit, ErrorPosition, Mistake
from .token_names import expectation, finding


def unexpected(
    place: ErrorPosition, help: str, *, hopeless: bool = False, edit: Edit | None = None
) -> Mistake:
    """The token at `place`, with what was expected there and what to write."""
    found = diagnose(
        Code.UNEXPECTED_TOKEN,
        place.span(),
        expected=expectation(place),
        found=finding(place),
        help=help,
    )
    return Mistake(found, edit, hopeless=hopeless)
