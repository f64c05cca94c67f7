"""What the tests of the Python modules share. Ends the test with 77 (skipped) without NumPy."""
import sys

try:
    import numpy as np
except ImportError:
    print("skipped: needs python3-numpy")  # Debian's name of the package
    sys.exit(77)


def raises(kind, message, call, *arguments, **named):
    """Whether the call raises an exception of this kind that has this message."""
    try:
        call(*arguments, **named)
    except kind as error:
        assert message in str(error), f"{error!r} instead of {message!r}"
        return
    raise AssertionError(f"no {kind.__name__}: {message}")
