"""The way of an agent through a network, lane by lane."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class RouteTurn:
    """A connection of lanes through a junction."""

    network: str
    """name of the network"""
    junction: int
    """id of the junction"""
    connection: int
    """id of the connection in the junction"""


@dataclass(frozen=True, slots=True)
class RouteStep:
    """A part of one lane. Two steps of one road in different lanes: a lane change between them."""

    road: str
    """name of the road"""
    lane: int
    """its id"""
    start: float
    """arc length along the road where the step begins, meters"""
    stop: float
    """arc length where it ends, meters; less than `start` against the direction of the road"""
    turn: RouteTurn | None = None
    """the connection from its end to the begin of the next step; null at the last step, and
    where the next step begins where this one ends"""


@dataclass(frozen=True, slots=True)
class SceneRoute:
    """Steps in order, each from where the one before leads to."""

    steps: tuple[RouteStep, ...]
    """at least one"""
    closed: bool = False
    """whether the last step leads to the begin of the first"""
