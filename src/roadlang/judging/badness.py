"""Which of several verdicts is the worst."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from ..ir.scene import Verdict


def badness(satisfied: bool | None, robustness: float | None) -> tuple[bool, bool, float]:
    """What the worst expectation, or scene, has least of.

    What is violated is worse than what holds, and worst where the robustness is minus infinity
    (None of what is violated, as where all windows of `eventually` begin after the end of the
    drive). What equality decides (`ego.contacts == 0`) holds with robustness 0, which says nothing
    of how near it came: it comes after all others that hold.
    """
    infinite = -math.inf if satisfied is False else math.inf
    rho = infinite if robustness is None else robustness
    return satisfied is not False, satisfied is True and rho == 0.0, rho


def says_how_near(satisfied: bool | None, robustness: float | None) -> bool:
    """Whether the robustness of what holds says how near it came to failing, and where: an infinite
    one does not, nor does that of an equality."""
    return satisfied is not True or (
        robustness is not None and robustness != 0.0 and math.isfinite(robustness)
    )


def worst_of(verdicts: Iterable[Verdict], expects: Sequence[str] = ()) -> Verdict | None:
    """The worst of several verdicts; None where nothing was judged.

    `expects`: the expectations that a search was for, the most important first. Then others do not
    count, and the first of them that is violated is the worst, as in the tables of the search.
    """
    judged = [each for each in verdicts if each.satisfied is not None]
    if not expects:
        return min(judged, key=_badness, default=None)
    known = {each.name: each for each in judged}
    listed = [known[name] for name in expects if name in known]
    violated = (each for each in listed if not each.satisfied)
    return next(violated, min(listed, key=_badness, default=None))


def _badness(verdict: Verdict) -> tuple[bool, bool, float]:
    return badness(verdict.satisfied, verdict.robustness)
