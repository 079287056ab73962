"""The generated client against a real server."""

import io
import time
from collections.abc import Iterator

import numpy as np
import pytest
from parmech_client import Client
from parmech_client.api.analyses import analyse
from parmech_client.api.jobs import create_job, get_job
from parmech_client.api.mechanisms import create_mechanism
from parmech_client.api.results import get_grid, get_result
from parmech_client.models import (
    EffortRequest,
    EffortResult,
    FiveBar,
    Job,
    LoadSize,
    Problem,
    StoredMechanism,
    StoredMechanismDocument,
    WorkspaceRequest,
    WorkspaceResult,
)
from parmech_client.types import File

from tests.integration.servers import Server
from tests.integration.studies import PRINTER, SMALL


@pytest.fixture
def client(server: Server) -> Iterator[Client]:
    """Return the generated client."""
    with Client(base_url=server.url, raise_on_unexpected_status=True) as client:
        yield client


def stored(client: Client) -> StoredMechanism:
    document = create_mechanism.sync(client=client, body=FiveBar.from_dict(PRINTER))
    assert isinstance(document, StoredMechanismDocument)
    return StoredMechanism(kind="stored", id=document.id)


def ended(client: Client, job: Job) -> Job:
    deadline = time.monotonic() + 90
    while job.state in ("accepted", "running") and time.monotonic() < deadline:
        found = get_job.sync(job.id, client=client, wait=2)
        assert isinstance(found, Job)
        job = found
    return job


def test_a_mechanism_is_stored_and_analysed(client: Client) -> None:
    request = EffortRequest(
        analysis="effort",
        mechanism=stored(client),
        poses=[[0.0, 0.2], [0.0, 9.0]],
        load=LoadSize(force=1.0),
    )
    result = analyse.sync(client=client, body=request)
    assert isinstance(result, EffortResult)
    assert None not in result.effort[0]
    assert result.effort[1] == [None, None]


def test_a_job_leads_to_its_result_and_grid(client: Client) -> None:
    request = WorkspaceRequest.from_dict(SMALL)
    request.mechanism = stored(client)
    job = create_job.sync(client=client, body=request)
    assert isinstance(job, Job)
    job = ended(client, job)
    assert job.state == "successful"
    result = get_result.sync(job.id, client=client)
    assert isinstance(result, WorkspaceResult)
    grid = get_grid.sync(job.id, client=client)
    assert isinstance(grid, File)
    with np.load(io.BytesIO(grid.payload.read()), allow_pickle=False) as arrays:
        assert np.count_nonzero(arrays["inside"]) == result.inside > 0


def test_a_refusal_is_a_problem(client: Client) -> None:
    request = WorkspaceRequest.from_dict(SMALL)
    request.mechanism = StoredMechanism(kind="stored", id="m_" + 32 * "0")
    problem = create_job.sync(client=client, body=request)
    assert isinstance(problem, Problem)
    assert problem.status == 422
