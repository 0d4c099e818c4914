"""Whether a plugin goes with this version of roadlang, by what its distribution requires."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..version import __version__
from .entry_points import DISTRIBUTION

if TYPE_CHECKING:
    from .installed import Installed


def unmet_requirement(distribution: Installed | None) -> str | None:
    """Why a distribution cannot be used with this roadlang; None if it can.

    pip ensures it, but `pip install --no-deps`, and an upgrade of roadlang afterwards, do not.
    """
    if distribution is None or distribution.name.lower() == DISTRIBUTION:
        return None
    lines = [line for line in distribution.requires if line.lower().startswith("roadlang")]
    if not any(sign in line for line in lines for sign in "<>=!~"):
        return None
    from packaging.requirements import InvalidRequirement, Requirement
    from packaging.version import Version

    ours = Version(__version__)
    for line in lines:
        try:
            required = Requirement(line)
        except InvalidRequirement:
            continue  # pip has the last word on what it means
        needed = required.marker is None or required.marker.evaluate({"extra": ""})
        # A checkout after 0.2 is 0.3.dev4, which what requires 0.3 may use.
        fits = any(
            required.specifier.contains(version, prereleases=True)
            for version in (ours, Version(ours.base_version))
        )
        if required.name.lower() == "roadlang" and needed and not fits:
            return f"it requires {required.name}{required.specifier}, and this is {ours}"
    return None
