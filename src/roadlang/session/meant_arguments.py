"""Arguments of functions that other tools call otherwise."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable

from ..diagnostics.nearest import nearest

_JOBS = "workers processes n_jobs num_workers n_workers threads cores parallel"
_SEED = "random_state random_seed rng"
_WORDS = {
    "sample": {
        "n": "count counts num number N n_samples num_samples samples n_scenes num_scenes scenes",
        "jobs": _JOBS,
        "seed": _SEED,
        "executor": "client pool",
        "progress": "callback",
    },
    "falsify": {
        "expects": "target targets expectation expectations",
        "evaluations": "n count budget iterations max_evaluations n_iterations trials samples",
        "seconds": "timeout time max_time time_limit",
        "searcher": "search optimizer method algorithm sampler",
        "engine": "simulator",
        "folder": "output out output_dir output_folder directory path",
        "options": "duration step control_step vehicle_step",
        "jobs": _JOBS,
        "seed": _SEED,
        "executor": "client pool",
        "progress": "callback",
    },
}
_MEANT = {
    function: {word: name for name, words in names.items() for word in words.split()}
    for function, names in _WORDS.items()
}


def refuse_sampling(given: Iterable[str], declared: Callable[[], Container[str]]) -> None:
    """Raise `TypeError` for a name that is that of no param, but stands for an argument of `sample`
    elsewhere or is a slip for one. `declared` gives the names of the scene file."""
    for name in given:
        meant = _MEANT["sample"].get(name) or nearest(name, _WORDS["sample"])
        if meant is not None and name not in declared():
            raise _no_argument("sample", name, f"did you mean `{meant}`?")


def refuse_searching(
    given: Iterable[str], settings: Container[str], declared: Callable[[], Container[str]]
) -> None:
    """Raise `TypeError` for a name that is none of the `settings` of a search, but that of a param
    or one that stands for an argument of `falsify` elsewhere."""
    for name in given:
        if name in settings:
            continue
        if name in declared():
            raise _no_argument("falsify", name, f"params come before, by `with_params({name}=...)`")
        meant = _MEANT["falsify"].get(name)
        if meant == "options":
            raise _no_argument("falsify", name, f'write `options={{"{name}": ...}}`')
        if meant is not None:
            raise _no_argument("falsify", name, f"did you mean `{meant}`?")


def _no_argument(function: str, name: str, hint: str) -> TypeError:
    return TypeError(f"{function}() has no argument `{name}`: {hint}")
