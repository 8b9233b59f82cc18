"""``python -m chatscene`` is ``chatscene``."""

import sys

if __name__ == "__main__":
    if not sys.flags.safe_path:
        del sys.path[0]  # the working folder, which ``-m`` puts first: what lies there is not to be imported

    from chatscene.commands.main import main

    main()
