"""Damages texts the way people, editors and disks do."""

from __future__ import annotations

import random

_PIECES = [
    "(", ")", "[", "]", "{", "}", '"', '"""', "'", "#", "\\", "..", ".", ",", ":", "=", "==", "<",
    "->", "always", "G ", "U", "with", "and", "not ", "road", "\nroad ", "\n", "\r\n", "\t", " ",
    "5 m", "5", "1e9", "\x00", "\ufeff", "\udcff", "\ufffd", "\u00e9", "\u2264", "\\Box", "$", "%",
    "//", "/*", "-" * 50, "(" * 50,
]  # fmt: skip


def mutated(text: str, rng: random.Random) -> str:
    """The text with one to four faults in it."""
    for _ in range(rng.randint(1, 4)):
        text = _once(text, rng)
    return text


def _once(text: str, rng: random.Random) -> str:
    start = rng.randint(0, len(text))
    end = min(len(text), start + rng.choice([1, 1, 2, 5, 20, 200]))
    match rng.randrange(6):
        case 0:
            return text[:start] + text[end:]
        case 1:
            return text[:start] + rng.choice(_PIECES) + text[start:]
        case 2:
            return text[:start] + rng.choice(_PIECES) + text[end:]
        case 3:
            return text[:start] + text[start:end] * 2 + text[end:]
        case 4:
            return text[:start] + chr(rng.randrange(0x300)) + text[end:]
        case _:
            lines = text.split("\n")
            rng.shuffle(lines)
            return "\n".join(lines[: rng.randint(1, len(lines))])
