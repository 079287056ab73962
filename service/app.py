"""The application."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from importlib import resources
from typing import Any

from fastapi import FastAPI
from fastapi.concurrency import run_in_threadpool
from fastapi.openapi.docs import get_swagger_ui_html
from fastapi.openapi.utils import get_openapi
from fastapi.responses import HTMLResponse
from starlette.middleware.body_limit import RequestBodyLimitMiddleware
from starlette.staticfiles import StaticFiles

import analyses
from schemas.problems import Problem
from service import problems
from service.plain_errors import PlainErrors
from service.routers import analyses as analyses_router
from service.routers import health, jobs, kinds, mechanisms, results
from service.stores import Stores
from settings import Settings
from storage import open_database

DESCRIPTION = """What a parallel mechanism can do, before anything is cut in metal.

SI units: m, rad, s, N, N·m. Errors are problem details (`application/problem+json`) that say
which field, what was given and what is allowed."""

REASONS = """Reason codes of a workspace number (condition, leg) in this order of conditions:
reach, actuator_limits, crank_rod_angle, rod_rod_angle, base_joint_angle, platform_joint_angle,
rod_distance, effort, pressure_angle, determinant, condition_number, actuator_speed; component is
the last."""


def create_app(settings: Settings) -> FastAPI:
    """Return the application over the database and folder of these settings."""
    app = FastAPI(
        title="parmech",
        version="1.0.0",
        description=f"{DESCRIPTION}\n\n{REASONS}",
        docs_url=None,
        redoc_url=None,
        lifespan=_lifespan,
    )
    app.state.settings = settings
    problems.install(app)
    app.add_middleware(RequestBodyLimitMiddleware, max_body_size=settings.body_limit_bytes)
    app.add_middleware(PlainErrors, body_limit=settings.body_limit_bytes)
    for module in (kinds, mechanisms, analyses_router, jobs, results, health):
        app.include_router(module.router)
    _serve_docs(app)
    app.openapi = lambda: _openapi(app)  # type: ignore[method-assign]
    return app


@asynccontextmanager
async def _lifespan(app: FastAPI) -> AsyncIterator[None]:
    settings: Settings = app.state.settings
    database = open_database(settings.resolved_database_url)
    app.state.stores = Stores.over(settings, database)
    await run_in_threadpool(analyses.warm)
    yield
    database.close()


def _serve_docs(app: FastAPI) -> None:
    # The page's files come from an installed package: it works without any network.
    files = resources.files("fastapi_offline") / "static"
    app.mount("/docs/files", StaticFiles(directory=str(files)), name="docs files")

    @app.get("/docs", include_in_schema=False)
    def docs() -> HTMLResponse:
        return get_swagger_ui_html(
            openapi_url="/openapi.json",
            title="parmech API",
            swagger_js_url="/docs/files/swagger-ui-bundle.js",
            swagger_css_url="/docs/files/swagger-ui.css",
            swagger_favicon_url="/docs/files/favicon.png",
        )


def _openapi(app: FastAPI) -> dict[str, Any]:
    if app.openapi_schema is None:
        document = get_openapi(
            title=app.title,
            version=app.version,
            description=app.description,
            routes=app.routes,
        )
        models = document["components"]["schemas"]
        reference = "#/components/schemas/{model}"
        problem = Problem.model_json_schema(ref_template=reference)
        models.update(problem.pop("$defs", {}), Problem=problem)
        _declare_invalid_requests(document)
        app.openapi_schema = document
    return app.openapi_schema


def _declare_invalid_requests(document: dict[str, Any]) -> None:
    """Put our own 422 where the framework declared its own, which is never sent."""
    ours = problems.declared(422)[422]
    for path in document["paths"].values():
        for operation in path.values():
            if "application/json" in operation["responses"].get("422", {}).get("content", {}):
                operation["responses"]["422"] = ours
    for name in ("HTTPValidationError", "ValidationError"):
        document["components"]["schemas"].pop(name, None)
