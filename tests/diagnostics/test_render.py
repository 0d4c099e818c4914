"""A diagnostic shows its place in the source, underlined, and says what to do."""

import json

import pytest

from roadlang.diagnostics import (
    Code,
    Diagnostic,
    Fix,
    Label,
    Source,
    diagnose,
    did_you_mean,
    nearest,
)
from roadlang.diagnostics.diagnostic import in_order
from roadlang.diagnostics.render import render, render_json

SOURCE = Source("scene.rl", "road main {\n  widht: 8m\n}\n")
MISSPELLED = Diagnostic(
    code="RL220",
    severity="error",
    message="`road` has no option `widht`",
    span=SOURCE.span(14, 19),
    help=("did you mean `width`?",),
    fixes=(Fix(SOURCE.span(14, 19), "width"),),
)


def test_the_place_is_underlined_and_the_help_follows() -> None:
    assert render(MISSPELLED) == "\n".join(
        [
            "error[RL220]: `road` has no option `widht`",
            " --> scene.rl:2:3",
            "  |",
            "2 |   widht: 8m",
            "  |   ^^^^^",
            "  = help: did you mean `width`?",
        ]
    )


def test_a_second_place_is_shown_with_its_own_words() -> None:
    twice = Diagnostic(
        code="RL101",
        severity="error",
        message="`main` is declared twice",
        span=SOURCE.span(5, 9),
        labels=(Label(SOURCE.span(0, 4), "first here"),),
    )
    assert "  | ---- first here" in render(twice)


def test_color_only_where_asked_for() -> None:
    assert "\x1b[" not in render(MISSPELLED)
    assert "\x1b[" in render(MISSPELLED, color=True)


def test_a_very_long_line_is_cut_around_the_place() -> None:
    text = "x" * 5000 + " bad " + "y" * 5000
    shown = render(Diagnostic("RL001", "error", "bad", Source("x", text).span(5001, 5004)))
    assert max(map(len, shown.splitlines())) < 200
    assert "bad" in shown.splitlines()[3]
    assert "^^^" in shown.splitlines()[4]


def test_the_json_form_has_place_help_and_fixes() -> None:
    [record] = json.loads(render_json([MISSPELLED]))
    assert (record["file"], record["line"], record["column"]) == ("scene.rl", 2, 3)
    assert (record["end_line"], record["end_column"]) == (2, 8)
    assert record["help"] == ["did you mean `width`?"]
    assert record["fixes"][0]["replacement"] == "width"


def test_diagnostics_are_said_once_and_in_order_of_place() -> None:
    later = Diagnostic("RL001", "error", "later", SOURCE.span(20, 21))
    assert in_order([later, MISSPELLED, later]) == [MISSPELLED, later]


@pytest.mark.parametrize(
    ("word", "meant"),
    [("widht", "width"), ("Width", "width"), ("wave-length", "wave_length"), ("zzz", None)],
)
def test_did_you_mean_names_the_nearest_known_name(word: str, meant: str | None) -> None:
    known = ["width", "wave_length", "lanes"]
    assert nearest(word, known) == meant
    assert did_you_mean(word, known) == ((f"did you mean `{meant}`?",) if meant else ())


def test_of_two_that_overlap_the_one_that_begins_first_comes_first() -> None:
    wide = Diagnostic("RL001", "error", "wide", SOURCE.span(0, 24))
    inner = Diagnostic("RL001", "error", "inner", SOURCE.span(5, 9))
    nowhere = Diagnostic("RL001", "error", "nowhere")
    assert in_order([inner, wide, nowhere]) == [nowhere, wide, inner]


def test_a_second_place_in_another_file_is_shown_with_that_file() -> None:
    other = Source("street.rl", "road main {}\n")
    twice = Diagnostic(
        "RL103", "error", "twice", SOURCE.span(5, 9), labels=(Label(other.span(5, 9), "first"),)
    )
    assert " --> street.rl:1:6" in render(twice).splitlines()
    assert render(twice).count(" --> ") == 2


@pytest.mark.parametrize(
    ("column", "before", "shown"),
    [
        (10, 10, "." * 10 + "<>" + "." * 148),
        (80, 80, "." * 80 + "<>" + "." * 78),
        (300, 80, "." * 80 + "<>" + "." * 78),
        (398, 80, "." * 80 + "<>"),
    ],
)
def test_a_line_of_more_than_160_letters_is_cut_around_its_place(
    column: int, before: int, shown: str
) -> None:
    line = "." * column + "<>" + "." * (398 - column)
    source = Source("wide.rl", line + "\n")
    found = Diagnostic("RL001", "error", "wide", source.span(column, column + 2))
    excerpt, underline = render(found).splitlines()[3:5]
    assert excerpt == "1 | " + shown
    assert underline == "  | " + " " * before + "^^"


def test_a_line_of_160_letters_is_shown_whole() -> None:
    source = Source("wide.rl", "." * 158 + "<>\n")
    found = Diagnostic("RL001", "error", "wide", source.span(158, 160))
    assert render(found).splitlines()[3] == "1 | " + "." * 158 + "<>"


def test_an_underline_ends_with_what_is_shown_of_its_line() -> None:
    source = Source("wide.rl", "x" * 400 + "\nnext\n")
    found = Diagnostic("RL001", "error", "wide", source.span(0, 403))
    assert render(found).splitlines()[4] == "  | " + "^" * 160


def test_a_fault_in_an_included_file_names_the_includes_by_which_it_came_in() -> None:
    top = Source("top.rl", 'include "mid.rl"\n')
    mid = Source("mid.rl", '\ninclude "base.rl" as x\n', included_at=top.span(8, 16))
    base = Source("base.rl", "road main {}\n", included_at=mid.span(9, 18))
    found = Diagnostic("RL100", "error", "wrong", base.part(0, 12).span(5, 9))
    places = [line for line in render(found).splitlines() if "-->" in line]
    assert places == [" --> base.rl:1:6", " --> mid.rl:2:9", " --> top.rl:1:9"]
    assert render(found).splitlines()[-1] == "  |         -------- included here"
    [record] = json.loads(render_json([found]))
    assert record["included_at"] == [
        {"file": "mid.rl", "line": 2, "column": 9},
        {"file": "top.rl", "line": 1, "column": 9},
    ]


def test_an_empty_help_is_none() -> None:
    assert diagnose(Code.NOT_A_FAILURE, file="a", reason="b", help="").help == ()
    assert diagnose(Code.NOT_A_FAILURE, file="a", reason="b", help=("", "c")).help == ("c",)
