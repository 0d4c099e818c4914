"""Words for contacts in other languages, and the two ways in which a formula says it."""

from __future__ import annotations

CONTACT_VERBS = ("collides", "intersects", "touches", "hits")
"""Between two agents, `ego collides with lead`, or as a function, `collides(ego, lead)`."""
CONTACT_MEMBERS = ("collided", "collides", "crashed", "collisions")


def no_contact_help(first: str = "ego", second: str = "lead") -> str:
    """Help for a formula about the contacts of two agents."""
    return (
        f"write `gap({first}, {second}) > 0m` if the two must not touch each other, or "
        f"`{first}.contacts == 0` if `{first}` must not touch anything"
    )
