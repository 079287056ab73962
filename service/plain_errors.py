"""Turns the plain-text errors of the web framework itself into problems."""

from starlette.types import ASGIApp, Message, Receive, Scope, Send

from service.problems import problem_response, refusal_of_status


class PlainErrors:
    """ASGI middleware: an error that is answered as plain text is answered as a problem.

    The framework's middleware and file responses answer 400, 413 and 416 on their own, past
    the exception handlers.
    """

    def __init__(self, app: ASGIApp, body_limit: int) -> None:
        self.app = app
        self.details = {413: f"at most {body_limit} bytes are allowed"}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on, and problems instead of plain errors back."""
        replaced = False

        async def rewritten(message: Message) -> None:
            nonlocal replaced
            if message["type"] == "http.response.start" and _is_plain_error(message):
                replaced = True
                status = message["status"]
                refusal = refusal_of_status(status, self.details.get(status) or str(scope["path"]))
                await problem_response(refusal)(scope, receive, send)
            elif not replaced:
                await send(message)

        await self.app(scope, receive, rewritten if scope["type"] == "http" else send)


def _is_plain_error(message: Message) -> bool:
    kind = dict(message["headers"]).get(b"content-type", b"")
    return bool(message["status"] >= 400 and kind.startswith(b"text/plain"))
