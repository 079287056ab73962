"""Generate the Python client from the committed `openapi.json`.

`python sdk/generate.py FOLDER` replaces FOLDER. The same schema gives the same bytes.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

SDK = Path(__file__).resolve().parent


def generate(folder: Path) -> None:
    """Replace `folder` by the client of the committed schema; anything left out is an error."""
    shutil.rmtree(folder, ignore_errors=True)
    programs = Path(sys.executable).parent
    options = {
        "--path": SDK.parent / "openapi.json",
        "--config": SDK / "config.yml",
        "--output-path": folder.resolve(),
        "--meta": "pdm",
    }
    subprocess.run(
        [
            programs / "openapi-python-client",
            "generate",
            "--fail-on-warning",
            *(str(word) for pair in options.items() for word in pair),
        ],
        check=True,
        # The generator calls ruff by its name.
        env=os.environ | {"PATH": f"{programs}{os.pathsep}{os.environ['PATH']}"},
    )


if __name__ == "__main__":
    generate(Path(sys.argv[1]))
