"""``python -m osculant``: the command line."""

import sys

from osculant.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
