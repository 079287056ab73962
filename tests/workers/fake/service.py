"""Stands in for the package `service`: answers every request with its process id."""

import os
import time
from http.server import BaseHTTPRequestHandler, HTTPServer

import lifeline


class Handler(BaseHTTPRequestHandler):
    def do_GET(self) -> None:
        self.send_response(200)
        self.end_headers()
        self.wfile.write(str(os.getpid()).encode())

    def log_message(self, *_: object) -> None:
        """Say nothing."""


lifeline.watch()
address = (os.environ["PARMECH_HOST"], int(os.environ["PARMECH_PORT"]))
while True:
    try:
        HTTPServer(address, Handler).serve_forever()
    except OSError:
        time.sleep(0.1)
