"""`python -m roadlang` is `roadlang`."""

from .cli.main import main

main()
