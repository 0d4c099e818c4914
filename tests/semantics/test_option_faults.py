"""One fault in an option: one error, under exactly the text that is wrong, with its fix."""

from __future__ import annotations

import pytest

from roadlang import DiagnosticError, testing

DRAWN = "draw with waypoints { points: [(0m, 0m), (300m, 0m)] }"
ROAD = f"road main {{ {DRAWN}, lanes: 4 }}\n"
LEAD = ROAD + "agent lead is car on main at 90m { drive with car_follow }\n"
EGO = "agent ego is car on main at 20m { drive with car_follow }\n"
PLAN = '''image plan from """
...#........#...
################
...#............
""" { scale: 20m/px, legend: { "#": road } }
'''
TOWN = PLAN + "network town from plan\n"

SECTIONS = f"road main {{ {DRAWN}, % }}\n"
CONTROL = PLAN + "network town from plan { % }\n"
OPTIONS = LEAD + "agent ego is car on main at 20m { % }\n"
IN_OUTER_LANE = LEAD + "agent ego is car on main at 20m { lane: -2, % }\n"
PLACES = LEAD + EGO + "agent b is car %\n"
ROUTES = TOWN + "agent ego is car on town { % }\n"
IN_TOWN = TOWN + "agent ego is car on town at %\n"
EXPECT = LEAD + EGO + "expect e: always (%)\n"
JOINED = f"road wide {{ {DRAWN} }}\nroad narrow {{ {DRAWN} }}\nroad both from wide {{ % }}\n"
LEGEND = PLAN.replace('"#": road', '"#": %') + "network n from plan\n"
FALSIFY = LEAD + EGO + "expect e: always (ego.speed > 1m/s)\nfalsify %\n"

