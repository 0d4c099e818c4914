"""What every draw reaches somewhere refutes `always`; what some draw satisfies is never refuted."""

from __future__ import annotations

from contextlib import suppress

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import roadlang
from tests.straight_road import STRAIGHT

NEAR = "require near: always (deviation(bent, main) < 10m)\n"
FEW = "sample with random { attempts: 60 }\n"


def bent(passes: str, require: str = NEAR) -> str:
    return f"{STRAIGHT}road bent from main {{ {passes} }}\n{require}{FEW}"


def refusal(text: str) -> roadlang.NoSceneError:
    with pytest.raises(roadlang.NoSceneError) as caught:
        roadlang.loads(text).sample()
    return caught.value


@pytest.mark.parametrize(
    ("passes", "reached"),
    [
        (
            "perturb with sine { amplitude: 20m..30m, wavelength: 60m..90m, phase: 0deg..360deg }",
            19,
        ),
        ("perturb with sine { amplitude: -30m..-20m, wavelength: 60m }", 19),
        ("perturb with bump { at: 40m..60m, height: 12m..15m, length: 40m }", 11),
        ("perturb with shift { at: 10m, length: 40m, offset: 12m..15m }", 12),
        (
            "perturb with sine { amplitude: 20m..30m, wavelength: 60m }"
            " perturb with random_walk { amplitude: 15m, correlation: 20m }",
            None,
        ),
    ],
)
def test_what_every_draw_exceeds_somewhere_is_impossible(passes: str, reached: int | None) -> None:
    [found] = refusal(bent(passes)).diagnostics
    assert found.code == ("RL600" if reached else "RL601")
    if reached:
        assert f"`deviation(bent, main)` is {reached}" in found.help[0]
        assert passes in found.help[0]
        assert "(line 3)" in found.help[0]
        assert found.span is not None
        assert found.span.text == NEAR.strip()


@pytest.mark.parametrize(
    "require",
    [
        "require near: always (deviation(bent, main) < 10m and width(bent) > 1m)\n",
        "require near: always (deviation(bent, main) < 10m) and always (width(bent) > 1m)\n",
        "require near: always (distance(bent, main) < 10m) { robustness: average }\n",
        "param most = 5m..10m\nrequire near: always (abs(deviation(bent, main)) < most)\n",
    ],
)
def test_conjunctions_and_other_measures_are_refuted(require: str) -> None:
    passes = "perturb with sine { amplitude: 20m..30m, wavelength: 60m }"
    [found] = refusal(bent(passes, require)).diagnostics
    assert found.code == "RL600"


@pytest.mark.parametrize(
    ("passes", "require"),
    [
        ("perturb with sine { amplitude: -20m..30m, wavelength: 60m }", NEAR),
        ("perturb with sine { amplitude: 20m..30m, wavelength: 60m..9000m }", NEAR),
        ("perturb with bump { at: 20m, height: 12m, length: 40m, over: [60m, 100m] }", NEAR),
        ("perturb with bump { at: -40m..60m, height: 12m..15m, length: 40m }", NEAR),
        ("perturb with shift { at: 10m..900m, length: 40m, offset: 12m..15m }", NEAR),
        (
            "perturb with sine { amplitude: 20m, wavelength: 60m }",
            "require near: eventually (deviation(bent, main) < 10m)\n",
        ),
        (
            "perturb with sine { amplitude: 20m, wavelength: 50m }",
            "require near: always eventually[0m, 40m] (deviation(bent, main) < 10m)\n",
        ),
        (
            "perturb with sine { amplitude: 20m, wavelength: 60m }",
            "require near: always[0m, 2m] (deviation(bent, main) < 10m)\n",
        ),
    ],
)
def test_what_some_draw_satisfies_has_scenes(passes: str, require: str) -> None:
    text = bent(passes, require).replace("attempts: 60", "attempts: 4000")
    assert len(roadlang.loads(text).sample(1)) == 1


SIZES = st.floats(-30.0, 30.0).map(lambda value: round(value, 1))


@settings(max_examples=25, deadline=None)
@given(
    sizes=st.tuples(SIZES, SIZES),
    waves=st.tuples(st.floats(30.0, 400.0), st.floats(30.0, 400.0)),
    closed=st.booleans(),
    limit=st.floats(1.0, 30.0),
)
def test_no_candidate_of_a_refuted_scene_satisfies_it(
    sizes: tuple[float, float], waves: tuple[float, float], closed: bool, limit: float
) -> None:
    low, high = sorted(sizes)
    short, long = sorted(waves)
    points = "[(0m, 0m), (90m, 0m), (90m, 90m), (0m, 90m)]"
    shape = f"draw with waypoints {{ points: {points} }} closed: {str(closed).lower()}"
    text = (
        f"road main {{ {shape} }}\n"
        f"road bent from main {{ perturb with sine {{ amplitude: {low}m..{high}m, "
        f"wavelength: {short}m..{long}m, phase: 0deg..360deg }} }}\n"
        "let away = deviation(bent, main)\n"
        "require kept: always (away > -1m)\n"
    )
    require = f"require near: always (away < {limit}m)\n{FEW}"
    try:
        roadlang.loads(text + require).sample()
    except roadlang.DiagnosticError as error:
        if error.diagnostics[0].code != "RL600":
            return
        with suppress(roadlang.NoSceneError):  # where every candidate folds
            scenes = roadlang.loads(text).sample(12)
            assert all(scene.signals["away"].values.max() >= limit for scene in scenes)
