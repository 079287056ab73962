"""What `examples/` sends is accepted."""

import pytest

from examples import bodies
from schemas.presets import PRESETS
from tests.service.services import Service

MACHINES = {preset.name: preset.mechanism.model_dump(mode="json") for preset in PRESETS}
RRR, FIVE_BAR = MACHINES["planar_3rrr_2016"], MACHINES["five_bar_printer_2017"]
BODIES = {
    "effort map": bodies.effort_map(RRR),
    **bodies.rose_efforts(RRR),
    **bodies.types_of_3rrr(RRR),
    "geometric 3-RRR": bodies.geometric(RRR, "maximal"),
    "geometric five-bar": bodies.geometric(bodies.unlimited(FIVE_BAR), "constant_orientation"),
    "printer": bodies.printer(FIVE_BAR),
    "printer, straight down": bodies.printer(bodies.straight_down(FIVE_BAR)),
    "printer, both ends": bodies.printer(FIVE_BAR, **bodies.BOTH_ENDS),
    "delta": bodies.delta(MACHINES["delta_linear_4dof_2019"]),
    "geared": bodies.geared(),
    "geared, closer": bodies.geared_closer(),
}


@pytest.mark.parametrize("name", BODIES)
def test_the_body_of_an_example_is_accepted(name: str, refusing: Service) -> None:
    answer = refusing.post("/v1/estimates", BODIES[name])
    assert answer.status_code == 200, answer.text


def test_the_geared_mechanism_is_asked_for_on_the_published_grid(refusing: Service) -> None:
    estimate = refusing.post("/v1/estimates", bodies.geared()).json()
    assert estimate["nodes"] == 211**3 == 9_393_931
