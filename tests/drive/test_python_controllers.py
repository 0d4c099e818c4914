"""Which agents Python drives: those whose last unconditional controller implements `control`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import (
    Call,
    Control,
    ControlBatch,
    Controller,
    Number,
    Observation,
    ObservationBatch,
    Scene,
    SceneActor,
    Speed,
    option,
)
from roadlang.drive.controllers import python_controllers
from roadlang.ir.scene import Provenance
from roadlang.plugins.discovery import registry_of


@dataclass(frozen=True)
class Steady(Controller):
    """Straight on."""

    name: ClassVar[str] = "steady"
    speed: Speed = option(5.0, help="kept")

    def control(self, observation: Observation) -> Control:
        return Control(0.0, self.speed - observation.speed)


@dataclass(frozen=True)
class Elsewhere(Controller):
    """KindInstance into engines."""

    name: ClassVar[str] = "elsewhere"


@dataclass(frozen=True)
class Wheel(Controller):
    """Steers, and leaves the pedals to whoever drove before."""

    name: ClassVar[str] = "wheel"
    angle: Number = option(0.2, help="radians")

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        return ControlBatch(np.array([self.angle]), np.array([math.nan]))


@dataclass(frozen=True)
class Pedals(Controller):
    """Accelerates, and leaves the wheel to whoever drove before."""

    name: ClassVar[str] = "pedals"

    def controls(self, observations: ObservationBatch, state: Any) -> ControlBatch:
        return ControlBatch(np.array([math.nan]), np.array([1.5]))


REGISTRY = registry_of({"acme": testing.plugin_of(Steady, Elsewhere, Wheel, Pedals)})


SEEN = Observation(0, 0.02, "ego", 0, 0, 0, 2.0, 0, 0, 0, 0, 2.7, lambda d: (d, 0, 0, 0))


def driven(*drive: Call) -> dict[str, Any]:
    actor = SceneActor("ego", "ego", "car", 0, 0, 0, 4.5, 1.8, 1.5, drive=drive)
    scene = Scene("s", "", 0, Provenance("0", 1, 0, 0), agents=(actor,))
    return dict(python_controllers(scene, REGISTRY))


def test_a_controller_in_python_gets_its_options() -> None:
    controller = driven(Call("steady", {"speed": 7.0}))["ego"]
    assert controller.control(SEEN) == Control(0.0, 5.0)


def test_a_controller_of_the_engine_is_left_to_it() -> None:
    assert driven(Call("elsewhere")) == {}
    assert driven(Call("steady"), Call("elsewhere")) == {}


def test_a_conditional_controller_is_not_the_steady_one() -> None:
    found = driven(Call("steady"), Call("elsewhere", {}, {"formula": True}))
    assert found["ego"].control(SEEN) == Control(0.0, 3.0)


def test_nobody_drives_what_does_not_drive() -> None:
    assert driven() == {}


@pytest.mark.parametrize(
    ("drive", "steering", "acceleration"),
    [
        ((Call("wheel"),), 0.2, 0.0),
        ((Call("pedals"),), 0.0, 1.5),
        ((Call("steady"), Call("wheel")), 0.2, 3.0),
        ((Call("steady"), Call("pedals")), 0.0, 1.5),
        ((Call("wheel"), Call("pedals")), 0.2, 1.5),
        ((Call("wheel", {"angle": 0.1}), Call("pedals"), Call("wheel")), 0.2, 1.5),
        ((Call("wheel"), Call("steady")), 0.0, 3.0),
        ((Call("wheel", {"angle": 0.1}), Call("steady"), Call("wheel")), 0.2, 3.0),
    ],
)
def test_what_a_controller_leaves_open_is_decided_by_those_before(
    drive: tuple[Call, ...], steering: float, acceleration: float
) -> None:
    """Where nobody decides it, it is 0."""
    assert driven(*drive)["ego"].control(SEEN) == Control(steering, acceleration)
