"""How requests are cut into tiles."""

import pytest

from analyses.plan import LEAST_SECONDS, LEAST_TILES, Plan, cut


def tiles(plan: Plan) -> int:
    return -(-plan.items // plan.items_per_tile)


def test_a_long_request_has_tiles_of_the_asked_length() -> None:
    plan = cut(10**9, 1e-6, 2.0)
    assert plan.items_per_tile * 1e-6 == pytest.approx(2.0, rel=1e-5)


def test_a_short_request_has_enough_tiles_to_share() -> None:
    assert tiles(cut(10**6, 3e-6, 1.0)) == LEAST_TILES


def test_tiles_are_worth_sending() -> None:
    plan = cut(10**6, 3e-7, 1.0)
    assert plan.items_per_tile * 3e-7 == pytest.approx(LEAST_SECONDS, rel=1e-5)


def test_what_every_tile_costs_anew_is_not_cut_smaller() -> None:
    plan = cut(10**6, 3e-6, 6.0, least_seconds=1.5)
    assert plan.items_per_tile * 3e-6 == pytest.approx(1.5, rel=1e-5)


def test_what_is_asked_bounds_every_tile() -> None:
    assert cut(10**6, 1e-6, 0.001).items_per_tile == pytest.approx(1000, rel=1e-3)


def test_whole_lines_stay_together_where_several_fit() -> None:
    assert cut(10**6, 1e-6, 0.05, 300).items_per_tile % 300 == 0
    assert cut(10**6, 1.0, 1.0, 300).items_per_tile == 1
