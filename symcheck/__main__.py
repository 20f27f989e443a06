"""The entry point: the command `symcheck`, and `python -m symcheck`."""

from symcheck.core import interrupts


def main() -> None:
    """Import the command line, which takes a while, and run it."""
    interrupts.leave_at_once()
    from symcheck.cli import main as run

    run()


if __name__ == "__main__":
    main()
