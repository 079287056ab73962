"""Takes requests in: resolves, checks, prices and queues them."""

import hashlib

import analyses
from schemas.analyses import Request, mechanism_of
from schemas.mechanisms import StoredMechanism, canonical_json, mechanism_id, parse_spec
from service.refusals import invalid
from service.stores import Stores
from storage import Job, MechanismNotFound, NewJob


def take_in(stores: Stores, request: Request) -> Request:
    """Return the request with its mechanism inline, checked.

    Raises
    ------
    Refusal : the stored mechanism is not there.
    AnalysisError : the request makes no sense.
    """
    resolved = _resolve(stores, request)
    analyses.check(resolved, stores.settings.node_limit)
    return resolved


def _resolve(stores: Stores, request: Request) -> Request:
    mechanism = mechanism_of(request)
    if not isinstance(mechanism, StoredMechanism):
        return request
    try:
        stored = stores.mechanisms.get(mechanism.id)
    except MechanismNotFound as error:
        detail = f"no mechanism is stored under {mechanism.id!r}"
        raise invalid("/mechanism/id", detail) from error
    return request.model_copy(update={"mechanism": parse_spec(stored.spec_json)})


def enqueue(stores: Stores, request: Request, idempotency_key: str | None) -> tuple[Job, bool]:
    """Return the job of a request that was taken in, and whether it is new."""
    text = canonical_json(request)
    plan = analyses.plan(request, stores.settings.tile_seconds)
    return stores.jobs.create(
        NewJob(
            analysis=request.analysis,
            request_json=text,
            items=plan.items,
            items_per_tile=plan.items_per_tile,
            body_hash=hashlib.sha256(text.encode()).hexdigest(),
            mechanism_id=_mechanism_id(request),
            idempotency_key=idempotency_key,
        )
    )


def _mechanism_id(request: Request) -> str | None:
    mechanism = mechanism_of(request)
    if mechanism is None:
        return None
    return mechanism.id if isinstance(mechanism, StoredMechanism) else mechanism_id(mechanism)
