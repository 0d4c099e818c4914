"""What people write who know Scenic or Python gets one error, with a line of help that says how."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from roadlang.diagnostics import Diagnostic
from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text

EXAMPLES = Path(__file__).parents[2] / "examples"
ROAD = (
    "road main { draw with waypoints { points: [(0m, 0m), (80m, 20m), (160m, 0m)] }, lanes: 2 }\n"
)
EGO = "agent ego is car on main at 5m { drive with pure_pursuit { speed: 12m/s } }\n"
LEAD = "agent lead is car on main at 25m { drive with lane_follow { speed: 9m/s } }\n"
PLAN = 'image plan from "town.png" { scale: 1m/px }\n'
BARE = "road other { draw with waypoints { points: [(0m, 0m), (80m, 20m)] }"
BENT = "road bent from main { perturb with bump { at: 50m, height: 1m, length: 9m } }"
GENTLE = "(curvature(main) < 1/m)"

HABITS = [
    # What is written, the code, a part of the help, what the fix puts in its place.
    (f"{EGO}expect e: always (ego.collided == 0)", "RL227", "`ego.contacts == 0`", None),
    (f"{EGO}expect e: always (ego.ttc > 2s)", "RL227", "`time_to_collision(ego, lead) > 2s`", None),
    (f"{EGO}expect e: always (thw(ego, ego) > 2s)", "RL225", "`time_headway(ego, lead)", None),
    (
        f"{EGO}expect e: always (ego.speed < main.speed_limit)",
        "RL233",
        "agents have it, as in `ego.speed_limit`",
        None,
    ),
    (
        f"{EGO}{LEAD}expect e: always (distance(ego, lead.position) > 5m)",
        "RL227",
        "`distance(ego, lead)` takes agents as they are",
        None,
    ),
    (f"{EGO}expect e: always (ego.speed in [3m/s, 9m/s])", "RL001", "`low <= x <= high`", None),
    (f"{EGO}expect e: eventually (ego at 100m)", "RL001", "`ego.station > 100m`", None),
    ("world { fog: 60m }", "RL220", "it is called `visibility`", None),
    ("agent p is pedestrian on sidewalk at 5m", "RL101", "{ lane: sidewalk }", None),
    (f"{PLAN}network t from plan {{ select: longest }}", "RL220", "{ select: longest }`", None),
    (
        "agent a is car on road(3) at 5m",
        "RL206",
        "NETWORK { select: road(3) }`",
        None,
    ),
    (f"{EGO}agent a is car on main at ego.station + 9m", "RL206", "`at ego.start + 20m`", None),
    (f"{BARE}, parking: 2m }}", "RL220", "`right: [drive, parking]`", None),
    (f"{BARE}, bike_lane: true }}", "RL220", "`right: [drive, bike]`", None),
    ("agent a is car on main at 5m { turn: left }", "RL220", "`route: left`", None),
    ("agent a is car on main at 5m { destination: (9m, 9m) }", "RL220", "`route: [(10m", None),
    (
        "agent a is car on main at 5m { drive with stop_at { station: 9m, duration: 10s } }",
        "RL220",
        "`while: time < 20s` says how long",
        None,
    ),
    ("ego = new Car on main", "RL002", "agent NAME is KIND on ROAD", None),
    ("agent a is bus { length: 18m } on main at 5m", "RL001", "one block behind the place", None),
    ("ego is car on main at 5m", "RL002", "agent NAME is KIND on ROAD", None),
    ("car ego on main at 5m", "RL002", "agent NAME is KIND on ROAD", None),
    ("x = 5m", "RL002", "`param x = value`", None),
    ("var x = 5m", "RL002", "`param NAME = value`", None),
    ("for i in range(5):", "RL002", "`count: 5`", None),
    ("while true { }", "RL002", "`count: 5`", None),
    ("terminate when ego.speed < 1m/s", "RL002", "`simulate { duration: 20s }`", None),
    ("do follow() until 5s", "RL002", "`drive with lane_follow`", None),
    ("take set_throttle(1)", "RL002", "`drive with lane_follow`", None),
    ("interrupt when 3 > 2:", "RL002", "`drive with lane_follow`", None),
    ("vehicle sut", "RL002", "agent NAME is KIND on ROAD", None),
    ("mutate ego by 2", "RL002", "`at 20m..30m`", None),
    ("record ego.position", "RL002", "`roadlang run`", None),
    ("if 3 > 2 { }", "RL002", "`choice(a, b)`", None),
    ("param w = if 3 > 2 then 1 else 2", "RL001", "`choice(a, b)`", None),
    ("param w = 1 if 3 > 2 else 2", "RL001", "`choice(a, b)`", None),
    ("param w = 3 > 2 ? 1 : 2", "RL006", "`choice(a, b)`", None),
    ("import street", "RL002", '`include "street.rl"`', None),
    ('import "lights.rl"', "RL002", '`include "street.rl"`', "include"),
    ("from street import road", "RL002", '`include "street.rl"`', None),
    ("def f(x):", "RL002", "`let NAME = value`", None),
    ("let f(x) = x + 1m", "RL001", "`let f = ...`", None),
    ("assert 3m > 2m", "RL002", "`require NAME: formula`", None),
    ("perturb main with sine { amplitude: 3m, wavelength: 90m }", "RL002", "perturb with", None),
    ("param w = Range(5, 10)", "RL225", "`5..10`", "5..10"),
    ("param w = Uniform(5m, 10m)", "RL225", "`5m..10m`", "5m..10m"),
    ("param w = Uniform(5m, 6m, 7m)", "RL225", "`choice(a, b)`", None),
    ("param w = Normal(5m, 1m)", "RL225", "did you mean `normal`", "normal"),
    ("param w = Range(5m..10m)", "RL225", "`5m..10m`", "5m..10m"),
    ("param w = Uniform(5m .. 10m)", "RL225", "`5m .. 10m`", "5m .. 10m"),
    ("param w = uniform(3m..5m)", "RL221", "write `3m..5m`, or `uniform(3m, 5m)`", None),
    ("param w = normal(3m .. 5m)", "RL221", "separated by commas", None),
    ("param w = VerifaiRange(5, 10)", "RL225", "`5..10`", "5..10"),
    ("param w = range(5m, 10m)", "RL225", "`5m..10m`", "5m..10m"),
    ("param w = DiscreteRange(5, 10)", "RL225", "integer", "integer"),
    ("param w = sqrt(4)", "RL225", "`x ^ 0.5`", None),
    ("param w = sin(2)", "RL225", "`abs`, `min` and `max`", None),
    ("param w = pi * 2", "RL101", "`180deg`", None),
    ('emit json to "out"', "RL001", "-o DIR", None),
    ('emit "json"', "RL001", "`emit json`", "json"),
    ("agent a is car on main at [5m, 20m]", "RL025", "5m..20m", "5m..20m"),
    ("agent a is car on main at 5m { lane: right }", "RL101", "OpenDRIVE", "-1"),
    ("agent a is car on main at 5m with speed 10m/s", "RL001", "in braces", None),
    ("agent a is car on main at 5m, facing 30deg", "RL001", "in braces", None),
    ("agent a is car on main at 5m { speed: 10m/s }", "RL220", "drive with pure_pursuit", None),
    ("agent a is car on main { ahead_of: a }", "RL220", "`at ahead_of(...)`", None),
    (
        "agent a is car on main at 5m { drive with traffic { start_speed: 5m/s } }",
        "RL220",
        "`start_speed` is an option of the agent",
        None,
    ),
    ("agent a is car on main at 5m { drive: stanley }", "RL220", "`drive with KIND", None),
    ("agent a is car on main at 5m { sense with lidar }", "RL210", "`sense with ranges`", None),
    ("object z is zebra_crossing on main at 5m", "RL210", "`crosswalk`: a zebra crossing", None),
    ("object zebra is zebra_crossing on main at 5m", "RL210", "`crosswalk`: a zebra", None),
    ("road r from main { right: [drive, bicycle] }", "RL210", "`bike`", "bike"),
    ("agent a is lorry on main at 5m", "RL210", "`truck`", "truck"),
    (
        "agent a is car on main at 5m { drive with FollowLane }",
        "RL210",
        "`lane_follow`",
        "lane_follow",
    ),
    (
        "agent a is car on main at 5m { drive with lane_keep }",
        "RL210",
        "`lane_follow`",
        "lane_follow",
    ),
    ("agent a is car on main at 5m { drive with mpc }", "RL210", "`drive with process`", None),
    ("agent a is sedan on main at 5m", "RL210", "`car`", "car"),
    ("object a is streetlight on main at 5m", "RL210", "`lamp`", "lamp"),
    (
        "road r from main { perturb with noise { amplitude: 2m, correlation: 20m } }",
        "RL210",
        "`random_walk`",
        "random_walk",
    ),
    ("network n from plan { extract with canny }\n" + PLAN, "RL210", "`contour`", "contour"),
    ("emit carla", "RL210", "`emit opendrive` (CARLA", None),
    ("emit xodr", "RL210", "`opendrive`", "opendrive"),
    ("emit xosc", "RL210", "`openscenario`", "openscenario"),
    ("road r from main { left: [pedestrian] }", "RL210", "the kinds of `lane` are", None),
    ("road r from main { center_marking: dashed }", "RL223", "`broken`", "broken"),
    ('image i from "town.png" { legend: { "#": street } }', "RL210", "`road`", "road"),
    (
        "network n from plan { control with traffic_lights }\n" + PLAN,
        "RL210",
        "`signals`",
        "signals",
    ),
    (
        "agent a is car on main at 5m { drive with brake { when: 3s } }",
        "RL206",
        "`time > 3s`",
        None,
    ),
    (
        "agent a is car on main at 5m { drive with brake { while: 3s } }",
        "RL206",
        "`time < 3s`",
        None,
    ),
    ("agent a is car on main at (5m, 0m)", "RL238", "leave `on main` out", None),
    ("object a is cone on main at 5m { drive with brake }", "RL216", "`agent`", None),
    ('include "street.rl" as a\noverride main { width: 8m }', "RL112", "", None),
    ('include "street.rl" as a\noverride street { width: 8m }', "RL101", "`a.street`", "a.street"),
    ("agent a is car on main at 5m { gap: 2m }", "RL220", "`at beside(..., gap: VALUE)`", None),
    ("road r from main { crosswalks: [5m] }", "RL220", "`object zebra is crosswalk", None),
    ("road r from main { crosswalk: 5m }", "RL220", "`object NAME is crosswalk on ROAD", None),
    ("agent a is car on main at 5m { sense with lid }", "RL210", "`sense` are `boxes`", None),
    ("agent a is car on main at 5m { length: 0m }", "RL208", "write more than `0m`", None),
    ("world { friction: 3 }", "RL208", "more than `0` and at most `2`", None),
    ("agent a is car on main", "RL236", "`at 20m`", None),
    ("agent t is traffic_light on main at 5m", "RL210", "`object NAME is traffic_light`", None),
    ("object t is car on main at 5m", "RL210", "`agent NAME is car`", None),
    ("object t is tree on main at 5m * index { count: 5 }", "RL101", "no index", None),
    ('object t is box on main at 5m { colour: "white" }', "RL220", "`color`", "color"),
    ("world { rain: 0.5 }", "RL202", "`0.5mm/h`", "0.5mm/h"),
    ("world { rain: heavy }", "RL101", "`5mm/h`", None),
    ("world { rain: 50% }", "RL201", "`5mm/h`", None),
    ("world { friction: 0.4-0.9 }", "RL208", "`0.4..0.9`", "0.4..0.9"),
    ("world { friction: 0.4 to 0.9 }", "RL001", "`0.4..0.9`", "0.4..0.9"),
    ("param w = 5metres", "RL203", "`5m`", "5m"),
    (EGO + "expect e: always (ego.cross_track < 5m)", "RL227", "now called", "cross_track_error"),
    (EGO + "expect e: always (ego.wobble < 5m)", "RL227", "its members are `lane`", None),
    (EGO + "expect e: always (speed(ego) < 5m/s)", "RL225", "`ego.speed`", None),
    (EGO + LEAD + "require r: ego.speed > 5m/s", "RL353", "`expect r: ...`", None),
    (EGO + "expect e: always (gap(ego, ego) > 5m)", "RL355", "", None),
    (
        EGO + "expect e: always (curvature(main) < 1/m and ego.speed < 9m/s)",
        "RL350",
        "write one `expect`",
        None,
    ),
    ("require r: always (main.curvature < 1/m)", "RL233", "`curvature(main)`", None),
    ("require r: always (|curvature(main)| < 1/m)", "RL001", "`abs(x)`", None),
    ("require r: always[60m, 20m] " + GENTLE, "RL305", "[20m, 60m]", "20m, 60m"),
    ("require r: always[-5m, 20m] " + GENTLE, "RL305", "`once`", "0, 20m"),
    ("require r: always (curvature(zebra) < 1/m)", "RL101", "declares `main`", None),
    ("road bent from main\nrequire r: length(bended) > 5m", "RL101", "`bent`", "bent"),
    (PLAN + "road a from plan", "RL228", "extract a network first", None),
    ("reach = 3m\nparam w = reach * 2", "RL002", "`param reach = value`", None),
    ("ego = new Car\nexpect e: always (ego.speed < 5m/s)", "RL002", "agent NAME is KIND", None),
    ("seed 7", "RL002", "`roadlang compile scene.rl --seed 7`", None),
    ("param float w = 5m\nparam v = w / 2s", "RL001", "`param w = ...`", None),
    ("road bent(main)", "RL001", "`road bent from main`", " from main"),
    ("road bent = main", "RL001", "`from`", "from"),
    ("agent a = car on main at 5m", "RL001", "`is`", "is"),
    ("param w = 3m...5m", "RL001", "two dots", ".."),
    ("world { time_of_day: 14:30 }", "RL001", "`14.5h`", "14.5h"),
    ('world { time_of_day: "14:30" }', "RL206", "`14h`", None),
    ("object b is building at 40m, 32m", "RL001", "`(40m, 32m)`", "(40m, 32m)"),
    (EGO + "agent a is car on main at 20m ahead of ego", "RL001", "`at ahead_of(ego, 20m)`", None),
    (EGO + "agent a is car on main at 2m behind ego", "RL001", "`at behind(ego, 2m)`", None),
    (EGO + "agent a is car ahead_of ego", "RL001", "`at ahead_of(ego, 10m)`", None),
    (
        "agent a is car on main at 5m { drive with brake then drive with walk }",
        "RL001",
        "in charge",
        None,
    ),
    (
        "agent a is car on main at 5m { drive with brake until time > 5s }",
        "RL001",
        "in charge",
        None,
    ),
    (
        "agent a is car on main at 5m { drive with brake { until: time > 5s } }",
        "RL001",
        "in charge",
        None,
    ),
    ("agent a is car on main at 5m { drive with brake for 5s }", "RL001", "in charge", None),
    (
        "agent a is car on main at 5m { drive with brake { after: 5s } }",
        "RL220",
        "`when: time > 5s`",
        None,
    ),
    (
        "agent a is car on main at 5m { drive with car_follow { time_gap: 2s } }",
        "RL220",
        "`headway`",
        None,
    ),
    ('network t { read with osm { file: "town.osm" } }', "RL220", 'from "town.osm"', None),
    ('network t from file("town.osm")', "RL225", 'from "town.osm"', None),
    ("road b { lane_width: 3.5m }", "RL220", "right: [drive(3.5m), drive(3.5m)]", None),
    (EGO + LEAD + "expect ttc: always (ttc(ego, lead) > 5s)", "RL226", "time_to_collision", None),
    (EGO + "agent a is car in front of ego", "RL001", "`at ahead_of(ego, 10m)`", None),
    (EGO + "agent a is car next to ego", "RL001", "`at beside(ego, right)`", None),
    (EGO + "agent a is car on main beside ego", "RL001", "`at beside(ego, right)`", None),
    (EGO + "agent a is car at behind ego by 4m", "RL001", "`at behind(ego, 4m)`", None),
    (EGO + "agent a is car following ego", "RL001", "`at ahead_of(ego, 10m)`", None),
    (EGO + "agent a is car following main from ego for 7m", "RL001", "`at behind(ego, 7m)`", None),
    (EGO + "agent a is car left of ego by 3m", "RL001", "`at beside(ego, left)`", None),
    (EGO + "agent a is car visible from ego", "RL001", "`at 20m..60m`", None),
    ("agent a is car offset by 3m", "RL001", "`{ offset: 3m }`", None),
    ("agent a is car on main at 5m facing 30deg", "RL001", "in braces", None),
    ("agent a is car on main at 5m { facing: 30deg }", "RL206", "`heading: 30deg`", None),
    ("agent a is car on main at 5m { facing: 0deg..9deg }", "RL206", "`heading: 0deg..9deg`", None),
    ("agent a is car on main at 5m { with speed 10 }", "RL001", "`start_speed: 10m/s`", None),
    ("agent a is car on main at 5m { with behavior F }", "RL001", "`drive with KIND", None),
    (EGO + LEAD + "expect e: always (ego can see lead)", "RL001", "`distance(ego, lead) <", None),
    (EGO + LEAD + "require r: ego can see lead", "RL001", "no formula says what is seen", None),
    (EGO + LEAD + "expect e: always (can_see(ego, lead))", "RL225", "`distance(ego, lead)", None),
    (
        EGO + LEAD + "expect e: always (distance from ego to lead > 2m)",
        "RL001",
        "`distance(ego, lead)`",
        None,
    ),
    (EGO + "expect e: always (distance to ego > 2m)", "RL001", "`distance(AGENT, ego)`", None),
    ("simulate with carla", "RL210", "`emit opendrive` (CARLA", None),
    ("simulate with Newtonian", "RL210", "a plugin brings other simulators", None),
    ("simulate with nowhere", "RL210", "are `builtin`, `godot`", None),
    ("road b { left: [drive { width: 3m }] }", "RL001", "`drive(width: 3m)`", None),
    (
        "road b { draw with polyline { points: [(0m, 0m), (9m, 0m)] } }",
        "RL210",
        "`draw with waypoints { curve: polyline }`",
        None,
    ),
    ("agent a is car on main at 5m { drive with stop_at { at: 9m } }", "RL220", "`station`", None),
    ("agent a is car on main at 5m { drive with brake { at: 9m } }", "RL220", "it has ", None),
    ("agent a is car at 5m\nagent b is car on main at a.start + 5m", "RL237", "", None),
    ("agent a is car on main at 5m { behavior stanley }", "RL001", "`drive with KIND", None),
    ("object b is box at (1m, 2m) { heading: 30°, height: 2m }", "RL203", "`30deg`", "30deg"),
    ("emit json, svg", "RL001", "for each output", None),
    ("emit json, svg, sbft", "RL001", "for each output", None),
    ('emit json to "out", svg to "maps"', "RL001", "`roadlang compile scene.rl -o DIR`", None),
    (
        "agent a is car on main at 5m with speed 9m/s, facing 3deg",
        "RL001",
        "options are written in braces",
        None,
    ),
    (
        "agent a is car on main at 5m with speed 9m/s with width 2m",
        "RL001",
        "options are written in braces",
        None,
    ),
    ("emit svg(size: 800px)", "RL001", "in braces: `svg {", None),
    ("emit with json", "RL001", "`emit json`", None),
    ('scenario "A bend"', "RL001", "a name and a title", None),
    ("scenario bend A bend", "RL001", "a name and a title", None),
    ("require r: globally " + GENTLE, "RL021", "`always`", "always"),
    ("require r: finally " + GENTLE, "RL021", "`eventually`", "eventually"),
    ("require r: always (curvature(main).abs() < 1/m)", "RL001", "`abs(x)`", None),
    ("require r: always (curvature(main) < 10m)", "RL205", "`curvature(main)` is in 1/m", None),
    (
        EGO + "expect e: eventually (ego.progress > 50m)",
        "RL205",
        "`ego.route_progress` is a length",
        None,
    ),
    (EGO + "expect e: eventually (ego.route_progress > 0.5)", "RL202", "`0.5m`", "0.5m"),
    (
        EGO + "expect e: always (ego.progress + 1m < 9m)",
        "RL205",
        "has no unit and `1m` is in m",
        None,
    ),
    (EGO + "expect e: always (ego.lane < 1m)", "RL205", "`ego.lane_offset` is a length", None),
    (EGO + "expect e: always (not collides(ego, main))", "RL225", "ego.contacts", None),
    (
        "falsify with halton { sigma: 0.3 }",
        "RL220",
        "`sigma` is an option of `falsify with cma`",
        None,
    ),
    (BENT.replace("9m", "[5m, 9m]"), "RL206", "`5m..9m`", "5m..9m"),
    (BENT.replace("9m", "(5m, 9m)"), "RL206", "`5m..9m`", "5m..9m"),
    (BENT.replace("9m", "9m, over: 2m..90m"), "RL206", "`[2m, 90m]`", "[2m, 90m]"),
    (BENT + "\nrequire r: bent.length(main) < 5m", "RL225", "`length(bent, main)`", None),
    (BENT + "\nrequire r: always (deviation(bent - main) < 5m)", "RL206", "", None),
]


def found_in(text: str, folder: Path) -> list[Diagnostic]:
    for name in ("town.png", "street.rl"):
        shutil.copy(EXAMPLES / name, folder)
    (folder / "lights.rl").write_text("param lights = 3\n")
    _, found = check_text(text, folder / "scene.rl", {}, load_registry())
    return [diagnostic for diagnostic in found if diagnostic.is_error]


@pytest.mark.parametrize("case", HABITS, ids=lambda case: case[0])
def test_a_habit_of_another_language_gets_one_error_with_help(
    case: tuple[str, str, str, str | None], tmp_path: Path
) -> None:
    text, code, help, replacement = case
    source = ROAD + text + "\n"
    found = found_in(source, tmp_path)
    assert [diagnostic.code for diagnostic in found] == [code]
    assert help in "\n".join(found[0].help)
    assert [fix.replacement for fix in found[0].fixes[:1]] == [replacement] * bool(replacement)
    for fix in found[0].fixes[:1]:
        mended = source[: fix.span.start] + fix.replacement + source[fix.span.end :]
        assert found_in(mended, tmp_path) == []


def test_a_lone_equals_sign_is_one_fault_not_two(tmp_path: Path) -> None:
    text = ROAD + "require r: always (curvature(main) = 1/m)\n"
    _, found = check_text(text, tmp_path / "scene.rl", {}, load_registry())
    assert [diagnostic.code for diagnostic in found] == ["RL010"]
    _, found = check_text(text.replace("=", "=="), tmp_path / "scene.rl", {}, load_registry())
    assert [diagnostic.code for diagnostic in found] == ["RL291"]


@pytest.mark.parametrize(
    ("formula", "help_"),
    [
        ("length(main) == 90m", "abs(length(main) - (90m)) < TOLERANCE`"),
        ("length(main) != 0m", "abs(length(main)) > TOLERANCE`"),
    ],
)
def test_equality_of_computed_numbers_gets_a_tolerance(formula: str, help_: str) -> None:
    _, found = check_text(ROAD + f"require r: {formula}\n", Path("a.rl"), {}, load_registry())
    assert help_ in next(each for each in found if each.code == "RL291").help[0]


def test_no_collision_is_said_by_contacts() -> None:
    text = ROAD + EGO + "expect r: always (ego.collision == 0m/s)\n"
    _, found = check_text(text, Path("a.rl"), {}, load_registry())
    assert "`abs(ego.collision) < TOLERANCE`, or `ego.contacts == 0`" in found[0].help[0]


@pytest.mark.parametrize(
    ("value", "found"),
    [("-1m..3m", "it can be -1m"), ("-1m", "it is -1m"), ("0m..3m", None), ("0m", None)],
)
def test_a_range_that_reaches_beyond_a_limit_says_what_it_can_be(
    value: str, found: str | None, tmp_path: Path
) -> None:
    passes = f"perturb with harmonics {{ amplitude: {value} }}"
    diagnostics = found_in(ROAD + f"road bent from main {{ {passes} }}\n", tmp_path)
    expected = [] if found is None else [f"`amplitude` must be at least 0m, but {found}"]
    assert [diagnostic.message for diagnostic in diagnostics] == expected


@pytest.mark.parametrize("value", ["0m", "0m..5m"])
def test_a_limit_that_is_excluded_is_too_little(value: str, tmp_path: Path) -> None:
    passes = f"perturb with sine {{ amplitude: 1m, wavelength: {value} }}"
    (found,) = found_in(ROAD + f"road bent from main {{ {passes} }}\n", tmp_path)
    assert found.code == "RL208"
    assert "greater than 0m" in found.message


@pytest.mark.parametrize(
    ("over", "taper"),
    [("[10m, 30m]", "5m"), ("[10m, 90m]", "10m"), ("[9m, 2 * 20m]", "10m"), ("[0m, 40m]", "10m")],
)
def test_an_abrupt_interval_gets_a_taper_of_a_quarter_of_its_length_or_10_m(
    over: str, taper: str, tmp_path: Path
) -> None:
    perturb = f"perturb with sine {{ amplitude: 1m, wavelength: 50m, over: {over} }}"
    text = ROAD + f"road bent from main {{ {perturb} }}\n"
    _, (warning,) = check_text(text, tmp_path / "scene.rl", {}, load_registry())
    assert warning.code == "RL193"
    assert [fix.replacement for fix in warning.fixes] == [f"over: {over}, taper: {taper}"]
