"""What can be said of a declaration is known by name; what a scope says is in force in it."""

from __future__ import annotations

import doctest
from collections.abc import Callable
from inspect import Parameter, signature
from typing import Any

import pytest
from optimized import about_docstrings

from symcheck import papers
from symcheck.core.claims import Declaration, Ours
from symcheck.papers import declare as vocabulary
from symcheck.papers.declare import Scope, claim, definition, exclusion, ours, premise
from symcheck.papers.mirer2009 import derivation
from symcheck.papers.mirer2009.notation import damping_letters, turned_letters
from symcheck.proof import cases, identity

NAMED: dict[Callable[..., Declaration], dict[str, Any]] = {
    claim: {"by": identity, "printed": "x = x"},
    ours: {"by": identity, "words": "x is x.", "states": "x = x"},
    definition: {"printed": "x = 1"},
    premise: {"words": "x is chosen."},
    exclusion: {"words": "x is a letter.", "reason": "it asserts nothing"},
}
FOREIGN = [
    (definition, "by"),
    (definition, "given"),
    (premise, "errata"),
    (exclusion, "states"),
    (exclusion, "notation"),
    (ours, "printed"),
    (ours, "errata"),
    (ours, "damage"),
    (claim, "reason"),
]


@pytest.mark.parametrize("declare", NAMED, ids=lambda declare: declare.__name__)
def test_every_field_is_a_parameter_and_a_misspelt_one_is_refused(declare: Callable[..., Declaration]) -> None:
    kinds = {parameter.kind for parameter in signature(declare).parameters.values()}
    assert kinds <= {Parameter.POSITIONAL_OR_KEYWORD, Parameter.KEYWORD_ONLY}
    assert declare("1", 3, **NAMED[declare]).number == "1"
    with pytest.raises(TypeError, match="notatoin"):
        declare("1", 3, **NAMED[declare], notatoin=damping_letters)


@pytest.mark.parametrize(("declare", "field"), FOREIGN, ids=lambda value: getattr(value, "__name__", value))
def test_what_makes_no_sense_for_a_class_cannot_be_said(declare: Callable[..., Declaration], field: str) -> None:
    with pytest.raises(TypeError, match=field):
        declare("1", 3, **NAMED[declare], **{field: None})


def test_the_method_is_identity_unless_the_claim_or_its_scope_names_another() -> None:
    scope = Scope(damping_letters, keeping=("b",), free=("J",))
    assert [each.claim("1", 3).plan.by for each in (scope, scope.by_cases)] == [identity, cases()]
    assert scope.by_cases.claim("1", 3).notation == damping_letters
    assert (scope.ours("1", 3, words="x.", states="x = x").plan.keeping, scope.claim("1", 3).plan.free) == (
        ("b",),
        ("J",),
    )


def test_a_scope_is_in_force_unless_a_claim_says_otherwise() -> None:
    scope = Scope(damping_letters, derivation.direction_cosines, identity)
    item = scope.claim("1", 3, "x = x")
    assert (item.notation, item.plan.where, item.plan.by) == (damping_letters, derivation.direction_cosines, identity)
    other = scope.claim("2", 4, "x = x", notation=turned_letters, where=derivation.axial_moments, by=(logic := cases()))
    assert (other.notation, other.plan.where, other.plan.by) == (turned_letters, derivation.axial_moments, logic)
    assert scope.definition("3", 5, "x = 1").notation == scope.premise("4", 6, words="x.").notation == damping_letters


def test_nothing_of_ours_is_printed() -> None:
    for paper in papers.load().values():
        for _, _, item in paper.items():
            if isinstance(item, Ours):
                assert not item.source.printed
                assert item.source.words
                assert item.statement.states


@about_docstrings
def test_the_example_runs() -> None:
    failed, attempted = doctest.testmod(vocabulary)
    assert attempted
    assert not failed
