"""Colors for scene files on the documentation site."""

from __future__ import annotations

from pygments.lexer import RegexLexer, words
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Text

from roadlang.syntax.words import CONNECTIVES, RESERVED, STATEMENTS

_PASSES = ("extract", "perturb", "adjust", "draw", "read", "drive")

__all__ = ["RoadlangLexer"]  # where Pygments looks


class RoadlangLexer(RegexLexer):
    """Statements, reserved words, numbers with their units, strings and comments."""

    name = "roadlang"
    aliases = ("roadlang",)
    filenames = ("*.rl",)
    url = ""
    tokens = {  # noqa: RUF012 - pygments asks for this form
        "root": [
            (r"\s+", Text),
            (r"#.*$", Comment.Single),
            (r'"""(?s:.*?)"""', String),
            (r'"(\\.|[^"\\\n])*"', String),
            (words(STATEMENTS, prefix=r"^\s*", suffix=r"\b"), Keyword.Declaration),
            (
                words(("extract", "perturb", "adjust", "draw", "read", "drive"), suffix=r"\b"),
                Keyword,
            ),
            (words(RESERVED, suffix=r"\b"), Operator.Word),
            (words(CONNECTIVES, suffix=r"\b"), Keyword),
            (r"\d+(\.\d+)?([eE][+-]?\d+)?(/?[A-Za-z%]+(/[A-Za-z]+)*(\^[\d.]+)?)?", Number),
            (r"[A-Za-z_]\w*(?=\s*:)", Name.Attribute),
            (r"[A-Za-z_]\w*", Name),
            (r"\.\.|[-+*/^<>=]=?", Operator),
            (r".", Punctuation),
        ]
    }
