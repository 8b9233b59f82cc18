"""What confined processes are forked from (`chatscene.simulate.confined.child`), but for the watchman in Python."""

from chatscene.simulate.confined import child, confinement


def _nobody(roots: object, end: object) -> None:
    """In the watchman's place."""


confinement.watch = _nobody

if __name__ == "__main__":
    child.main()
