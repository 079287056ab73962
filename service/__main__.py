"""`python -m service`: serves the API until it is told to stop."""

import lifeline
import logs
from service.serving import serve
from settings import Settings

if __name__ == "__main__":
    lifeline.watch()
    logs.configure()
    serve(Settings())
