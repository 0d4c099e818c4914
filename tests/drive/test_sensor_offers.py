"""What is said of a sensor that a simulator does not offer: which ones do."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import pytest

from roadlang import testing
from roadlang.api import (
    Controller,
    DiagnosticError,
    Length,
    Scene,
    Sensor,
    Simulator,
    Trace,
    option,
)
from roadlang.drive.sensor_offers import refuse_sensors, refused_sensor
from roadlang.plugins.finding import entry_of

TEXT = """
road main { draw with waypoints { points: [(0m, 0m), (80m, 0m)] } }
agent ego is car on main at 5m { sense with sonar as nose }
"""


@dataclass(frozen=True)
class Sonar(Sensor):
    """Measured by engines."""

    name: ClassVar[str] = "sonar"


@dataclass(frozen=True)
class Lidar(Sensor):
    """Offered by nobody."""

    name: ClassVar[str] = "lidar"


@dataclass(frozen=True)
class Deaf(Simulator):
    """Offers nothing."""

    name: ClassVar[str] = "deaf"

    def drive(self, scene: Scene, controllers: Mapping[str, Controller]) -> Trace:
        """Nowhere."""
        raise NotImplementedError


@dataclass(frozen=True)
class Hearing(Deaf):
    """Offers sonars."""

    name: ClassVar[str] = "hearing"

    def offers(self, sensor: type[Sensor]) -> bool:
        """Sonars alone."""
        return sensor is Sonar


@dataclass(frozen=True)
class Choosy(Hearing):
    """Offers sonars too, once it is told how far."""

    name: ClassVar[str] = "choosy"
    reach: Length = option(help="of what is heard")


@dataclass(frozen=True)
class Vague(Deaf):
    """Says neither yes nor no."""

    name: ClassVar[str] = "vague"

    def offers(self, sensor: type[Sensor]) -> Any:
        """As told."""
        return "perhaps"


KINDS = (Sonar, Lidar, Deaf, Hearing, Choosy, Vague)
REGISTRY = testing.registry_with(*KINDS)


def help_for(sensor: str, simulator: type[Simulator]) -> tuple[str, ...] | None:
    entry = entry_of(REGISTRY, "simulate", f"tested.{simulator.name}")
    refused = refused_sensor(
        entry_of(REGISTRY, "sense", f"tested.{sensor}"), "nose", (entry, simulator()), REGISTRY
    )
    return None if refused is None else refused.help


def test_what_is_offered_is_not_refused() -> None:
    assert help_for("sonar", Hearing) is None


def test_the_help_names_the_simulators_that_offer_it_and_work_without_options() -> None:
    assert help_for("sonar", Deaf) == ("write `simulate with tested.hearing`",)
    assert help_for("lidar", Deaf) == ("no installed simulator offers it",)
    assert help_for("lidar", Hearing) == ("no installed simulator offers it",)


def test_an_answer_that_is_none_is_the_simulators_fault() -> None:
    with pytest.raises(DiagnosticError) as caught:
        help_for("sonar", Vague)
    assert [found.code for found in caught.value.diagnostics] == ["RL474"]


def test_scenes_with_a_sensor_that_is_not_offered_are_refused() -> None:
    scene = testing.sample(TEXT, kinds=KINDS)[0].record
    entry = entry_of(REGISTRY, "simulate", "tested.deaf")
    with pytest.raises(DiagnosticError) as caught:
        refuse_sensors([scene], (entry, Deaf()), REGISTRY)
    (found,) = caught.value.diagnostics
    assert found.code == "RL257"
    assert "nose" in found.message
    hearing = entry_of(REGISTRY, "simulate", "tested.hearing")
    refuse_sensors([scene], (hearing, Hearing()), REGISTRY)
