# ruff: noqa: E501 (one fault, one line)
"""One fault in a sample: the right code at the right place, and nothing else."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from roadlang.diagnostics import Source
from roadlang.syntax import parse
from roadlang.syntax.tree import statements as ast

SAMPLES = Path(__file__).parent / "samples"

# sample, what is written there, what is written instead, code, text at which it is reported
FAULTS = [
    ('paper', 'road main', 'raod main', 'RL002', 'raod'),
    ('paper', 'road bent', 'roads bent', 'RL002', 'roads'),
    ('paper', 'require phi1', 'requir phi1', 'RL002', 'requir'),
    ('paper', 'emit json', 'emitt json', 'RL002', 'emitt'),
    ('paper', 'agent ego', 'agnet ego', 'RL002', 'agnet'),
    ('paper', 'image photo', 'imgae photo', 'RL002', 'imgae'),
    ('paper', 'let e1', 'lte e1', 'RL002', 'lte'),
    ('paper', 'param reach', 'parm reach', 'RL002', 'parm'),
    ('paper', 'perturb with', 'perturb wiht', 'RL021', 'wiht'),
    ('paper', 'drive with', 'drive whit', 'RL021', 'whit'),
    ('paper', 'network town from', 'network town form', 'RL021', 'form'),
    ('paper', 'main from town', 'main fro town', 'RL021', 'fro'),
    ('paper', 'ego is car', 'ego si car', 'RL021', 'si'),
    ('paper', 'ego is car', 'ego: car', 'RL001', ': car'),
    ('paper', 'ego is car', 'ego = car', 'RL001', '= car'),
    ('paper', 'ego is car', 'ego = new car', 'RL001', '= new'),
    ('paper', 'network town from', 'network town:', 'RL001', ': photo'),
    ('paper', 'on bent at', 'on bent ta', 'RL021', 'ta'),
    ('paper', 'car on bent', 'car no bent', 'RL021', 'no'),
    ('paper', 'always (e1 < 10m)', 'alwyas (e1 < 10m)', 'RL021', 'alwyas'),
    ('paper', 'always (e1 < 10m)', 'allways (e1 < 10m)', 'RL021', 'allways'),
    ('paper', 'eventually[20m, 60m]', 'eventualy[20m, 60m]', 'RL021', 'eventualy'),
    ('paper', 'implies', 'implise', 'RL021', 'implise'),
    ('paper', 'implies', 'impies', 'RL021', 'impies'),
    ('paper', 'd1 < 6m and e1', 'd1 < 6m adn e1', 'RL021', 'adn'),
    ('paper', 'require phi1: always (e1 < 10m)', 'require phi1: with margin {}', 'RL001', ':'),
    ('paper', '{ scale: 0.35m/px }', 'scale: 0.35m/px }', 'RL001', 'scale'),
    ('paper', 'require phi1: always (e1 < 10m)', 'require phi1: always (e1 < 10m', 'RL003', '(e1'),
    ('paper', 'require phi1: always (e1 < 10m)', 'require phi1: always e1 < 10m)', 'RL004', ')'),
    ('paper', '[20m, 60m]', '[20m, 60m', 'RL003', '[20m'),
    ('paper', 'deviation(bent, main)', 'deviation(bent, main', 'RL003', '(bent'),
    ('paper', 'deviation(bent, main)', 'deviation bent, main)', 'RL001', 'bent, main)'),
    ('paper', 'speed: 12m/s', 'speed 12m/s', 'RL001', '12m/s'),
    ('paper', 'speed: 12m/s', 'speed = 12m/s', 'RL010', '= 12m'),
    ('paper', 'param reach = 8m', 'param reach: 8m', 'RL010', ': 8m'),
    ('paper', 'param reach = 8m', 'param reach 8m', 'RL001', '8m'),
    ('paper', 'require phi1:', 'require phi1 =', 'RL010', '= always'),
    ('paper', 'require phi1:', 'require phi1', 'RL001', 'always (e1'),
    ('paper', 'require phi1:', 'require', 'RL023', 'require always'),
    ('paper', '7m,', '7 m,', 'RL009', '7 m'),
    ('paper', '10m)', '10 m)', 'RL009', '10 m'),
    ('paper', '95%', '95 %', 'RL009', '95 %'),
    ('paper', '0.35m/px', '0.35 m/px', 'RL009', '0.35 m'),
    ('paper', '0.1/m', '.1/m', 'RL008', '.1'),
    ('paper', '"hairpin.jpg"', '"hairpin.jpg', 'RL005', '"hairpin'),
    ('paper', '"hairpin.jpg"', 'hairpin.jpg"', 'RL005', '" {'),
    ('paper', '"hairpin.jpg"', "'hairpin.jpg'", 'RL006', "'hairpin"),
    ('paper', 'always (e1 < 10m)', 'always (e1 < )', 'RL001', ')\nrequire phi2'),
    ('paper', 'always (e1 < 10m)', 'always (< 10m)', 'RL001', '< 10m'),
    ('paper', 'always (e1 < 10m)', 'always e1 < 10m and d1 < 3m', 'RL015', 'always e1'),
    ('paper', 'always (e1 < 10m)', '\\Box (e1 < 10m)', 'RL019', '\\Box'),
    ('paper', 'always (e1 < 10m)', 'G_{[0,10]} (e1 < 10m)', 'RL019', 'G_'),
    ('paper', 'always (e1 < 10m)', '□ (e1 < 10m)', 'RL006', '□'),
    ('paper', '0m..reach', '0m..reach..3m', 'RL017', '0m..'),
    ('paper', '0m..reach', '0m..reach + 2m', 'RL016', '0m..'),
    ('paper', 'select: longest, width', 'select: longest width', 'RL014', 'width'),
    ('paper', 'emit json\n', 'emit json emit csv\n', 'RL013', 'emit csv'),
    ('paper', 'road main from', 'road image from', 'RL012', 'image from'),
    ('paper', 'road main from', 'road with from', 'RL011', 'with from'),
    ('paper', 'param reach', 'param and', 'RL011', 'and'),
    ('paper', '[20m, 60m]', '[20m..60m]', 'RL026', '[20m'),
    ('paper', 'always[0m, 15m]', 'always[15m]', 'RL026', '[15m]'),
    ('paper', 'width: 7m,', 'width: ,', 'RL001', ', lanes'),
    ('paper', 'width: 7m,', 'width 7m, ', 'RL001', '7m'),
    ('paper', 'width: 7m,', 'width: 7m,,', 'RL001', ', lanes'),
    ('paper', 'from town { select', 'from { select', 'RL001', '{ select'),
    ('paper', 'agent ego is car', 'agent ego car', 'RL001', 'car on'),
    ('paper', 'car on bent at 5m', 'car at 5m on bent', 'RL022', 'on bent'),
    ('paper', 'perturb with sine', 'perturb sine', 'RL001', 'sine'),
    ('paper', 'emit svg {', 'emit {', 'RL001', '{ size'),
    ('paper', 'emit svg {', 'emit with svg {', 'RL001', 'with svg'),
    ('paper', 'lp_distance(bent, main, 2) <', 'lp_distance(bent, main, 2) <<', 'RL001', '< 90'),
    ('paper', 'e1 > 6m implies', 'e1 > 6m impl', 'RL021', 'impl'),
    ('grid_town', '{ "#": road, "T"', '{ "#": road "T"', 'RL014', '"T"'),
    ('grid_town', '"#2e7d32": tree', '#2e7d32: tree', 'RL028', '#2e7d32'),
    ('traffic', 'ego.start + gap {', 'ego.start + 10m..30m {', 'RL016', '10m..30m {'),
    ('traffic', '  drive with car_follow { headway: 1.5s }\n}', '  drive with car_follow { headway: 1.5s \n}', 'RL003', '{ headway'),
    ('traffic', '{ headway: 1.5s }', '{ headway: }', 'RL001', '}\n}\nagent onc'),
    ('traffic', 'count: integer(0, 3),', 'count: integer(0, 3,', 'RL003', '(0, 3'),
    ('traffic', 'distance(ego, walker) > 1m and', 'distance(ego walker) > 1m and', 'RL001', 'walker) > 1m and'),
    ('traffic', 'include "street.rl"', 'include street.rl', 'RL001', 'street.rl'),
]  # fmt: skip


def broken(sample: str, written: str, instead: str) -> tuple[Source, int]:
    """The sample with the fault, and the offset of the fault."""
    text = (SAMPLES / f"{sample}.rl").read_text()
    assert written in text
    return Source(f"{sample}.rl", text.replace(written, instead, 1)), text.index(written)


@pytest.mark.parametrize(("sample", "written", "instead", "code", "at"), FAULTS)
def test_a_fault_is_reported_once_and_in_place(
    sample: str, written: str, instead: str, code: str, at: str
) -> None:
    source, near = broken(sample, written, instead)
    _, found = parse(source)
    place = source.position(source.text.index(at, max(0, near - 1)))
    assert [(d.code, (d.span.line, d.span.column)) for d in found if d.span] == [(code, place)]


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("eventually(0s..90s) (p)", "[0s, 90s]"),
        ("always(0s..10s) x < 5m/s", "[0s, 10s]"),
        ("always(0s, 10s) not (p)", "[0s, 10s]"),
        ("(p) until(0s..5s) (q)", "[0s, 5s]"),
        ("eventually[0s..90s] x < 5m/s", "[0s, 90s]"),
    ],
)
def test_an_interval_of_another_form_is_shown_in_brackets(written: str, said: str) -> None:
    _, (fault,) = parse(Source("a.rl", f"expect a: {written}\nexpect b: always (p)\n"))
    assert (fault.code, fault.help) == ("RL026", (f"write `{said}`",))


@pytest.mark.parametrize("seed", range(20))
def test_three_independent_faults_are_all_reported(seed: int) -> None:
    text = (SAMPLES / "paper.rl").read_text()
    faults = random.Random(seed).sample([fault for fault in FAULTS if fault[0] == "paper"], 12)
    by_line = {text.count("\n", 0, text.index(fault[1])): fault for fault in faults}
    chosen = list(by_line.values())[:3]
    for _, written, instead, _, _ in chosen:
        text = text.replace(written, instead, 1)
    _, found = parse(Source("three.rl", text))
    assert sorted(d.code for d in found) == sorted(fault[3] for fault in chosen)


def test_several_faults_within_one_block_are_all_reported() -> None:
    text = """road bent from main {
  perturb with sine { amplitude 0m..8m, wavelength: , phase: 0deg }
  width = 7m
  lanes: 2
  perturb wiht scale { factor: (2 }
}
"""
    tree, found = parse(Source("block.rl", text))
    assert [(d.code, d.span.line) for d in found if d.span] == [
        ("RL001", 2),
        ("RL001", 2),
        ("RL010", 3),
        ("RL021", 5),
        ("RL003", 5),
    ]
    (road,) = tree.statements
    assert isinstance(road, ast.Geometry)
    block = road.block
    assert block is not None
    assert [option.key.text for option in block.options] == ["width", "lanes"]
    assert [call.block and call.block.complete for call in block.passes] == [False, False]


def test_a_misspelled_statement_still_declares_its_name() -> None:
    tree, found = parse(Source("raod.rl", "raod main from town\n"))
    assert found[0].fixes[0].replacement == "road"
    (road,) = tree.statements
    assert isinstance(road, ast.Geometry)
    assert road.name.text == "main"


def test_an_unreadable_statement_leaves_its_name() -> None:
    tree, _ = parse(Source("let.rl", "let e1 = deviation(\nlet e2 = 3m\n"))
    assert [word.text for word in tree.spoiled] == ["e1"]
    (let,) = tree.statements
    assert isinstance(let, ast.Let)
    assert let.name.text == "e2"


UNCLOSED = """road main {
  draw with waypoints { points: [(0m, 0m), (90m, 0m)]
  width: 8m
}
road other { draw with waypoints { points: [(0m, 0m), (90m, 0m)] }
lanes: 2
"""


def test_what_follows_on_a_line_of_its_own_belongs_to_the_block_around() -> None:
    """It is an option of the road, not of the waypoints; where there is none around, of the one
    that is not closed."""
    tree, found = parse(Source("unclosed.rl", UNCLOSED))
    assert [each.code for each in found] == ["RL003", "RL003"]
    main, other = tree.statements
    for road, option in ((main, "width"), (other, "lanes")):
        assert isinstance(road, ast.Geometry)
        assert road.block is not None
        assert [item.key.text for item in road.block.options] == [option]


def test_both_readings_are_offered_as_fixes() -> None:
    _, (found,) = parse(Source("p.rl", "require a: always p and q"))
    assert [fix.replacement for fix in found.fixes] == ["always (p) and q", "always (p and q)"]


@pytest.mark.parametrize(
    "formula", ["always (p) and q", "q and always p", "G F (p) <-> O (q)", "not always (p) or q"]
)
def test_parentheses_that_suffice(formula: str) -> None:
    assert parse(Source("p.rl", f"require a: {formula}"))[1] == []


def test_letters_of_the_literature_are_names_elsewhere() -> None:
    text = "let F = width(a)\nlet S = 1\nrequire b: G (F > 3m) U[0s, 1s] (S > s)\n"
    assert parse(Source("letters.rl", text))[1] == []
    text = "world {\n  a: S\n  U: 3\n  S with x\n  G: F\n}\n"
    assert parse(Source("letters.rl", text))[1] == []


def test_statement_words_are_free_as_keys_members_and_arguments() -> None:
    text = "emit godot { road: mesh, from: a.is, at: f(on: 1, image: 2) }\n"
    assert parse(Source("words.rl", text))[1] == []


def test_latex_is_shown_in_words() -> None:
    text = r"require a: \Box_{[0,10]} (p \rightarrow \Diamond q)"
    _, (found,) = parse(Source("latex.rl", text))
    assert found.help == ("in roadlang: `always[0,10] (p implies eventually q)`",)


def test_items_at_the_left_margin_do_not_end_their_block() -> None:
    tree, found = parse(Source("margin.rl", "road a {\nwidth: 7m\nlanes 2\n}\nroad b from a\n"))
    assert [(d.code, d.span.line) for d in found if d.span] == [("RL001", 3)]
    assert len(tree.statements) == 2


def test_an_indented_misspelled_statement_is_found() -> None:
    _, found = parse(Source("indented.rl", "  road a from b\n  raod c from d\n  raod e from f\n"))
    assert [d.code for d in found] == ["RL002", "RL002"]


def test_a_semicolon_is_said_once() -> None:
    _, found = parse(Source("semicolon.rl", "let a = 1; let b = 2;\n"))
    assert [d.code for d in found] == ["RL006", "RL006"]


def test_a_bracket_closed_by_another_is_reported_at_the_closing_one() -> None:
    _, (found,) = parse(Source("p.rl", "require a: always (p > 3m]\nrequire b: always (q > 3m)\n"))
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column) == ("RL004", 1, 26)
    assert found.help == ("`(` of line 1 is closed by `)`",)
    assert [fix.replacement for fix in found.fixes] == [")"]


def test_a_decimal_comma_has_no_blanks_around_it() -> None:
    _, (found,) = parse(Source("p.rl", "road a from b { width: 7,5m }\n"))
    assert (found.code, found.span and found.span.text) == ("RL008", "7,5m")
    _, (found,) = parse(Source("p.rl", "road a from b { lanes: 2 ,5m }\n"))
    assert (found.code, found.span and found.span.text) == ("RL001", "5m")


def test_a_bracket_too_many_leaves_the_statements_behind_it_alone() -> None:
    text = "  road a from b { lanes: 2 } }\n  raod c from d\n"
    tree, found = parse(Source("p.rl", text))
    assert [(d.code, d.span and d.span.line) for d in found] == [("RL004", 1), ("RL002", 2)]
    assert len(tree.statements) == 2


def test_a_file_without_quotes_ends_at_the_next_blank() -> None:
    tree, (found,) = parse(Source("p.rl", "include streets/main.rl as left\nroad a from b\n"))
    assert found.span is not None
    assert (found.code, found.span.text) == ("RL001", "streets/main.rl")
    assert [fix.replacement for fix in found.fixes] == ['"streets/main.rl"']
    assert len(tree.statements) == 2


def test_what_is_missing_at_the_end_of_a_statement_is_not_said_of_the_file() -> None:
    _, (found,) = parse(Source("p.rl", "road a from\n\nroad b from c\n"))
    assert found.message.endswith("found the end of the statement")
    _, (found,) = parse(Source("p.rl", "road b from c\nroad a from\n"))
    assert found.message.endswith("found the end of the file")


@pytest.mark.parametrize(
    ("text", "missing", "found"),
    [
        ("param a 3m", "=", "3m"),
        ("agent ego car on main at 5m", "is", "car"),
        ("object oak tree at 5m", "is", "tree"),
        ("road b main", "from", "main"),
        ("network t plan", "from", "plan"),
        ("require r always p", ":", "always"),
        ("road b from main { width 7m }", ":", "7m"),
        ("road b from main  width: 7m }", "{", "width"),
        ("let a = f b)", "(", "b"),
    ],
)
def test_a_missing_sign_is_named_and_the_rest_is_read_as_if_it_were_there(
    text: str, missing: str, found: str
) -> None:
    tree, errors = parse(Source("a.rl", f"{text}\nlet after = 1m\n"))
    assert [error.message for error in errors] == [f"expected `{missing}`, found `{found}`"]
    assert len(tree.statements) == 2


def test_what_begins_at_the_margin_is_a_statement_whatever_its_letters() -> None:
    """`_wait` is no statement, and the next one is read all the same."""
    tree, errors = parse(Source("a.rl", "param a = 3m\n_wait until noon\nparam b = 4m\n"))
    assert [(e.code, e.span.line) for e in errors if e.span] == [("RL001", 2)]
    assert len(tree.statements) == 2
