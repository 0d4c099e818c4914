"""The error of a kind whose options are wrong together."""

from __future__ import annotations


class OptionError(ValueError):
    """An option has a value that it cannot have, as a list that is shorter than another (RL480).

    A kind raises it in `__post_init__`, so that `roadlang check` finds it, or where it computes.
    `option` names the option, whose value is underlined; `reason` completes "`by` ...", as in
    "has 2 points, but `at` has 3 places".
    """

    def __init__(self, option: str, reason: str, help: str = "") -> None:
        super().__init__(f"`{option}` {reason}")
        self.option = option
        self.reason = reason
        self.help = help
