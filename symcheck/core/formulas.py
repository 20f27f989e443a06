"""Formulas taken apart, and their contraries."""

from __future__ import annotations

from symcheck.core.terms import Connective, Formula, Quantified, Relation, Term, node

CONTRARY = {"=": "!=", "!=": "=", "<": ">=", "<=": ">", ">": "<=", ">=": "<", "and": "or", "or": "and"}
CONTRARY |= {"exists": "forall", "forall": "exists"}
FALSE = node("or")


def conjuncts(formula: Formula) -> list[Formula]:
    """The formula taken apart at "and"."""
    if isinstance(formula, Connective) and formula.tag == "and":
        return [part for each in formula.formulas for part in conjuncts(each)]
    return [formula]


def contrary(formula: Formula) -> Formula:
    """What is true if and only if the formula is not."""
    match formula:
        case Relation(terms=sides):
            return node(CONTRARY[formula.tag], *sides)
        case Quantified():
            return node(CONTRARY[formula.tag], formula.bound, contrary(formula.body))
        case Connective(tag="=>", formulas=(premise, conclusion)):
            return node("and", premise, contrary(conclusion))
        case Connective(tag="<=>", formulas=(left, right)):
            return node("or", node("and", left, contrary(right)), node("and", right, contrary(left)))
        case Connective(formulas=parts):
            return node(CONTRARY[formula.tag], *map(contrary, parts))
    raise AssertionError(formula)


def sides(formula: Formula) -> list[Term]:
    """Both sides of every relation in a formula that stands under no quantifier."""
    if isinstance(formula, Relation):
        return [*formula.terms]
    return [t for part in formula.formulas for t in sides(part)] if isinstance(formula, Connective) else []
