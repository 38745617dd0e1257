"""The program `dynamy` of a wheel."""

import os
import sys
from pathlib import Path


def main() -> None:
    """Becomes the program that lies beside the package."""
    program = Path(__file__).parent / "bin" / "dynamy"
    if not program.is_file():
        sys.exit(f"{program}: no such file; `dynamy` is where dynamY was installed or built")
    os.execv(program, ["dynamy", *sys.argv[1:]])


if __name__ == "__main__":
    main()
