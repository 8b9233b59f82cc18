"""``python -m chatscene`` is ``chatscene``."""

from chatscene.cli import main

if __name__ == "__main__":
    main()
