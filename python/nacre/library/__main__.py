"""``python -m nacre.library`` is ``nacre-library``."""

import sys

from .cli import main

if __name__ == "__main__":
    sys.exit(main())