# The scene, what is written at its %, the code, the text that is underlined, the fix.
FAULTS = [
    (SECTIONS, "right: [drive(3.5m), bikee(1.5m)]", "RL210", "bikee", "bike"),
    (SECTIONS, "right: [drive(3.5m, marking: brokn)]", "RL223", "brokn", "broken"),
    (SECTIONS, "right: [drive(wdth: 3m)]", "RL220", "wdth", "width"),
    (SECTIONS, "right: [drive(3.5)]", "RL202", "3.5", "3.5m"),
    (SECTIONS, "right: [drive(3.5s)]", "RL201", "3.5s", None),
    (SECTIONS, "onewy: true", "RL220", "onewy", "oneway"),
    (SECTIONS, "center_marking: solidd", "RL223", "solidd", "solid"),
    (SECTIONS, "sidewalk: 2m", "RL220", "sidewalk", "sidewalks"),
    (SECTIONS, "lanes: 2.5", "RL230", "2.5", None),
    (CONTROL, "width: 7m", "RL220", "width", None),
    (CONTROL, "extract with auto { widht: 7m }", "RL220", "widht", "width"),
    (CONTROL, "control with signls", "RL210", "signls", "signals"),
    (CONTROL, "control wih stop", "RL021", "wih", "with"),
    (CONTROL, "control with signals { gren: 18s }", "RL220", "gren", "green"),
    (CONTROL, "control with signals { green: 18m }", "RL201", "18m", None),
    (CONTROL, "control with signals { green: -1s }", "RL208", "-1s", None),
    (CONTROL, "control with signals { junctions: 1 }", "RL206", "1", "[1]"),
    (CONTROL, "control with signals { junctions: [1.5] }", "RL230", "1.5", None),
    (CONTROL, "control with stop { junction: [1] }", "RL220", "junction", "junctions"),
    (OPTIONS, "drive with traffic, drive with overtake { target: ego }", "RL228", "ego", None),
    (OPTIONS, "apart: 2", "RL202", "2", "2m"),
    (OPTIONS, "apart: -1m", "RL208", "-1m", None),
    (OPTIONS, "aprt: 2m", "RL220", "aprt", "apart"),
    (OPTIONS, "count: 3, spcing: 9m", "RL220", "spcing", "spacing"),
    (OPTIONS, "count: 2, spacing: 20km", "RL208", "20km", None),
    (OPTIONS, "spacing: 5m", "RL249", "5m", None),
    (OPTIONS, "count: 3, spacing: 5", "RL202", "5", "5m"),
    (OPTIONS, "count: -3, spacing: 5m", "RL208", "-3", None),
    (OPTIONS, "lane: 7", "RL613", "7", None),
    (OPTIONS, "drive with traffic, drive with change_lane { to: -4 }", "RL613", "-4", None),
    (OPTIONS, "drive with traffic, drive with merge { to: 0 }", "RL613", "0", None),
    (OPTIONS, "lane: outr", "RL223", "outr", "outer"),
    (OPTIONS, "lane: lead.lane", "RL231", "lead.lane", None),
    (OPTIONS, "facing: backward", "RL223", "backward", "back"),
    (OPTIONS, "route: random", "RL250", "route: random", None),
    (PLACES, "at ahed_of(ego, 20m)", "RL225", "ahed_of", "ahead_of"),
    (PLACES, "at ahead_of(eggo, 20m)", "RL101", "eggo", "ego"),
    (PLACES, "at ahead_of(ego)", "RL221", "ahead_of(ego)", None),
    (PLACES, "at ahead_of(ego, 20s)", "RL201", "20s", None),
    (PLACES, "at ahead_of(ego, -2m)", "RL208", "-2m", None),
    (PLACES, "at ahead_of(main, 20m)", "RL228", "main", None),
    (PLACES, "at beside(ego, lft)", "RL223", "lft", "left"),
    (PLACES, "at beside(ego)", "RL221", "beside(ego)", None),
    (PLACES, "on main at rndom", "RL101", "rndom", "random"),
    (PLACES, "on main at junction(1)", "RL206", "junction(1)", None),
    (PLACES, "on main at 400m", "RL615", "400m", None),
    (PLACES, "on main at 130%", "RL615", "130%", None),
    (IN_TOWN, "rndom", "RL101", "rndom", "random"),
    (IN_TOWN, "junction(1.5)", "RL230", "1.5", None),
    (IN_TOWN, "junction(1, rod: 3)", "RL220", "rod", "road"),
    (IN_TOWN, "20m", "RL251", "20m", None),
    (ROUTES, "route: randm", "RL223", "randm", "random"),
    (ROUTES, "route: (10m, 20m)", "RL206", "(10m, 20m)", None),
    (ROUTES, "route: []", "RL208", "[]", None),
    (ROUTES, "route: [(10m, 20m), juncton(1)]", "RL210", "juncton", "junction"),
    (ROUTES, "route: [(10m, 20m), junction(1, befor: 3m)]", "RL220", "befor", "before"),
    (ROUTES, "route: random, route_length: 300", "RL202", "300", "300m"),
    (ROUTES, "route: random, route_lenth: 300m", "RL220", "route_lenth", "route_length"),
    (ROUTES, "route: random, route_length: 0m", "RL208", "0m", None),
    (OPTIONS, "drive with trafic", "RL210", "trafic", "traffic"),
    (OPTIONS, "drive with traffic { politness: 0.5 }", "RL220", "politness", "politeness"),
    (OPTIONS, "drive with traffic { aggression: 2 }", "RL208", "2", None),
    (OPTIONS, "drive with change_lane", "RL221", "change_lane", None),
    (IN_OUTER_LANE, "drive with change_lane { to: lft }", "RL223", "lft", "left"),
    (OPTIONS, "drive with change_lane { to: 2m }", "RL201", "2m", None),
    (OPTIONS, "drive with cut_in { target: laed }", "RL101", "laed", "lead"),
    (OPTIONS, "drive with cut_in { target: main }", "RL228", "main", None),
    (OPTIONS, "drive with cut_in { target: lead, gap: 8s }", "RL201", "8s", None),
    (OPTIONS, "drive with overtake { target: lead, withn: 50m }", "RL220", "withn", "within"),
    (OPTIONS, "drive with overtake { target: lead, gap: 0m }", "RL208", "0m", None),
    (IN_OUTER_LANE, "drive with merge { within: 150 }", "RL202", "150", "150m"),
    (OPTIONS, "drive with merge { into: left }", "RL220", "into", None),
    (OPTIONS, "drive with stop_at { station: 50s }", "RL201", "50s", None),
    (OPTIONS, "drive with stop_at { distnce: 5m }", "RL220", "distnce", "distance"),
    (OPTIONS, "drive with speed_profile", "RL221", "speed_profile", None),
    (OPTIONS, "drive with speed_profile { points: [] }", "RL208", "[]", None),
    (OPTIONS, "drive with speed_profile { points: [(0m, 5m)] }", "RL201", "5m", None),
    (OPTIONS, "drive with walk { along: sidewalks }", "RL223", "sidewalks", "sidewalk"),
    (OPTIONS, "drive with walk { speed: 1.4 }", "RL202", "1.4", "1.4m/s"),
    (OPTIONS, 'drive with replay { file: "none.csv" }', "RL450", '"none.csv"', None),
    (OPTIONS, "drive with replay", "RL221", "replay", None),
    (OPTIONS, 'drive with process { command: "prog" }', "RL206", '"prog"', '["prog"]'),
    (OPTIONS, "drive with replay { file: 3m }", "RL206", "3m", None),
    (OPTIONS, 'drive with process { comand: ["prog"] }', "RL220", "comand", "command"),
    (OPTIONS, 'drive with process { command: ["prog"], timeout: 0s }', "RL208", "0s", None),
    (EXPECT, "ego.lan == -1", "RL227", "lan", "lane"),
    (EXPECT, "ego.lane == -1m", "RL205", "-1m", None),
    (EXPECT, "ego.red_ligth == 0", "RL227", "red_ligth", "red_light"),
    (EXPECT, "ego.speed_limt > 1m/s", "RL227", "speed_limt", "speed_limit"),
    (EXPECT, "time_headway(ego) > 1s", "RL221", "time_headway(ego)", None),
    (EXPECT, "time_headway(ego, lead) > 1m", "RL205", "1m", None),
    (EXPECT, "time_hedway(ego, lead) > 1s", "RL225", "time_hedway", "time_headway"),
    (EXPECT, "time_headway(ego, leed) > 1s", "RL101", "leed", "lead"),
    (EXPECT, "ego.time_headway > 1s", "RL227", "time_headway", None),
    (EXPECT, "main.lane == 1", "RL233", "lane", None),
    (JOINED, "then: narow", "RL101", "narow", "narrow"),
    (JOINED, "then: [narrow, wde]", "RL101", "wde", "wide"),
    (JOINED, "then: 3m", "RL206", "3m", None),
    (JOINED, "then: []", "RL208", "[]", None),
    (JOINED, "thn: narrow", "RL220", "thn", "then"),
    (JOINED, "then: narrow, taper: 3s", "RL201", "3s", None),
    (JOINED, "then: narrow, taper: 30", "RL202", "30", "30m"),
    (JOINED, "then: narrow, taper: 0m", "RL208", "0m", None),
    (JOINED, "taper: 3m", "RL219", "taper", None),
    (LEGEND, "eastbond", "RL210", "eastbond", "eastbound"),
    (LEGEND, "notrhbound", "RL210", "notrhbound", "northbound"),
    (FALSIFY, "with randon", "RL210", "randon", "random"),
    (FALSIFY, "wth random", "RL021", "wth", "with"),
    (FALSIFY, "with random { evalutions: 3 }", "RL220", "evalutions", "evaluations"),
    (FALSIFY, "with random { evaluations: 3m }", "RL201", "3m", None),
    (FALSIFY, "with random { seconds: 3 }", "RL202", "3", "3s"),
    (FALSIFY, "with random { evaluations: integer(9, 20) }", "RL229", "integer(9, 20)", None),
    (FALSIFY, "with random { seconds: 3s..5s }", "RL229", "3s..5s", None),
    (FALSIFY, "with cma { sigma: 0.1..0.2 }", "RL229", "0.1..0.2", None),
]


