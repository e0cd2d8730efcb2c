"""Every form changed by machine is refused, but for changes that leave the statement true."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))


from osculant.cas.claims import all_claims

CLAIMS = all_claims()
