"""`python -m symcheck.checker FOLDER`: checks the certificates in files and folders."""

from __future__ import annotations

import gc
import json
import os
import sys
from collections.abc import Callable
from glob import escape, glob

from symcheck.checker.certificates import check_all
from symcheck.checker.residues import Reject, require
from symcheck.core.terms import JSON

SCHEMA = 2


def unique(pairs: list[tuple[str, JSON]]) -> dict[str, JSON]:
    """An object no key of which occurs twice."""
    require(len(dict(pairs)) == len(pairs), "a key occurs twice: {}", [key for key, _ in pairs])
    return dict(pairs)


def read(path: str) -> list[JSON]:
    """The certificates in a file."""
    with open(path, encoding="utf-8") as file:
        data: JSON = json.load(file, object_pairs_hook=unique)
    stated = data if isinstance(data, dict) else {}
    require(stated.get("schema") == SCHEMA, "its schema is not {}", SCHEMA)
    found = stated["certificates"]
    listed = found if isinstance(found, list) else []
    require(listed and stated.keys() <= {"schema", "paper", "certificates"}, "it has no certificates")
    return listed


def main(arguments: list[str], end: Callable[[int], int] = int) -> int:
    """Checks the files named, or those in the folders named: 0 all hold, 1 some do not, 2 a file cannot be read.

    `end` may end the process: to clear the memory up would take longer than many a certificate.
    """
    failures, count = [], 0
    for path in [p for a in arguments for p in sorted(glob(escape(a) + "/*.json")) or [a]] or ["certificates"]:
        try:
            listed = read(path)
        except (Reject, OSError, ValueError, KeyError, TypeError, RecursionError) as error:
            print(f"checker: {path} cannot be read ({error}); name a folder or file of certificates", file=sys.stderr)
            return 2
        names = [each.get("id") if isinstance(each, dict) else None for each in listed]
        answers = zip(names, check_all(listed), strict=True)
        failures += [f"{path}: {name}: {reason}" for name, reason in answers if reason]
        count += len(listed)
    summary = f"{len(failures)} do not hold" if failures else "all hold"
    print(*failures, f"{count} certificates, {summary}", sep="\n", flush=True)
    return end(bool(failures))


if __name__ == "__main__":
    gc.disable()  # nothing is thrown away before the end
    sys.exit(main(sys.argv[1:], os._exit))
