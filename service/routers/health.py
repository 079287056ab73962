"""`/healthz` and `/readyz`."""

from fastapi import APIRouter

from schemas.health import Health, Readiness
from service.problems import declared
from service.refusals import Refusal
from service.stores import UsedStores

router = APIRouter(tags=["health"])


@router.get("/healthz", operation_id="get_health")
def get_health() -> Health:
    """Say that this process answers."""
    return Health(status="alive")


@router.get("/readyz", operation_id="get_readiness", responses=declared(503))
def get_readiness(stores: UsedStores) -> Readiness:
    """Say whether the database, its newest tables and a worker are there."""
    lease = stores.settings.lease_seconds
    migrated = stores.database.is_current()
    age = stores.heartbeats.youngest_age() if migrated else None
    wrong = []
    if not migrated:
        wrong.append("the database is not migrated to this version; run `parmech migrate`")
    elif age is None or age > lease:
        wrong.append(f"no worker gave a sign of life within {lease:g} s")
    if wrong:
        raise Refusal("not-ready", 503, "Not ready", "; ".join(wrong), headers={"Retry-After": "1"})
    return Readiness(status="ready", database="current", worker_heartbeat_age=age or 0.0)
