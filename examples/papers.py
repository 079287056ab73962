"""Draw the papers' figures from what a server answers over HTTP.

Starts a server on a free port and writes one picture a figure to `examples/pictures/`, or to the
folder that is named. README.md beside this file says what to compare with what.
"""

import sys
from pathlib import Path

from examples import efforts, planar, spatial
from examples.serving import server

PICTURES = (
    efforts.effort_map,
    efforts.rose,
    efforts.rose_efforts,
    planar.by_geometry,
    planar.types,
    planar.printer,
    spatial.delta,
    spatial.geared,
)


def main(out: Path) -> None:
    """Draw every picture into a folder."""
    out.mkdir(parents=True, exist_ok=True)
    with server() as client:
        for draw in PICTURES:
            draw(client, out)
    print(f"the pictures are in {out.resolve()}")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "pictures")
