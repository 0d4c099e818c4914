"""The command line: one file per command, nothing heavy imported until a command runs."""

from .dataclass_methods import compile_methods_when_called

compile_methods_when_called()
