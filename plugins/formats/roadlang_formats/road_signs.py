"""Signs of right of way."""

from __future__ import annotations

from collections.abc import Mapping

SIGNS: Mapping[str, str] = {"yield": "205", "stop": "206", "all_way_stop": "206"}
"""Numbers of the German catalog by the control of a junction. OpenDRIVE takes them where a country
is given; CommonRoad names its signs of Germany by them."""