@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault[1])
def test_one_fault_is_one_error_under_what_is_wrong(
    fault: tuple[str, str, str, str, str | None],
) -> None:
    scene, written, code, underlined, fix = fault
    text = scene.replace("%", written, 1)
    found = [diagnostic for diagnostic in testing.check(text) if diagnostic.is_error]
    assert [diagnostic.code for diagnostic in found] == [code]
    span = found[0].span
    assert span is not None
    start = scene.index("%") + written.rindex(underlined)
    assert (span.start, span.text) == (start, underlined)
    assert [fix.replacement for fix in found[0].fixes[:1]] == ([fix] if fix else [])
    for change in found[0].fixes[:1]:
        mended = text[: change.span.start] + change.replacement + text[change.span.end :]
        assert not [diagnostic for diagnostic in testing.check(mended) if diagnostic.is_error]


def test_the_width_of_a_network_is_an_option_of_what_reads_it() -> None:
    (found,) = testing.check(CONTROL.replace("%", "width: 7m"))
    assert "`extract with auto { width: 7m }`" in found.help[0]
    assert not testing.check(CONTROL.replace("%", "extract with auto { width: 7m }"))


@pytest.mark.parametrize(
    ("written", "code", "underlined"),
    [
        ("at (900m, 900m)", "RL617", "(900m, 900m)"),
        ("{ route: [(40m, 30m), (900m, 900m)] }", "RL617", "(900m, 900m)"),
        ("{ route: [(900m, 900m), (40m, 30m)] }", "RL617", "(900m, 900m)"),
        ("at (40m, 30m) { route: [(99m, 30m), (900m, 900m)] }", "RL617", "(900m, 900m)"),
        ("{ route: [(10m, 30m), (99m, 30m)], facing: back }", "RL618", "(99m, 30m)"),
        ("at random { lane: 9 }", "RL613", "9"),
    ],
)  # fmt: skip
def test_faults_of_a_built_network_are_under_the_option_too(
    written: str, code: str, underlined: str
) -> None:
    with pytest.raises(DiagnosticError) as caught:
        testing.sample(TOWN + f"agent ego is car on town {written}\n")
    (found,) = caught.value.diagnostics
    assert (found.code, found.span.text if found.span else None) == (code, underlined)


def test_widths_that_disagree_are_said_to_a_tenth_of_a_millimeter() -> None:
    lanes = "left: [drive(3.33333m)], right: [drive(3.33333m)], width: 9m"
    text = "road main { draw with segments { pieces: [straight(99m)] }, LANES }"
    (found,) = testing.check(text.replace("LANES", lanes))
    assert found.code == "RL246"
    assert "`main` add up to 6.6667m, but `width` is 9m" in found.message


def test_a_condition_of_a_controller_is_written_in_its_block() -> None:
    (found,) = testing.check(OPTIONS.replace("%", "drive with brake, when: lead.speed < 1m/s"))
    assert found.code == "RL220"
    assert "write it in the block of `drive with`" in found.help[0]


def test_a_member_of_agents_is_shown_as_it_is_written() -> None:
    (found,) = testing.check(EXPECT.replace("%", "heading(ego) < 1rad"))
    assert found.code == "RL227"
    assert "`agent.heading`" in found.help[0]
    assert "heading(agent)" not in found.help[0]
