"""`choice(a, b, weights: [3, 1])`: one of several values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from roadlang.api import (
    Anything,
    Code,
    DiagnosticError,
    Distribution,
    ListOf,
    Number,
    diagnose,
    option,
)

if TYPE_CHECKING:
    from roadlang.geometry import Floats


@dataclass(frozen=True)
class Choice(Distribution):
    """One of the given values, chosen by weight."""

    name: ClassVar[str] = "choice"
    rest: ClassVar[str] = "items"
    is_ordered: ClassVar[bool] = False
    items: ListOf[Anything] = option(at_least=1, help="the values to choose from")
    weights: ListOf[Number] = option(
        None, help="relative probability of each value; equal by default"
    )

    def __post_init__(self) -> None:
        """Raises RL476 for weights that are wrong whatever is drawn."""
        weights = self.weights
        if weights is None:
            return
        numbers = [weight for weight in weights if isinstance(weight, int | float)]
        is_zero = len(numbers) == len(weights) and not sum(numbers) > 0
        if len(weights) != len(self.items) or is_zero or any(weight < 0 for weight in numbers):
            raise self._invalid_weights()

    def quantile(self, uniform: Floats) -> Any:
        """The item whose share of the unit interval holds the number."""
        import numpy as np

        ends = np.cumsum(self._shares(), axis=0)[:-1]
        index = np.zeros(uniform.shape, dtype=np.int64)
        for end in ends:
            index += uniform >= end
        items = self.items
        if all(isinstance(item, bool | int | float | np.ndarray) for item in items):
            columns = [np.broadcast_to(np.asarray(item), uniform.shape) for item in items]
            return np.choose(index, columns) if len(columns) < 32 else _pick(columns, index)
        if not any(isinstance(item, np.ndarray) for item in items):
            table = np.empty(len(items), dtype=object)
            for each, item in enumerate(items):
                table[each] = item
            return table[index]
        chosen = np.empty(uniform.shape, dtype=object)
        for place, number in np.ndenumerate(index):
            item = items[number]
            chosen[place] = item[place[0], 0] if isinstance(item, np.ndarray) else item
        return chosen

    def support(self) -> tuple[float, float] | None:
        numbers = [item for item in self.items if isinstance(item, int | float)]
        return (min(numbers), max(numbers)) if len(numbers) == len(self.items) else None

    def levels(self, steps: int) -> list[float]:
        """Each item once, whatever `steps` says."""
        ends, levels = 0.0, []
        for share in map(float, self._shares()):
            if share > 0:
                levels.append(ends + share / 2)
            ends += share
        return levels

    def simplest(self) -> float:
        """The first item."""
        return self.levels(1)[0]

    def cells(self) -> list[float]:
        ends = 0.0
        return [ends := ends + float(share) for share in self._shares()]

    def _shares(self) -> list[Any]:
        """A number for each item, or a column where weights are random. Raises RL476."""
        import numpy as np

        weights = self.weights
        if weights is None:
            return [1.0 / len(self.items)] * len(self.items)
        total = sum(weights)
        least = min(float(np.min(weight)) for weight in weights)
        if least < 0 or not np.all(np.asarray(total) > 0):
            raise self._invalid_weights()
        return [weight / total for weight in weights]

    def _invalid_weights(self) -> DiagnosticError:
        return DiagnosticError(diagnose(Code.INVALID_CHOICE_WEIGHTS, items=len(self.items)))


def _pick(columns: list[Floats], index: Any) -> Floats:
    import numpy as np

    return np.asarray(np.take_along_axis(np.stack(columns), index[None], axis=0)[0])
