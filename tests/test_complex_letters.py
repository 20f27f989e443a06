"""Which letters are complex, in an order that each run has alike."""

from __future__ import annotations

from symcheck.reading.complex_letters import complexes


def test_letters_that_may_be_complex_come_in_the_order_of_the_letters() -> None:
    letters = [x for letter in "pRUrtA" for x in (letter, rf"\overline{{{letter}}}")]
    assert complexes([" + ".join(letters)], letters, [], []).possible == [*"pRUrtA"]
