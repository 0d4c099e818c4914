"""Plans junctions of random networks and counts the faults: `python -m benchmarks.junctions`."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from pathlib import Path

from benchmarks.junctions.checks import Figures, check_junction, effective_sections
from benchmarks.junctions.extracted_networks import drawn_network, photo_networks, typed_network
from benchmarks.junctions.random_networks import KINDS, RandomNetwork, random_network
from roadlang.geometry.junctions.plan import plan_junctions

READ = {"drawn": drawn_network, "typed": typed_network}
"""Kinds that are read from pictures."""


def main() -> None:
    """Prints a row for each kind of network and one for all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--networks", type=int, default=10, help="of each kind")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds", nargs="*", default=[*KINDS, *READ])
    parser.add_argument("--photos", type=Path, help="manifest of photos, for one more kind")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    print(f"{'kind':16} junctions merged faulty (merged, unreported) turns refused ms/junction")
    total, seconds = Figures(), 0.0
    kinds = {kind: _networks(kind, options.networks, options.seed) for kind in options.kinds}
    if options.photos:
        kinds["photo"] = photo_networks(options.photos)
    for kind, networks in kinds.items():
        figures, spent = Figures(), 0.0
        for number, drawn in enumerate(networks):
            start = time.process_time()
            plan = plan_junctions(drawn.network, drawn.sections)
            spent += time.process_time() - start
            sections = effective_sections(plan, drawn.sections)
            for junction in plan.junctions:
                report = check_junction(junction, plan, drawn.network, sections)
                for sums in (figures, total):
                    sums.add(report, plan)
                if options.verbose and report.faults:
                    problems = [p for p in plan.problems if p.junction == junction.id]
                    print("  ", kind, number, junction.id, junction.nodes, report.faults, problems)
        seconds += spent
        _print(kind, figures, spent)
    _print("all", total, seconds)
    print(total.faults)
    _print_apart(total)


def _networks(kind: str, count: int, seed: int) -> Iterator[RandomNetwork]:
    for number in range(seed * 100_003, seed * 100_003 + count):
        yield READ[kind](number) if kind in READ else random_network(kind, number)


def _print(kind: str, figures: Figures, seconds: float) -> None:
    print(
        f"{kind:16} {figures.junctions:9} {figures.merged:6} {figures.faulty:6} "
        f"({figures.faulty_merged}, {figures.unreported}) {figures.turns:5} {figures.refused:7} "
        f"{1e3 * seconds / max(figures.junctions, 1):.1f}"
    )


def _print_apart(figures: Figures) -> None:
    """The shares, with and without junctions whose roads the drawing has over one another."""
    apart = figures.overlapping
    print(f"roads of {apart} junctions ({figures.overlapping_merged} merged) overlap as drawn")
    rows = (
        ("without fault", figures.junctions, figures.faulty, apart, figures.overlapping_faulty),
        (
            "merged without fault", figures.merged, figures.faulty_merged,
            figures.overlapping_merged, figures.overlapping_faulty_merged,
        ),
    )  # fmt: skip
    for name, count, faulty, left_out, faulty_left_out in rows:
        rest = max(count - left_out, 1)
        share, other = 1 - faulty / max(count, 1), 1 - (faulty - faulty_left_out) / rest
        print(f"{name}: {share:.1%}, without those {other:.1%}")
    refused = figures.refused / max(figures.turns, 1)
    others = (figures.refused - figures.overlapping_refused) / max(figures.turns, 1)
    print(f"turns refused: {refused:.2%}, without those {others:.2%}")


if __name__ == "__main__":
    main()
