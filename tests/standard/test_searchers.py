"""`falsify with`: what the searchers ask for, and what they make of the results."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from numpy.typing import NDArray

from roadlang.api import Axis, DiagnosticError, Search, Searcher
from roadlang_standard.cube_encoding import CubeEncoding
from roadlang_standard.failure_model import FailureModel, graded
from roadlang_standard.failure_spread import APART, FailureSpread, one_of_each_neighborhood
from roadlang_standard.falsify_cma import Cma
from roadlang_standard.falsify_elites import Archive, Elites
from roadlang_standard.falsify_grid import Grid
from roadlang_standard.falsify_halton import Halton
from roadlang_standard.falsify_random import Random
from roadlang_standard.learned_kernel import LearnedKernel
from roadlang_standard.near_misses import NearMisses

Floats = NDArray[np.float64]
CONTINUOUS = tuple(Axis(f"road/{number}") for number in range(5))
WEATHER = Axis("world/weather", (0.25, 0.5, 1.0), is_ordered=False)
COUNT = Axis("cars/count", (0.25, 0.5, 0.75, 1.0))
MIXED = (*CONTINUOUS, WEATHER, COUNT)


def searched(
    search: Search, value_of: Callable[[Floats], Floats], evaluations: int, batch: int = 40
) -> tuple[Floats, Floats]:
    """All points that a search asked for, and their values."""
    points, values = [], []
    for _ in range(0, evaluations, batch):
        asked = search.ask(batch)
        found = value_of(asked)
        search.tell(asked, found, asked)
        points.append(asked)
        values.append(found)
    return np.concatenate(points), np.concatenate(values)


def spread_of(encoding: CubeEncoding) -> FailureSpread:
    """One that no requirement restricts."""
    random = np.random.Generator(np.random.Philox(key=1))
    return FailureSpread(random, encoding.choices, lambda vectors: np.zeros(len(vectors)))


def rare(points: Floats) -> Floats:
    """Fails near a corner of the continuous axes, in one weather and with three cars."""
    away = np.abs(points[:, :5] - 0.85).mean(axis=1)
    wrong = (points[:, 5] < 0.25) | (points[:, 5] >= 0.5)
    few = np.abs(np.floor(points[:, 6] * 4) - 3.0) / 4.0
    return np.asarray(away + 0.1 * wrong + 0.2 * few - 0.1)


@pytest.mark.parametrize("searcher", [Random(), Halton(), Grid(steps=2), Cma(), Elites(initial=10)])
@pytest.mark.parametrize("axes", [MIXED, CONTINUOUS[:1], (WEATHER,)])
def test_every_searcher_asks_for_points_of_the_unit_cube(
    searcher: Searcher, axes: Sequence[Axis]
) -> None:
    search = searcher.start(axes, seed=3)
    for count in (7, 1, 12):
        points = search.ask(count)
        assert points.shape[1] == len(axes)
        assert len(points) <= count
        assert ((points >= 0.0) & (points < 1.0)).all()
        search.tell(points, np.linspace(-1.0, 2.0, len(points)), points)


@pytest.mark.parametrize("searcher", [Random(), Halton(), Cma(), Elites()])
def test_a_search_is_the_same_for_the_same_seed_and_another_for_another(
    searcher: Searcher,
) -> None:
    first, _ = searched(searcher.start(MIXED, seed=1), rare, 400)
    np.random.default_rng(0).random(10)
    again, _ = searched(searcher.start(MIXED, seed=1), rare, 400)
    other, _ = searched(searcher.start(MIXED, seed=2), rare, 400)
    np.testing.assert_array_equal(first, again)
    assert not np.array_equal(first, other)


def test_cma_leaves_the_global_generator_of_numpy_alone() -> None:
    before = np.random.get_state()[1].tolist()  # type: ignore[index] # noqa: NPY002
    searched(Cma().start(MIXED, seed=1), rare, 80)
    assert np.random.get_state()[1].tolist() == before  # type: ignore[index] # noqa: NPY002


def test_cma_finds_far_more_failures_than_chance() -> None:
    _, by_chance = searched(Random().start(MIXED, seed=5), rare, 2000)
    _, guided = searched(Cma().start(MIXED, seed=5), rare, 800)
    assert 0 < (by_chance < 0).sum() < 20
    assert (guided < 0).sum() > 5 * (by_chance < 0).sum()


def test_cma_starts_somewhere_else_once_it_has_found_enough() -> None:
    """Two places fail; a single run would end in one of them."""

    def two(points: Floats) -> Floats:
        low = np.abs(points - 0.15).max(axis=1)
        high = np.abs(points - 0.85).max(axis=1)
        return np.asarray(np.minimum(low, high) - 0.1)

    points, values = searched(Cma().start(CONTINUOUS[:3], seed=0), two, 1000)
    failing = points[values < 0].mean(axis=1)
    assert (failing < 0.5).any()
    assert (failing > 0.5).any()


def test_cma_begins_with_random_candidates_that_satisfy_the_requirements() -> None:
    search = Cma().start(CONTINUOUS, seed=2)
    search.screen_with(lambda points: np.where(points[:, 0] > 0.6, 0.0, 1.5))
    first = search.ask(20)
    assert len(first) == 20
    assert (first[:, 0] > 0.6).all()
    assert first[:, 1].std() > 0.2


def test_cma_begins_anew_where_nothing_fails_for_long_if_random_candidates_can_be_driven() -> None:
    def away(points: Floats) -> Floats:
        return np.asarray(np.abs(points - 0.3).mean(axis=1))

    def medians(screen: Callable[[Floats], Floats]) -> list[float]:
        search, found = Cma().start(CONTINUOUS, seed=3), []
        search.screen_with(screen)
        for count in (240, 240, 20, 20):
            points = search.ask(count)
            search.tell(points, 0.1 + 0.5 * away(points), points)
            found.append(float(np.median(away(points))))
        return found

    *_, near, anew = medians(lambda points: np.zeros(len(points)))
    assert near < 0.1
    assert anew > 0.2
    *_, near, still = medians(lambda points: np.where(away(points) < 0.1, 0.0, 1.5))
    assert max(near, still) < 0.1


def test_a_near_miss_whose_neighbors_are_no_better_is_given_up() -> None:
    near_misses = NearMisses(np.random.Generator(np.random.Philox(key=1)), APART)
    best, beside, elsewhere = np.full(3, 0.2), np.full(3, 0.25), np.full(3, 0.8)
    safe = [(0.1, best), (0.2, beside), (0.5, elsewhere)]
    for batch in range(6):
        near_misses.tell(safe)
        is_given_up = bool(np.median(near_misses.children(400)) > 0.6)
        assert is_given_up == (batch >= 3)  # the first batch brought them
    near_misses.tell([(0.05, best + 0.3), *safe])
    assert np.median(near_misses.children(400)) < 0.66  # a better one, far enough from the first


def test_cma_climbs_out_of_requirements_that_are_violated() -> None:
    """Nothing holds near the middle, where the first run starts; the violation shows the way."""

    def narrow(points: Floats) -> Floats:
        away = np.abs(points - 0.9).max(axis=1)
        return np.asarray(np.where(away > 0.15, 1.0 + away, away - 0.1))

    _, values = searched(Cma().start(CONTINUOUS, seed=0), narrow, 1200)
    assert (values < 0).any()


def test_cma_asks_for_few_points_that_violate_a_requirement_where_it_can_screen_them() -> None:
    """Strips that violate a requirement lie across all that may be driven."""

    def walled(points: Floats) -> Floats:
        violated = np.sin(60.0 * points[:, 0]) > 0.0
        return np.asarray(np.where(violated, 1.5, np.abs(points - 0.8).mean(axis=1) - 0.05))

    def screen(points: Floats) -> Floats:
        assert ((points >= 0.0) & (points < 1.0)).all()
        return np.where(walled(points) >= 1.0, 1.5, 0.0)

    screened, blind = (Cma().start(CONTINUOUS, seed=0) for _ in range(2))
    screened.screen_with(screen)
    violated = []
    for search in (screened, blind):
        _, values = searched(search, walled, 800)
        violated.append(int((values[40:] >= 1.0).sum()))
    assert violated[0] < 20
    assert violated[1] > 100


def test_cma_asks_for_few_points_that_violate_a_requirement_where_one_in_ten_satisfies_it() -> None:
    def narrow(points: Floats) -> Floats:
        violated = np.sin(60.0 * points[:, 0]) > -0.95
        return np.asarray(np.where(violated, 1.5, np.abs(points - 0.8).mean(axis=1) - 0.05))

    search = Cma().start(CONTINUOUS, seed=0)
    search.screen_with(lambda points: np.where(narrow(points) >= 1.0, 1.5, 0.0))
    _, values = searched(search, narrow, 400, batch=20)
    assert (values[40:] >= 1.0).sum() < 30


def test_batches_of_cma_grow_with_the_distinct_failures() -> None:
    search = Cma().start(CONTINUOUS, seed=0)
    assert (search.batch_size(160), search.batch_size(7)) == (11, 7)
    sizes = []
    for first in range(0, 100, 20):
        points = np.random.default_rng(first).random((20, 5))
        descriptors = 10.0 * points
        search.ask(20)
        search.tell(points, np.where(np.arange(20) == 0, -1.0, 0.5), descriptors)
        sizes.append(search.batch_size(32))
    assert sizes == [17, 23, 29, 32, 32]


def test_batches_of_cma_grow_where_nothing_fails_until_it_begins_anew() -> None:
    search = Cma().start(CONTINUOUS, seed=0)
    sizes = []
    for first in range(6):
        points = np.random.default_rng(first).random((200, 5))
        search.ask(200)
        search.tell(points, np.full(200, 0.5), 10.0 * points)
        sizes.append(search.batch_size(160))
    assert sizes == [11, 13, 20, 11, 13, 20]


def test_the_model_learns_in_which_directions_values_change() -> None:
    random = np.random.default_rng(0)
    known, others = random.random((200, 8)), random.random((300, 8))

    def value(vectors: Floats) -> Floats:
        return np.asarray(np.sin(4.0 * (vectors[:, 0] - vectors[:, 1])))

    kernel, errors = LearnedKernel(mean=0.0), []
    for _ in range(5):
        kernel.fit(known, value(known))
        errors.append(float(np.abs(kernel.predicted(others) - value(others)).mean()))
    assert errors[-1] < 0.5 * errors[0]


def test_what_the_model_does_not_know_may_be_better_than_it_expects() -> None:
    kernel, random = LearnedKernel(mean=0.5), np.random.default_rng(0)
    known = 0.5 * random.random((100, 4))
    kernel.fit(known, known.sum(axis=1))

    def hope(vectors: Floats) -> Floats:
        return np.asarray(kernel.predicted(vectors) - kernel.predicted(vectors, optimism=2.0))

    near, far = hope(known), hope(known + 0.5)
    assert (near > 0.0).all()
    assert near.max() < 0.5 * far.min()


def test_a_model_of_one_value_or_of_one_place_predicts_it() -> None:
    kernel = LearnedKernel(mean=0.3)
    for known in (np.random.default_rng(0).random((20, 3)), np.full((20, 3), 0.5)):
        for _ in range(2):
            kernel.fit(known, np.full(20, 0.3))
            np.testing.assert_allclose(kernel.predicted(known), 0.3)


def test_what_only_failures_have_makes_nothing_unlike() -> None:
    vectors = np.random.default_rng(4).random((300, 3))
    fails = vectors[:, 0] > 0.5
    place = np.where(fails, 3.0, 0.0)  # where it fails: the same place
    model = FailureModel()
    model.tell(vectors, np.where(fails, -0.5, 0.5), np.column_stack([vectors[:, 1], place]))
    low, high, other = model.described(np.array([[0.0, 0.5, 0.5], [1.0, 0.5, 0.5], [0.0, 1, 0.5]]))
    assert np.linalg.norm(high - low) < 0.1
    assert abs(np.linalg.norm(other - low) - 0.5) < 0.1


def test_a_grid_visits_each_value_once_and_ends() -> None:
    search = Grid(steps=3).start((CONTINUOUS[0], WEATHER), seed=0)
    points = np.concatenate([search.ask(4), search.ask(40)])
    assert search.ask(4).shape == (0, 2)
    weather = (0.125, 0.375, 0.75)
    expected = [((step + 0.5) / 3, chosen) for step in range(3) for chosen in weather]
    np.testing.assert_allclose(points, expected)


def test_a_grid_that_is_too_large_is_refused() -> None:
    with pytest.raises(DiagnosticError, match="RL614"):
        Grid(steps=100).start(CONTINUOUS, seed=0)


def test_halton_is_more_even_than_chance() -> None:
    even = Halton().start(CONTINUOUS[:2], seed=0).ask(256)
    cells = np.floor(even * 4).astype(int) @ [4, 1]
    assert np.bincount(cells, minlength=16).min() >= 12


def test_unordered_values_are_searched_one_hot_and_ordered_ones_as_numbers() -> None:
    encoding = CubeEncoding(MIXED)
    assert encoding.columns == 5 + 3 + 1
    vector = np.array([[0.1, 0.2, 0.3, 0.4, 0.5, 0.2, 0.9, 0.8, 1.0]])
    point = encoding.points(vector)
    np.testing.assert_allclose(point[0, :5], vector[0, :5])
    assert point[0, 5] == 0.375
    assert 0.75 < point[0, 6] < 1.0
    assert encoding.choices(vector).tolist() == [[0.0, 1.0, 0.0]]
    assert CubeEncoding(CONTINUOUS).choices(vector[:, :5]).shape == (1, 0)


def test_children_of_failures_spread_over_the_unordered_values() -> None:
    encoding = CubeEncoding(MIXED)
    spread = spread_of(encoding)
    vectors = np.random.default_rng(2).random((60, encoding.columns))
    values = np.where(vectors[:, 0] < 0.5, -0.5, 0.5)  # fails, whatever the weather
    spread.tell(vectors, values, 0.1 * vectors[:, :3])
    assert len(spread) == 3, "alike but for the weather"
    children = spread.ask(30)
    assert children.shape == (30, encoding.columns)
    assert ((children >= 0.0) & (children <= 1.0)).all()
    assert (encoding.choices(children).sum(axis=0) > 0).all()
    assert (children[:, 0] < 0.5).mean() > 0.8, "the model has seen what fails"


def test_the_safe_candidates_that_came_nearest_have_children_until_something_fails() -> None:
    encoding = CubeEncoding(CONTINUOUS)
    spread = spread_of(encoding)
    vectors = np.random.default_rng(2).random((60, encoding.columns))
    spread.tell(vectors[:5], np.full(5, 1.5), np.full((5, 0), np.nan))
    assert not spread.has_parents, "nothing could be driven"
    away = np.abs(vectors - 0.9).mean(axis=1)
    spread.tell(vectors, 0.5 + 1e-6 * away, 0.1 * vectors)  # as good as flat: ranks decide
    assert spread.has_parents
    assert len(spread) == 0
    children = spread.ask(30)
    assert np.abs(children - 0.9).mean() < np.sort(away)[:20].mean()


def test_one_good_place_does_not_have_all_the_children() -> None:
    random = np.random.default_rng(3)
    best = list(0.2 + 0.01 * random.random((100, 6)))
    chosen = one_of_each_neighborhood([*best, np.full(6, 0.8), np.full(6, 0.5), np.full(6, 0.79)])
    assert [vector[0] for vector in chosen[1:]] == [0.8, 0.5]
    many = np.stack(one_of_each_neighborhood(list(random.random((400, 3)))))
    gaps = np.sqrt(((many[:, None] - many[None]) ** 2).mean(axis=2))
    assert gaps[np.triu_indices(len(many), 1)].min() > APART


def test_safe_values_are_graded_by_rank_and_others_stay() -> None:
    values = np.array([0.5001, 1.4, -0.7, 0.5, 0.5002, 7.0, 0.0])
    found = graded(values)
    assert np.argsort(found[[6, 3, 0, 4]]).tolist() == [0, 1, 2, 3]
    assert found[4] - found[0] > 0.1
    assert found[[1, 2, 5]].tolist() == [1.4, -0.7, 2.0]
    assert graded(np.array([3.0, -0.5])).tolist() == [2.0, -0.5]


def test_elites_cover_more_behavior_than_chance_and_fail_more() -> None:
    def value(points: Floats) -> Floats:
        return np.asarray(np.abs(points - 0.85).mean(axis=1) - 0.1)

    def niches(searcher: Searcher) -> tuple[int, int]:
        search, archive, failures = searcher.start(CONTINUOUS, seed=4), Archive(), 0
        for _ in range(20):
            points = search.ask(50)
            values = value(points)
            search.tell(points, values, 12.0 * points[:, :2])
            failing = values < 0.0
            archive.add(points[failing], values[failing], 12.0 * points[failing, :2])
            failures += int(failing.sum())
        return len(archive.vectors), failures

    found, by_chance = niches(Elites()), niches(Random())
    assert found[0] > 1.5 * by_chance[0]
    assert found[1] > 3 * by_chance[1]


def test_a_niche_keeps_its_worst_drive_and_what_was_not_driven_leaves() -> None:
    archive = Archive()
    undriven = np.full((2, 2), np.nan)
    archive.add(np.array([[0.1], [0.2]]), np.array([1.9, 1.2]), undriven)
    assert [vector.tolist() for vector in archive.vectors] == [[0.2]]
    places = np.array([[0.0, 0.0], [0.5, 0.0], [3.0, 0.0]])
    archive.add(np.array([[0.3], [0.4], [0.5]]), np.array([0.5, -0.1, 0.7]), places)
    assert [vector.tolist() for vector in archive.vectors] == [[0.4], [0.5]]
    archive.add(np.array([[0.6], [0.7]]), np.array([1.1, 0.6]), np.array([[9.0, 9.0], [0.2, 0.0]]))
    assert archive.values == [-0.1, 0.7]


def test_points_are_found_again_from_their_vectors() -> None:
    encoding = CubeEncoding(MIXED)
    points = np.random.default_rng(0).random((50, len(MIXED)))
    points[:, 5] = np.asarray(WEATHER.middles())[np.arange(50) % 3]
    np.testing.assert_allclose(encoding.points(encoding.vectors(points)), points)


def test_very_many_unordered_values_are_searched_as_if_ordered() -> None:
    ends = tuple((number + 1) / 50 for number in range(50))
    assert CubeEncoding((Axis("name", ends, is_ordered=False),)).columns == 1


def test_a_countable_number_is_visited_in_the_middle_of_each_part() -> None:
    """A continuous one has no parts; a part without width has no middle."""
    assert WEATHER.middles() == (0.125, 0.375, 0.75)
    assert WEATHER.levels(2) == (0.125, 0.375, 0.75)
    assert CONTINUOUS[0].middles() == ()
    assert CONTINUOUS[0].levels(4) == (0.125, 0.375, 0.625, 0.875)
    assert Axis("a", (0.5, 0.5, 1.0)).middles() == (0.25, 0.75)
