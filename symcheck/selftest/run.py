"""Plants faults of every class in worker processes and adds up what became of them."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from random import Random

from symcheck import selftest
from symcheck.audit import Crash, Done, Executor, Timeout
from symcheck.core.ids import Id
from symcheck.ledger import Record
from symcheck.selftest.documents import is_asked
from symcheck.selftest.engines import Agreement, agreement
from symcheck.selftest.statements import places, says_more, unguarded
from symcheck.selftest.trial import Count, FaultClass, Status, total

FAULTS = 21_000  # with so many the confidence bounds of statements, certificates and kernels exceed 99.5 %
ENOUGH = 0.999  # of the faults must be rejected
TIMEOUT = 120.0  # seconds for one task
Progress = Callable[[int, int], None]


@dataclass
class Result:
    """The counts by class and kind, by class and paper, and the tasks that did not come to an end."""

    seed: int
    counts: dict[str, dict[str, Count]] = field(default_factory=dict)
    papers: dict[str, dict[str, Count]] = field(default_factory=dict)
    unfinished: list[str] = field(default_factory=list)
    engines: Agreement = field(default_factory=Agreement)
    findings: list[str] = field(default_factory=list)

    @property
    def whole(self) -> Count:
        return total(count for kinds in self.counts.values() for count in kinds.values())

    @property
    def is_sound(self) -> bool:
        """Whether enough faults were rejected, nothing right was, all came to an end, and the engines agree."""
        statuses = self.whole.statuses
        enough = statuses[Status.ACCEPTED] <= (1 - ENOUGH) * (statuses[Status.ACCEPTED] + statuses[Status.REJECTED])
        return enough and not (statuses[Status.FALSELY_REJECTED] or self.unfinished or self.engines.disagreements)

    def to_json(self) -> dict[str, object]:
        """The confusion matrix as a whole, by class, by kind, and by paper where that is counted."""
        classes = {
            name: {
                **total(kinds.values()).to_json(),
                "kinds": {kind: count.to_json() for kind, count in kinds.items()},
                "papers": {paper: count.to_json() for paper, count in sorted(self.papers.get(name, {}).items())},
            }
            for name, kinds in self.counts.items()
        }
        whole = self.whole.to_json()
        others = {"unfinished": self.unfinished, "engines": asdict(self.engines), "findings": self.findings}
        return {"schema": 1, "seed": self.seed, **whole, **others, "classes": classes}


@cache
def classes() -> dict[str, FaultClass]:
    """All classes of faults by name: every module of this package that declares a CLASS."""
    modules = (import_module(f"{selftest.__name__}.{module.name}") for module in iter_modules(selftest.__path__))
    declared = [module.CLASS for module in modules if isinstance(getattr(module, "CLASS", None), FaultClass)]
    return {fault.name: fault for fault in sorted(declared, key=lambda fault: -fault.share)}


def tasks(records: Sequence[Record], faults: int, seed: int) -> list[str]:
    """What the workers do, each task a text: class, number of trials, seed, place. Long ones come first."""
    texts = []
    for name, fault in classes().items():
        wanted = -(-faults * fault.share // 10_000)
        those = [each for each in records if is_asked(each) == fault.documents]
        places = list(fault.places(those)) if those else []
        Random(f"{seed} {name}").shuffle(places)
        places = places[:wanted]
        for n, place in enumerate(places):
            count = wanted * (n + 1) // len(places) - wanted * n // len(places)
            texts.append(json.dumps([name, count, f"{seed} {name} {n}", place]))
    return texts


def planted(task: str) -> dict[str, Count]:
    """One task, in a worker process: the counts by kind."""
    name, count, seed, place = json.loads(task)
    counts: dict[str, Count] = {}
    for trial in classes()[name].trials(place, count, Random(seed)):
        counts.setdefault(trial.kind, Count()).add(trial)
    return counts


def run(
    records: Sequence[Record],
    executor: Executor,
    faults: int = FAULTS,
    seed: int = 0,
    progress: Progress = lambda done, total: None,
) -> Result:
    """Plant about so many faults in what the records speak of; the same seed plants the same ones."""
    asked = [each for each in records if is_asked(each)]
    own = [each for each in records if not is_asked(each)]
    todo = tasks(records, faults, seed)
    those = {name: fault for name, fault in classes().items() if (asked if fault.documents else own)}
    result = Result(seed, {name: {kind: Count() for kind in fault.kinds} for name, fault in those.items()})
    for done, (task, answer) in enumerate(executor.map(planted, todo, TIMEOUT), 1):
        name, _, _, place = json.loads(task)
        if isinstance(answer, Done):
            for kind, count in answer.value.items():
                result.counts[name][kind].merge(count)
                if those[name].by_paper:
                    result.papers.setdefault(name, {}).setdefault(Id.parse(place).paper, Count()).merge(count)
        else:
            result.unfinished.append(f"{name} {place[:80]}: {_why(answer)}")
        progress(done, len(todo))
    result.findings = findings(own)
    for place, more in executor.map(says_more, places(own), TIMEOUT):
        if isinstance(more, Done):
            result.findings += more.value
        else:
            result.unfinished.append(f"what says more than {place}: {_why(more)}")
    result.findings.sort()
    for counts in (*result.counts.values(), *result.papers.values()):
        for count in counts.values():
            count.errors.sort()
    result.unfinished.sort()
    result.engines = agreement(records)
    return result


def _why(answer: Timeout | Crash) -> str:
    return f"not within {answer.seconds:g} s" if isinstance(answer, Timeout) else answer.reason


def findings(records: Sequence[Record]) -> list[str]:
    """The hypotheses that a relation is stated with and does not need, and the bounds without a set of equality."""
    not_needed = [
        f"{record.id} does not need {hypothesis.name!r}"
        for record in records
        for hypothesis in record.hypotheses
        if hypothesis.need and hypothesis.need.needed is False
    ]
    return not_needed + [f"{id} has no set of equality: a looser bound would pass" for id in unguarded(records)]
