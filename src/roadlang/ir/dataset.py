"""The index of a set of labeled pictures."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

DATASET_SCHEMA = "roadlang.dataset/1"


@dataclass(frozen=True, slots=True)
class DatasetFrame:
    """One picture of one camera."""

    moment: int
    """number of the moment; all cameras look at the same moments"""
    scene: int
    """number of the scene"""
    time: float
    """seconds since the start of the drive"""
    agent: str
    """that carries the camera"""
    camera: str
    """name of the sensor"""
    files: Mapping[str, str]
    """beside this file: `rgb` (8 bits a color), `depth` (16 bits, see `depth_unit`), `semantic`
    (8 bits, ids of `classes`), `instance` (16 bits, 0 for what is neither agent nor object) and
    `labels` (`roadlang.labels/1`)"""


@dataclass(frozen=True, slots=True)
class Dataset:
    """The result of a run of `roadlang render --dataset`."""

    name: str
    """of the scenario"""
    title: str
    """of the scenario"""
    roadlang: str
    """version"""
    engine: str
    """engine that rendered the pictures"""
    source: str
    """the scene file"""
    seed: int
    """of the run"""
    interval: float
    """seconds from one moment to the next"""
    classes: Mapping[str, int]
    """ids by name"""
    frames: tuple[DatasetFrame, ...]
    """in the order of moments and cameras"""
    params: Mapping[str, str] = field(default_factory=dict)
    """values of params set by the user, as written"""
    inputs: Mapping[str, str] = field(default_factory=dict)
    """sha256 by path as written"""
    plugins: Mapping[str, str] = field(default_factory=dict)
    """version by distribution"""
    clips: tuple[str, ...] = ()
    """video files of the color pictures of a camera in a scene, if requested"""
    depth_unit: float = 0.01
    """meters for 1 in depth pictures; 0 there is nothing within 655.35 m"""
    schema: str = DATASET_SCHEMA
    """version of this format"""
