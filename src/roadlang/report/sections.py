"""The parts of the page that are written once: summary, pictures, coverage, provenance."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from .charts import TITLES, UNITS, coverage_chart, progress_chart
from .draw_charts import draw_charts
from .drive_records import DriveView
from .elements import element, text
from .numbers import percent, quantity
from .pictures import frame_of, gallery
from .results import ResultRow, Results

_APART = (
    "The random values that differ most between failing drives and the others, with the share of"
    " pairs of a failing and another drive in which the value differs that way. A search looks"
    " more often where it has found failures, so these are hints, not causes: roadlang explain"
    " tests them."
)


def heading(results: Results) -> str:
    """What was done, in a line."""
    record = results.record
    if results.evaluations is not None:
        what = f"Search for failures with {record.sampler}, seed {record.seed}"
    elif record.seed is None:
        what = "One scene, driven"
    else:
        what = f"Scenes, driven; seed {record.seed}"
    return text(what)


def headline(results: Results) -> str:
    """The result in a sentence."""
    count, failing = len(results.rows), results.failing
    scenes = f"{count:,} scene{'' if count == 1 else 's'}"
    if not results.expects:
        return text(f"{scenes} driven; the file has no expectations.")
    if not count:
        return text("No candidate satisfies the requirements.")
    if not failing:
        return text(f"All expectations hold in {scenes}.")
    if results.distinct is None:
        return text(f"All expectations hold in {count - failing:,} of {scenes}.")
    noun = f"distinct failure{'' if results.distinct == 1 else 's'}"
    return text(f"{results.distinct:,} {noun}: {failing:,} of {scenes} fail.")


def facts(results: Results, views: Sequence[DriveView]) -> str:
    """The result in numbers."""
    found = [element("div", element("dt", text(name)), element("dd", text(value)), *_note(note))
             for name, value, note in _facts(results, views)]  # fmt: skip
    return element("dl", *found, class_="facts")


def progress(results: Results, views: Sequence[DriveView]) -> str:
    """A chart for each expectation that was searched for."""
    units = {j.verdict.name: j.unit for view in views for j in view.judged}
    charts = []
    for name in results.best:
        seen = [
            (row.number, rho, row.has_failed)
            for row in results.rows
            if (rho := row.robustness.get(name)) is not None
        ]
        numbers, values, failed = zip(*seen, strict=True) if seen else ((), (), ())
        chart = progress_chart(numbers, values, failed, results.best[name], units.get(name, ""))
        title = f"Robustness of {name} during the search"
        charts.append(_figure(chart, title, "Each dot is a drive; the line is the lowest so far."))
    return element("div", *charts, class_="charts") if charts else ""


def galleries(results: Results, views: Sequence[DriveView]) -> str:
    """The failing and the safe drives as pictures."""
    if not views:
        return ""
    frame = frame_of(views)
    parts = []
    for title, identity, has_failed in (("Failures", "failures", True), ("Safe", "safe", False)):
        numbers = [i for i, view in enumerate(views) if view.drive.has_failed is has_failed]
        if not numbers:
            continue
        chosen = [views[i] for i in numbers]
        note = _note_of(results, len(numbers), has_failed)
        heading = element("h2", text(title), id=f"{identity}-title")
        parts.append(
            element("section", heading, element("p", text(note), class_="note"),
                    gallery(chosen, frame, numbers), id=identity,
                    aria_labelledby=f"{identity}-title")
        )  # fmt: skip
    return "".join(parts)


def coverage(results: Results) -> str:
    """What the drives had of curvature, speed and gap."""
    charts = [
        _figure(coverage_chart(name, found, UNITS.get(name, "")), TITLES.get(name, name), "")
        for name, found in results.coverage.items()
    ]
    return element("div", *charts, class_="charts")


def random_values(results: Results, views: Sequence[DriveView]) -> str:
    """The random values that set failing drives apart, where any do."""
    units = {name: unit for view in views for name, unit in view.drive.scene.units.items()}
    charts = draw_charts(results.rows, units)
    if not charts:
        return ""
    title = element("h2", text("What sets failures apart"), id="apart-title")
    note = element("p", text(_APART), class_="note")
    return element("section", title, note, charts, id="apart", aria_labelledby="apart-title")


def provenance(results: Results) -> str:
    """What the results were made from."""
    record = results.record
    rows = [
        ("Command", [record.again]),
        ("Scene file", [record.source]),
        ("Params", [f"{name} = {value}" for name, value in record.params.items()]),
        ("Inputs (SHA-256)", [f"{name} {digest}" for name, digest in record.inputs.items()]),
        ("Versions", [f"roadlang {record.roadlang}", *_versions(results)]),
        ("Simulator", sorted({drive.trace.engine for drive in results.drives})),
    ]
    found = []
    for name, lines in rows:
        cells = [element("dd", element("code", text(line))) for line in lines]
        found += [element("dt", text(name)), *cells] if cells else []
    return element("dl", *found, class_="provenance")


def _facts(results: Results, views: Sequence[DriveView]) -> Iterator[tuple[str, str, str]]:
    rows, failing = results.rows, results.failing
    if results.evaluations is not None:
        yield "Evaluations", f"{results.evaluations:,}", f"{len(rows):,} satisfy the requirements"
    else:
        yield "Scenes", f"{len(rows):,}", ""
    if results.expects:
        share = percent(failing / len(rows)) if rows else ""
        yield "Failing", f"{failing:,}", f"{share} of the scenes driven" if share else ""
    if results.distinct is not None:
        yield "Distinct", f"{results.distinct:,}", "other road, behavior or cause"
        first = next((row.number for row in rows if row.has_failed), None)
        if first is not None:
            yield "First failure", f"{first:,}", "evaluation"
    if results.rate is not None and results.expects:
        rate = results.rate
        span = f"{percent(rate.low)} to {percent(rate.high)}"
        yield "Failure rate at random", span, f"95% interval, {rate.failures:,} of {rate.scenes:,}"
    broken = sum("controller failure time" in row.values for row in rows)
    if broken:
        yield "Controllers failed", f"{broken:,}", f"in {percent(broken / len(rows))} of the scenes"
    units = {j.verdict.name: j.unit for view in views for j in view.judged}
    for name in results.expects:
        found = [(rho, row) for row in rows if (rho := row.robustness.get(name)) is not None]
        if found:
            rho, row = min(found, key=lambda pair: pair[0])
            yield (
                f"Lowest robustness of {name}",
                quantity(rho, units.get(name, "")),
                _scene(results, row),
            )


def _scene(results: Results, row: ResultRow) -> str:
    if results.evaluations is not None:
        return f"evaluation {row.number:,}"
    run = f"{row.values['run']}, " if "run" in row.values else ""
    return f"{run}scene {row.values['scene']}"


def _note(note: str) -> list[str]:
    return [element("dd", text(note), class_="note")] if note else []


def _note_of(results: Results, count: int, has_failed: bool) -> str:
    if not has_failed:
        return "Some drives that violate nothing, the nearest to failing first."
    more = f" {results.more_failing:,} more are not shown." if results.more_failing else ""
    least = "Worst first, all at the same scale. The ring marks where it goes wrong."
    return f"{least}{more}"


def _versions(results: Results) -> list[str]:
    plugins = results.record.plugins.items()
    return [f"{name} {version}" for name, version in plugins if name != "roadlang"]


def _figure(chart: str, title: str, note: str) -> str:
    words = [element("strong", text(title)), *([f" {text(note)}"] if note else [])]
    return element("figure", element("figcaption", *words), chart) if chart else ""
