"""Kinds that are planned and not built yet: `check` says so instead of not knowing them."""

PLANNED = ("emit usd",)
