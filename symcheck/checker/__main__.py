"""`python -m symcheck.checker FOLDER`: checks certificates, and that they state what the ledger states.

FOLDER is generated/, with certificates/ and statements/, or a folder or file of certificates alone: of these is told
that nothing ties them to the print.
"""

from __future__ import annotations

import gc
import json
import os
import sys
from collections.abc import Callable
from glob import escape, glob

from symcheck.checker.certificates import check_all
from symcheck.checker.residues import Reject, require
from symcheck.checker.statements import Index
from symcheck.core.terms import JSON

SCHEMA = 3  # of certificates and statements, as `symcheck.ledger.store` writes them
TIED = """Each claims what generated/statements lists under its id, with definitions and hypotheses listed there. That
these lists say what is printed is not checked here: the reader makes them from the printed text, and what a sentence
means is put in formulas by hand. Statements about hypotheses left out and about kernels are not printed."""
NOT_TIED = "Nothing here ties the certificates to what is printed; name generated/ to compare them with its statements."


def unique(pairs: list[tuple[str, JSON]]) -> dict[str, JSON]:
    """An object no key of which occurs twice."""
    found = dict(pairs)
    if len(found) != len(pairs):
        raise Reject(f"a key occurs twice: {[key for key, _ in pairs]}")
    return found


def read(path: str, key: str) -> dict[str, JSON]:
    """The object in a file, which has a list that is not empty under this key."""
    with open(path, encoding="utf-8") as file:
        data: JSON = json.load(file, object_pairs_hook=unique)
    stated = data if isinstance(data, dict) else {}
    require(stated.get("schema") == SCHEMA, "its schema is not {}", SCHEMA)
    require(isinstance(stated.get(key), list) and stated[key], "it has no {}", key)
    return stated


def files(arguments: list[str]) -> list[tuple[str, str | None]]:
    """Each file of certificates, with that of the statements they are compared with, if there is one."""
    found: list[tuple[str, str | None]] = []
    for folder in arguments or ["generated"]:
        indexed = {os.path.basename(path): path for path in sorted(glob(escape(folder) + "/statements/*.json"))}
        inside = sorted(glob(escape(folder) + ("/certificates" if indexed else "") + "/*.json"))
        names = [os.path.basename(path) for path in inside] if indexed else []
        found += [(path, indexed.get(os.path.basename(path))) for path in inside] or [(folder, None)]
        found += [(folder + "/certificates/" + name, indexed[name]) for name in indexed.keys() - {*names}]
    return found


def faults(path: str, index: str | None) -> tuple[int, list[str]]:
    """How many certificates a file has, and what is wrong with them."""
    listed = read(path, "certificates")["certificates"]
    certificates = listed if isinstance(listed, list) else []
    names = [each.get("id") if isinstance(each, dict) else None for each in certificates]
    answers = zip(names, check_all(certificates), strict=True)
    wrong = [f"{name}: {reason}" for name, reason in answers if reason]
    if index and not wrong:
        wrong = [*Index(read(index, "statements")).differences(certificates)]
    return len(certificates), wrong


def main(arguments: list[str], end: Callable[[int], int] = int) -> int:
    """Checks what is named: 0 all hold, 1 some do not, 2 a file cannot be read.

    `end` may end the process: to clear the memory up would take longer than many a certificate.
    """
    failures, count, tied = [], 0, True
    for path, index in files(arguments):
        try:
            number, wrong = faults(path, index)
        except (Reject, OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
            print(f"checker: {path} cannot be read ({error}); name a folder or file of certificates", file=sys.stderr)
            return 2
        count, tied = count + number, tied and index is not None
        failures += [f"{path}: {reason}" for reason in wrong]
    summary = f"{len(failures)} {'does' if len(failures) == 1 else 'do'} not hold" if failures else "all hold"
    told = "\n".join([*failures, f"{count} certificate{'s' * (count != 1)}, {summary}", TIED if tied else NOT_TIED])
    try:  # a name in a file may be no text that can be written
        print(told.encode("utf-8", "backslashreplace").decode(), flush=True)
    except OSError as error:
        print(f"checker: the outcome cannot be written ({error}): {summary}", file=sys.stderr)
        return end(2)
    return end(bool(failures))


if __name__ == "__main__":
    gc.disable()  # nothing is thrown away before the end
    sys.exit(main(sys.argv[1:], os._exit))
