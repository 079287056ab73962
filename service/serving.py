"""Runs the application in a web server."""

import uvicorn

from service.app import create_app
from settings import Settings

GRACE_SECONDS = 2
"""Open streams are cut off this long after the process is told to stop."""


def serve(settings: Settings) -> None:
    """Serve on the host and port of the settings until SIGTERM or SIGINT."""
    uvicorn.run(
        create_app(settings),
        host=settings.host,
        port=settings.port,
        log_config=None,
        timeout_graceful_shutdown=GRACE_SECONDS,
    )
