"""Names and codes of colors, as legends write them."""

from __future__ import annotations

_NAMES = {
    "black": "#000000",
    "white": "#ffffff",
    "gray": "#808080",
    "grey": "#808080",
    "silver": "#c0c0c0",
    "red": "#ff0000",
    "maroon": "#800000",
    "orange": "#ffa500",
    "yellow": "#ffff00",
    "olive": "#808000",
    "lime": "#00ff00",
    "green": "#008000",
    "teal": "#008080",
    "cyan": "#00ffff",
    "blue": "#0000ff",
    "navy": "#000080",
    "purple": "#800080",
    "magenta": "#ff00ff",
    "pink": "#ffc0cb",
    "brown": "#a52a2a",
}
NAMES = tuple(_NAMES)


def bgr(name: str) -> tuple[int, int, int]:
    """Blue, green, red of "white", "#2e7d32" or "#fff". Raises ValueError for no color."""
    code = _NAMES.get(name.strip().lower(), name.strip())
    digits = code.removeprefix("#")
    if not code.startswith("#") or len(digits) not in (3, 6):
        raise ValueError(f"`{name}` is not a color")
    if len(digits) == 3:
        digits = "".join(2 * digit for digit in digits)
    value = int(digits, 16)
    return value & 255, value >> 8 & 255, value >> 16
