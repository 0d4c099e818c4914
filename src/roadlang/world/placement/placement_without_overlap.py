"""Agents and objects placed one after the other, so that nothing overlaps.

A copy that does not fit is placed again, from draws keyed by its try; the roads and whatever was
placed before stay. Copies of a group that fit stay too: of two that overlap, the later is moved.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any
from weakref import ref

import numpy as np
from numpy.typing import NDArray

from ...evaluate.candidates import CandidateBatch
from ...evaluate.copies import CopyBatch
from ...geometry import Footprints
from ...geometry.arrays import Floats, Integers
from ...ir.placed_batch import PlacedBatch
from ...ir.scenario import ScenarioActor
from ..roads.named_roads import length_of_rows, name_of_road, named_road
from .copies import CopyKinds, counts, kinds_of, most_copies
from .distances_to_keep import distances_to_keep
from .placement_order import can_be_placed_again, placement_order
from .poses import poses_of
from .positions import Others
from .road_poses import RoadPoses
from .road_strips import depth_in_lanes
from .room_between import COPY, PlacedRectangles, legend_neighbors, missing_room, room_among
from .spots import shortfall
from .tight_bends import lacking_in_bends

TRIES = (1, 1, 2, 4, 8, 8, 16, 16, 32, 32)
"""How often a copy is tried in each round before it is given up. Within a round it keeps clear of
what was placed in earlier rounds, and of copies before it: the same however many are placed."""
POSE = tuple(field.name for field in fields(RoadPoses))


class Arrangement:
    """The agents and objects of the candidates that were placed so far, in order."""

    def __init__(self, candidates: CandidateBatch) -> None:
        self._candidates = ref(candidates)  # which hold this: all is freed with the last use
        self.order = placement_order(candidates.scenario)
        self.numbers = {actor.name: index for index, actor in enumerate(self.order)}
        self._done = 0
        self._noted = 0
        self._neighbors = PlacedRectangles()

    @property
    def candidates(self) -> CandidateBatch:
        """What is arranged, as long as anybody else has it."""
        found = self._candidates()
        assert found is not None
        return found

    def placed(self, actor: ScenarioActor) -> dict[str, NDArray[Any]]:
        """Arrays (V, N): those of `PlacedBatch`, `tries`, at which try each copy was placed,
        `missing`, the meters that a copy lacks to its neighbors, and `blocker`, the number in the
        order of what it is too near to, or -1."""
        number = self.numbers[actor.name]
        while self._done <= number:
            self._place(self.order[self._done])
            self._done += 1
        return self._place(actor)

    def batch(self, actor: ScenarioActor) -> PlacedBatch:
        """Where every copy of an agent or object is."""
        found = self.placed(actor)
        return PlacedBatch(**{field.name: found[field.name] for field in fields(PlacedBatch)})

    def _place(self, actor: ScenarioActor) -> dict[str, NDArray[Any]]:
        key, candidates = ("placed", actor.name), self.candidates
        found = candidates.once(key, lambda: self._found(actor))
        if candidates.count > 1:
            return found
        # Placed with others, there are as many columns as any of them has copies.
        most = most_copies(actor, candidates)
        return {name: values[:, :most] for name, values in found.items()}

    def _found(self, actor: ScenarioActor) -> dict[str, NDArray[Any]]:
        count, most = self.candidates.count, most_copies(actor, self.candidates)
        if most == 0:
            names = ("present", *POSE, "length", "apart", "missing", "blocker")
            return {
                **dict.fromkeys(names, np.empty((count, 0))),
                "tries": np.empty((count, 0), int),
            }
        present = np.arange(1, most + 1) <= counts(actor, self.candidates)[:, None]
        turn = _Turn.of(actor, self.candidates, present.reshape(-1), self.batch)
        if actor.name not in self.candidates.known_tries:
            self._note(self.numbers[actor.name])
            turn.settle(self._neighbors)
        if self.candidates.record is not None:
            turn.record()
        parts = turn.columns()
        shaped = {name: part.reshape(count, most) for name, part in parts.items()}
        return {"present": present, **shaped}

    def _note(self, number: int) -> None:
        """Add those placed before to what the next keep clear of."""
        for actor in self.order[self._noted : number]:
            placed = self._place(actor)
            self._neighbors.add(self.numbers[actor.name], placed)
        self._noted = max(self._noted, number)


@dataclass
class _Turn:
    """The copies of one agent or object while they are placed: rows (R,), all candidates."""

    actor: ScenarioActor
    candidates: CandidateBatch
    copies: CopyBatch
    """as they were tried first"""
    kinds: CopyKinds
    present: NDArray[np.bool_]
    apart: Floats
    tries: Integers
    poses: RoadPoses
    missing: Floats
    blocker: Integers
    others: Others

    @classmethod
    def of(
        cls,
        actor: ScenarioActor,
        candidates: CandidateBatch,
        present: NDArray[np.bool_],
        others: Others,
    ) -> _Turn:
        most = len(present) // candidates.count
        known = candidates.known_tries.get(actor.name, np.zeros((candidates.count, most), np.int64))
        copies = CopyBatch.every(candidates, most, known[:, :most])
        kinds = kinds_of(actor, candidates)
        found = poses_of(actor, copies, kinds.lengths, kinds.widths, others)
        poses = RoadPoses(*(np.array(getattr(found, name)) for name in POSE))
        tries = np.array(copies.tries)
        nothing, nobody = np.zeros(copies.count), np.full(copies.count, -1)
        apart = distances_to_keep(actor, CopyBatch.every(candidates, most), kinds)
        return cls(actor, candidates, copies, kinds, present, apart, tries, poses, nothing, nobody,
            others)  # fmt: skip

    def settle(self, neighbors: PlacedRectangles) -> None:
        """Place copies again until each fits or has been tried as often as `TRIES` says."""
        pending = np.flatnonzero(self.present)
        again = can_be_placed_again(self.actor, self.candidates)
        placed = neighbors.beginning(*self._legends() if again else ())
        following = np.zeros(len(self.present), np.int64)
        for number in TRIES if again else TRIES[:1]:
            fits = self._try(pending, following[pending], number, placed, again)
            settled = pending[fits]
            boxes, rows = self._boxes(settled), settled // self._most
            placed.add_rows(COPY, boxes, rows, self.apart[settled])
            pending = pending[~fits]
            if not len(pending):
                break
            following[pending] = self.tries[pending] + 1

    def _try(
        self, index: Integers, first: Integers, number: int, placed: PlacedRectangles, again: bool
    ) -> NDArray[np.bool_]:
        """Whether copies (n,) fit by one of `number` tries from `first` (n,) on; each stays where
        it fitted first, or where it was tried last."""
        tries = (first[:, None] + np.arange(number)).reshape(-1)
        several = np.repeat(index, number)
        if tries.any():
            copies = CopyBatch.every(self.candidates, self._most).chosen(several)
            lengths, widths = self.kinds.lengths[several], self.kinds.widths[several]
            poses = poses_of(self.actor, copies.at_tries(tries), lengths, widths, self.others)
        else:
            poses = RoadPoses(*(getattr(self.poses, name)[several] for name in POSE))
        missing, blocker = self._missing(several, poses, placed, again)
        if again and number < TRIES[-1] and self._drives_in_network:
            bends = lacking_in_bends(self.actor, self.candidates, self.kinds, several, poses)
            missing = np.maximum(missing, bends)
        fits = self._of_rows(index, (missing <= 0.0).reshape(-1, number))
        chosen = np.where(fits.any(axis=1), fits.argmax(axis=1), number - 1)
        chosen += np.arange(len(index)) * number
        for name in POSE:
            getattr(self.poses, name)[index] = getattr(poses, name)[chosen]
        self.tries[index] = tries[chosen]
        self._note(index, missing[chosen], blocker[chosen])
        free = index[missing[chosen] <= 0.0]
        self._note(free, *room_among(self._boxes(free), free // self._most, self.apart[free]))
        return self._of_rows(index, self.missing[index] <= 0.0)

    def _of_rows(self, index: Integers, fits: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Copies that stand in a row (`spacing`) fit together or not at all."""
        if not _has(self.actor, "spacing"):
            return fits
        together = np.ones((self.candidates.count, *fits.shape[1:]), dtype=bool)
        np.logical_and.at(together, index // self._most, fits)
        return np.asarray(together[index // self._most])

    def _note(self, index: Integers, missing: Floats, blocker: Integers) -> None:
        self.missing[index], self.blocker[index] = missing, blocker

    def _legends(self) -> tuple[PlacedRectangles, ...]:
        return (legend_neighbors(self.candidates, self._varying),)

    @property
    def _varying(self) -> bool:
        """Whether its road differs in its stations, so that there is one candidate."""
        on = self.actor.on
        return on is not None and self.candidates.scenario.is_varying(on)

    @property
    def _drives_in_network(self) -> bool:
        """Whether it begins in a lane of a network, where it has a route. The last tries are made
        in tight bends too, as there may be no other places."""
        scenario = self.candidates.scenario
        on_network = self.actor.name in scenario.agents and self.actor.on in scenario.networks
        return on_network and bool(self.actor.drive)

    def _missing(
        self, index: Integers, poses: RoadPoses, placed: PlacedRectangles, again: bool
    ) -> tuple[Floats, Integers]:
        """(n,) meters that copies at these poses lack, and what they are too near to."""
        rows = index // self._most
        boxes = self._boxes_at(poses, index)
        missing, blocker = missing_room(boxes, rows, self.apart[index], placed)
        if again and self.actor.on is not None:
            beyond = self._beyond_road(index, poses)
            if self.actor.is_beside_road:
                beyond = np.maximum(beyond, self._in_lanes(boxes, rows, poses))
            blocker = np.where(beyond > missing, -1, blocker)
            missing = np.maximum(missing, beyond)
        return missing, blocker

    def _beyond_road(self, index: Integers, poses: RoadPoses) -> Floats:
        """(n,) meters that copies stand beyond the ends of their road: agents in a lane with their
        bumpers, others with their middles. In a network they are found on its roads. Or what
        counts where they have no place."""
        name, start = str(self.actor.on), poses.start
        is_network = name in self.candidates.scenario.networks
        if is_network or named_road(name, self.candidates).closed:
            return shortfall(poses.lacking, poses.no_place)
        length = length_of_rows(name, self.candidates, index // self._most)
        half = np.zeros(len(index))
        is_agent = self.actor.name in self.candidates.scenario.agents
        if is_agent and not self.actor.is_beside_road:
            half = np.minimum(self.kinds.lengths[index], length) / 2
        beyond = np.maximum(half - start, start + half - length)
        beyond = np.where(beyond > 1e-9 * length, beyond, poses.lacking)
        return shortfall(beyond, poses.no_place)

    def _in_lanes(self, boxes: Footprints, rows: Integers, poses: RoadPoses) -> Floats:
        names = [name_of_road(self.actor, number) for number in poses.road.tolist()]
        return depth_in_lanes(boxes, rows, names, poses.start, self.candidates, self._varying)

    def _boxes(self, index: Integers) -> Footprints:
        poses = RoadPoses(*(getattr(self.poses, name)[index] for name in POSE))
        return self._boxes_at(poses, index)

    def _boxes_at(self, poses: RoadPoses, index: Integers) -> Footprints:
        lengths = self.kinds.lengths[index]
        return Footprints(poses.x, poses.y, poses.heading, lengths, poses.width)

    @property
    def _most(self) -> int:
        return len(self.present) // self.candidates.count

    def record(self) -> None:
        """Record the draws of where each copy stands at last."""
        assert self.candidates.record is not None
        copies = self.copies
        if not np.array_equal(copies.tries, self.tries):
            copies = CopyBatch.every(self.candidates, self._most, self.tries)
            poses_of(self.actor, copies, self.kinds.lengths, self.kinds.widths, self.others)
        copies.record_in(self.candidates.record, self.present)

    def columns(self) -> dict[str, NDArray[Any]]:
        """All arrays (R,) by name."""
        pose = {name: getattr(self.poses, name) for name in POSE}
        return {**pose, "length": self.kinds.lengths, "apart": self.apart, "tries": self.tries,
                "missing": self.missing, "blocker": self.blocker}  # fmt: skip


def _has(actor: ScenarioActor, option: str) -> bool:
    return option in actor.options
