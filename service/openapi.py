"""Writes the description of the API: `python -m service.openapi openapi.json`."""

import json
import sys
from pathlib import Path

from service.app import create_app
from settings import Settings


def document_text() -> str:
    """Return the API's description as the text of a committed file."""
    document = create_app(Settings()).openapi()
    return json.dumps(document, indent=2, ensure_ascii=False, sort_keys=True) + "\n"


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(document_text(), encoding="utf-8")
