"""Specifiers and operators of Scenic: what stands where, what sees what, how far it is."""

from __future__ import annotations

from ..contact_words import CONTACT_VERBS, no_contact_help
from .error_position import ErrorPosition, Mistake
from .unexpected import unexpected

_BRACES = "options are written in braces: `at 5m { heading: 30deg, drive with pure_pursuit }`"
_IN_BLOCK = "write an option as `start_speed: 10m/s`, a controller as `drive with KIND { ... }`"
_SIGHT = (
    "formulas do not test what is seen: write a distance, `distance(ego, lead) < 50m`; what an "
    "agent sees is decided by its sensors, `sense with KIND`"
)

_IN_TURN = (
    "of several `drive with`, the last one whose conditions hold is active: "
    "`drive with brake { when: time > 5s }` takes over at 5 s, `{ while: time < 5s }` ends at 5 s"
)


def controllers_in_turn(place: ErrorPosition) -> Mistake | None:
    """`then drive with brake`, `drive with K until time > 5s`, `drive with K for 5s`."""
    words = [text for _, text, *_ in place.tokens[: place.index]]
    has_controller = "drive" in words and place.first_kind == "AGENT" and place.in_block
    if has_controller and (words[-1] in ("then", "for") or place.word() in ("then", "until")):
        return unexpected(place, _IN_TURN, hopeless=True)
    return None


def scenic_placement(place: ErrorPosition) -> Mistake | None:
    """`is car following ego for 10m`, `left of ego by 3m`, `offset by 2m`, `at 5m facing 30deg`."""
    if place.first_kind not in ("AGENT", "OBJECT"):
        return None
    if place.kind() == "WITH" and place.in_block and not place.expects("COMMA"):
        return unexpected(place, _IN_BLOCK)
    if place.in_block or place.kind() != "NAME":
        return None
    word, after = place.word(), place.word(1)
    if word == "following":
        return unexpected(place, _following(place), hopeless=True)
    if word == "facing":
        return unexpected(place, _BRACES, hopeless=True)
    if word in ("left", "right") and after == "of":
        return unexpected(place, f"write `at beside({place.word(2)}, {word})`", hopeless=True)
    if word == "offset" and after in ("by", "along"):
        return unexpected(
            place, f"an offset is an option: `{{ offset: {place.word(2)} }}`", hopeless=True
        )
    if word == "visible":
        return unexpected(
            place,
            "positions do not depend on what is seen: write a range, `at 20m..60m`",
            hopeless=True,
        )
    return None


def _following(place: ErrorPosition) -> str:
    """`following ego for 10m`, `following main from ego for 10m`: along the road from something."""
    other = place.word(3) if place.word(2) == "from" else place.word(1)
    words = [place.word(offset) for offset in range(2, 6)]
    gap = words[words.index("for") + 1] if "for" in words[:-1] else "10m"
    return (
        f"a position relative to another is written `at ahead_of({other}, {gap})` or "
        f"`at behind({other}, {gap})`; to follow another, write `drive with car_follow`"
    )


def scenic_operator(place: ErrorPosition) -> Mistake | None:
    """`ego can see lead`, `ego collides with lead`, `distance from ego to lead`."""
    if place.word() == "can" and place.word(1) == "see":
        return unexpected(place, _SIGHT, hopeless=True)
    other = next((offset for offset in (1, 2) if place.kind(offset) == "NAME"), None)
    if place.word() in CONTACT_VERBS and place.kind(-1) == "NAME" and other is not None:
        help = no_contact_help(place.word(-1), place.word(other))
        return unexpected(place, help, hopeless=True)
    is_measured = place.first_kind in ("REQUIRE", "EXPECT") and place.word() in ("from", "to")
    if not is_measured or place.kind(-1) != "NAME" or place.kind(1) != "NAME":
        return None
    names = [place.word(1), place.word(3)] if place.word(2) == "to" else ["AGENT", place.word(1)]
    return unexpected(place, f"write `{place.word(-1)}({', '.join(names)})`", hopeless=True)
