"""The scenes whose files are checked: the examples, and networks of many kinds, made up."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import ClassVar

import roadlang
from benchmarks.junctions.random_networks import KINDS, random_network
from roadlang.api import Extraction, Extractor, Flag, Integer, Picture, String, option
from roadlang.geometry import RoadNetwork
from roadlang.ir.scene import Scene
from roadlang.testing import sample

_EXAMPLES = Path(__file__).parents[2] / "examples"
_TEXT = """
image plan from \"\"\"
##
\"\"\" {{ scale: 20m/px }}
network town from plan {{
  extract with made_up {{ kind: "{kind}", seed: {seed}, left_hand: {left_hand} }}
  speed_limit: 50km/h{more}
  perturb with sine {{ amplitude: 0m..2m, wavelength: 40m..90m }}
}}
"""
_MORE = ("", ", sidewalks: 2m", "\n  control with signals", "\n  control with stop")


@dataclass(frozen=True)
class MadeUp(Extractor):
    """A random network, whatever the picture."""

    name: ClassVar[str] = "made_up"
    kind: String = option("town", help="of the network")
    seed: Integer = option(0, help="of the network")
    left_hand: Flag = option(False, help="whether its lanes are on the left")

    def extract(self, picture: Picture) -> Extraction:
        """The network alone."""
        made = random_network(self.kind, int(self.seed))
        sections = made.sections
        if self.left_hand:
            sections = {id: section.mirrored() for id, section in sections.items()}
        edges = tuple(replace(edge, cross_section=sections[edge.id]) for edge in made.network.edges)
        return Extraction(RoadNetwork(made.network.nodes, edges))


def example_scenes(seed: int, first: int = 0, every: int = 1) -> Iterator[tuple[str, Scene]]:
    """One scene of every example, or from the first on of every second one and so on, with its
    name."""
    for path in sorted(_EXAMPLES.glob("*.rl"))[first::every]:
        yield path.stem, roadlang.load(path).sample(1, seed=seed)[0].record


_TRAFFIC = """
agent cars is choice(car, car, van, bus, truck, motorcycle, bicycle) on town at random {
  count: integer(3, 12), drive with traffic
}
"""
_WALKERS = """
road street from town { select: longest }
agent walkers is pedestrian on street at random { count: 3, side: right, drive with walk }
"""


def random_scenes(count: int, seed: int, with_traffic: bool = False) -> Iterator[tuple[str, Scene]]:
    """`count` scenes of every kind of network, with their names; every fifth has left-hand
    traffic."""
    for number in range(count):
        for place, kind in enumerate(KINDS):
            turn, left_hand = number + place, (number + place) % 5 == 4
            text = scene_text(kind, seed * 1000 + number, turn, with_traffic, left_hand)
            yield f"{kind} {number}", sample(text, 1, kinds=[MadeUp], seed=seed)[0].record


def random_scene(kind: str, seed: int, turn: int, with_traffic: bool = False) -> Scene:
    """A scene of a kind of network."""
    text = scene_text(kind, seed, turn, with_traffic)
    return sample(text, 1, kinds=[MadeUp], seed=seed)[0].record


def scene_text(
    kind: str, seed: int, turn: int, with_traffic: bool = False, left_hand: bool = False
) -> str:
    """The scene file of a kind of network. `turn`: sidewalks, or the rule of its junctions. Traffic
    has pedestrians where there are sidewalks."""
    more, side = _MORE[turn % len(_MORE)], str(left_hand).lower()
    text = _TEXT.format(kind=kind, seed=seed, more=more, left_hand=side)
    if left_hand:
        text += "world { traffic: left }\n"
    if with_traffic:
        text += _TRAFFIC + (_WALKERS if "sidewalks" in more else "")
    return text
