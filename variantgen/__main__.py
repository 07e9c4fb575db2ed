"""``python -m variantgen``."""

import sys

from variantgen.cli import main

sys.exit(main())
