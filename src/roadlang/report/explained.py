"""An explanation of a failure by `roadlang explain`: draws that matter, and those that do not."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class ShownInfluence:
    """The robustness with some draws at their medians, None where it is infinite, and whether the
    expectation holds then, None where that is no valid scene."""

    draws: tuple[str, ...]
    robustness: float | None
    holds: bool | None = False


@dataclass(frozen=True)
class FailureExplanation:
    """What `roadlang explain` wrote, as far as it is shown."""

    expectation: str
    unit: str
    medians: tuple[ShownInfluence, ...]
    robustness: float | None = None
    """of the failure; None in files of older versions"""

    @property
    def _all_singles(self) -> list[ShownInfluence]:
        return [item for item in self.medians if len(item.draws) == 1]

    @property
    def singles(self) -> list[ShownInfluence]:
        """Draws that change the robustness by themselves."""
        return [item for item in self._all_singles if not self._is_as_before(item)]

    @property
    def without_effect(self) -> list[str]:
        """The names of those that do not."""
        return [item.draws[0] for item in self._all_singles if self._is_as_before(item)]

    @property
    def pairs(self) -> list[ShownInfluence]:
        """Pairs with which the expectation holds, though it holds with neither alone."""
        alone = {item.draws[0] for item in self._all_singles if item.holds}
        pairs = (item for item in self.medians if len(item.draws) > 1 and item.holds)
        return [item for item in pairs if not alone & {*item.draws}]

    def _is_as_before(self, item: ShownInfluence) -> bool:
        return item.holds is False and item.robustness == self.robustness is not None
