"""`python -m symcheck.reading` stores the tables of the parser, after a change of the grammar."""

from symcheck.reading.grammar import GRAMMAR
from symcheck.reading.tables import STORED, store

if __name__ == "__main__":
    store(GRAMMAR)
    print(f"{STORED}: written")
