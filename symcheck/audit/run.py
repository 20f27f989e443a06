"""The audit: which declarations are asked for, what is known of them already, who decides the rest."""

from __future__ import annotations

import gc
from collections import defaultdict
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from msgspec.structs import replace

from symcheck.audit import checked
from symcheck.audit.cache import Cache
from symcheck.audit.executor import Answer, Done, Executor, Timeout
from symcheck.core.claims import Assertion, Paper
from symcheck.core.ids import Id
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.ledger import Later, Record, reached

if TYPE_CHECKING:
    from symcheck.audit.obligation import Obligation

K = TypeVar("K")
T = TypeVar("T")
Progress = Callable[[int, int], None]
Links = frozenset[str]
EVERY: Links = frozenset()


class Decider(Protocol):
    """What decides: the module `symcheck.audit.decide`, or a stand-in in a test."""

    def expand(self, paper: Any, /) -> tuple[Any, ...]:
        """The obligations of a paper in printed order."""
        ...

    def fingerprint(self, obligation: Any, /) -> str:
        """A hash of everything the records of a declaration depend on."""
        ...

    def placed(self, obligation: Any, records: Sequence[Record], /) -> tuple[Record, ...]:
        """Records of the cache, with the lines on which the declaration stands now."""
        ...

    def decide(self, id: str, /) -> tuple[Record, ...]:
        """The records of one declaration; called in a worker process."""
        ...

    def weigh(self, declared: tuple[str, Sequence[Record]], /) -> tuple[Record, ...]:
        """The records with which hypotheses are needed; called in a worker process."""
        ...


class Interrupted(KeyboardInterrupt):
    """An interrupt, with the records that were decided before it, in printed order."""

    def __init__(self, records: list[Record], accepted: str = "") -> None:
        super().__init__(accepted)
        self.records = records


def audit(
    selection: Sequence[str],
    *,
    papers: Mapping[str, Paper],
    decide: Decider,
    cache: Cache,
    executor: Executor,
    timeout: float,
    weigh: bool = True,
    progress: Progress = lambda done, total: None,
) -> list[Record]:
    """The records of the selection in printed order; nothing selected means everything.

    A selection is "paper", "paper:number", "paper:number" with the letter of one link, or "paper:T6" for all rows of a
    list or table; SymcheckError if it names nothing, with the nearest names. What is decided is in the cache at once,
    so an interrupted audit loses only what was running, and raises Interrupted. A declaration that is killed or crashes
    is undecided and not cached. The checker has accepted whatever is reported. A cached result that it
    does not accept is decided again; a new one becomes undecided.

    With `weigh` it is also decided which hypotheses are needed, after all verdicts; that takes half as long again.
    """
    named = _papers_named(selection, papers) if selection else _sound(papers, cache.say)
    obligations = _expanded(named, decide)
    wanted = select(selection, list(obligations)) if selection else dict.fromkeys(obligations, EVERY)
    needed = _with_lemmas(wanted, obligations)
    fingerprints = {id: decide.fingerprint(obligations[id]) for id in needed}
    with _uncollected():
        kept = {id: decide.placed(obligations[id], rows) for id, rows in cache.find(fingerprints).items()}
        kept = kept if weigh else checked.unweighed(kept)
        records = {id: rows for id, rows in checked.accepted(kept).items() if rows == kept[id]}
    if refused := len(kept) - len(records):
        are = "is" if refused == 1 else "are"
        cache.say(f"{refused} of the results in the cache {are} not accepted by the checker; deciding again")
    progress(len(records), len(needed))
    new: dict[str, tuple[Record, ...]] = {}
    try:
        open_ids = [id for id in needed if id not in records]
        with closing(_answers(executor, decide.decide, open_ids, timeout)) as answers:
            for id, answer in answers:
                new[id] = _records(obligations[id], answer)
                if isinstance(answer, Done):
                    cache.put(id, fingerprints[id], new[id])
                progress(len(records) + len(new), len(needed))
        decided = {id: rows for id, rows in (records | new).items() if weigh and id in wanted}
        light = [(id, rows) for id, rows in decided.items() if not all(map(checked.is_weighed, rows))]
        with closing(_answers(executor, decide.weigh, light, timeout)) as weighed:
            for done, ((id, _), answer) in enumerate(weighed, 1):
                if isinstance(answer, Done):
                    new[id] = answer.value
                    cache.put(id, fingerprints[id], new[id])
                progress(len(needed) + done, len(needed) + len(light))
    except KeyboardInterrupt:
        known = records.keys() | new.keys()
        whole = {id: rows for id, rows in new.items() if known >= {*_lemmas(id, obligations)}}
        raise Interrupted(_asked_for(wanted, records | _accepted(whole, records))) from None
    for key in {Id.parse(id).paper for id in obligations}:
        cache.prune(key, obligations)
    return _asked_for(wanted, records | _accepted(new, records))


@contextmanager
def _uncollected() -> Iterator[None]:
    """No garbage collection while certificates are read and checked: it would take as long as reading them."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()  # nor is it later
        if was_enabled:
            gc.enable()


def _answers(
    executor: Executor, function: Callable[[K], T], tasks: Sequence[K], timeout: float
) -> Generator[tuple[K, Answer[T]]]:
    """The answers in order of completion; where nothing is asked no process is started."""
    if tasks:
        with closing(executor.map(function, tasks, timeout)) as answers:
            yield from answers


def _accepted(new: checked.Rows, records: checked.Rows) -> dict[str, tuple[Record, ...]]:
    with _uncollected():
        return checked.accepted(new, records)


def _with_lemmas(wanted: Iterable[str], obligations: Mapping[str, Obligation]) -> list[str]:
    """The declarations wanted, followed by those on whose relations they rest, which are not reported."""
    return reached(wanted, lambda id: _lemmas(id, obligations))


def _lemmas(id: str, obligations: Mapping[str, Obligation]) -> list[str]:
    """The declarations whose relations the proof of one may start from; "2.13.1b" is a link of 2.13.1."""
    key, item = Id.parse(id).paper, obligations[id].item
    places = item.plan.lemmas if isinstance(item, Assertion) else ()
    named = (str(Id.of(key, place).declaration) for place in places)
    return [name for name in named if name in obligations]


def _asked_for(wanted: Mapping[str, Links], records: Mapping[str, tuple[Record, ...]]) -> list[Record]:
    """The records that were asked for and are decided, in printed order."""
    decided = ((id, links) for id, links in wanted.items() if id in records)
    return _with_later([record for id, links in decided for record in _of_links(records[id], links)])


def _with_later(records: list[Record]) -> list[Record]:
    """Each erratum with what becomes of it later: which relations that rest on it are right, which share the fault.

    Only for the relations at hand: those that refer to the declaration, and the following links of the same chain.
    """
    about: defaultdict[str, list[Record]] = defaultdict(list)
    for record in records:
        for declaration in {record.declaration, *record.uses}:
            about[declaration].append(record)
    later = {r.id: _later(r, about[r.declaration]) for r in records if r.erratum}
    return [replace(r, erratum=replace(r.erratum, later=later[r.id])) if r.erratum else r for r in records]


def _later(wrong: Record, about: list[Record]) -> tuple[Later, ...]:
    resting = (r for r in about if r.id > wrong.id or wrong.declaration in r.uses)
    fate = {Verdict.PROVED: "is right", Verdict.REFUTED: "shares the fault or has another one"}
    return tuple(Later(id=r.id, fate=fate[r.verdict]) for r in resting if r.verdict in fate)


def select(selection: Iterable[str], ids: Sequence[str]) -> dict[str, Links]:
    """The selected declarations in printed order, each with the links asked for, EVERY standing for all of them."""
    chosen: dict[str, Links] = {}
    for text in selection:
        for id, links in _matches(text, ids).items():
            both = (chosen.get(id, links), links)
            chosen[id] = EVERY if EVERY in both else both[0] | both[1]
    return {id: chosen[id] for id in ids if id in chosen}


def _matches(text: str, ids: Sequence[str]) -> dict[str, Links]:
    asked = Id.parse(text)
    if text == asked.paper:
        return {id: EVERY for id in ids if Id.parse(id).paper == text}
    whole = [text] if text in ids else []
    if not whole or asked.place[-1:].isupper():  # a list ends in a capital letter: its rows with it
        whole += [id for id in ids if id.startswith(f"{text}.")]
    if whole:
        return dict.fromkeys(whole, EVERY)
    if (declared := str(asked.declaration)) in ids:
        return {declared: frozenset((text,))}
    near = get_close_matches(text, ids, n=3, cutoff=0.75)
    hint = f"did you mean {' or '.join(near)}?" if near else f"`symcheck check {asked.paper}` lists what there is"
    raise SymcheckError(f"{asked.paper} has no relation {asked.place!r}; {hint}")


def _papers_named(selection: Iterable[str], papers: Mapping[str, Paper]) -> list[Paper]:
    keys = [Id.parse(text).paper for text in selection]
    for key in keys:
        if key not in papers:
            near = get_close_matches(key, papers, n=1)
            hint = f"did you mean {near[0]}?" if near else f"known papers: {', '.join(papers)}"
            raise SymcheckError(f"there is no paper {key!r}; {hint}")
    return [papers[key] for key in papers if key in keys]


def _sound(papers: Mapping[str, Paper], say: Callable[[str], None]) -> Iterator[Paper]:
    """All papers but those whose declarations cannot be read, of which it is said why."""
    for key in papers:
        try:
            yield papers[key]
        except SymcheckError as error:
            say(str(error))


def _expanded(papers: Iterable[Paper], decide: Decider) -> dict[str, Obligation]:
    return {obligation.id: obligation for paper in papers for obligation in decide.expand(paper)}


def _records(obligation: Obligation, answer: Answer[tuple[Record, ...]]) -> tuple[Record, ...]:
    if isinstance(answer, Done):
        return answer.value
    limit = f"not decided within {answer.seconds:g} s" if isinstance(answer, Timeout) else answer.reason
    item = obligation.item
    record = Record(
        id=obligation.id,
        paper=obligation.paper.key,
        section=obligation.section.number,
        line=item.source.line,
        role=item.role,
        name=item.name,
        printed=" ".join(item.source.printed),
        words=item.source.words,
        verdict=Verdict.UNDECIDED,
        reason=limit,
        uses=tuple(str(Id.of(obligation.paper.key, place)) for place in item.uses),
    )
    return (record,)


def _of_links(records: tuple[Record, ...], links: Links) -> tuple[Record, ...]:
    """All records of a declaration, or those of the links that were asked for."""
    if unknown := sorted(links - {record.id for record in records}):
        raise SymcheckError(f"there is no relation {unknown[0]}; there are {', '.join(r.id for r in records)}")
    return tuple(record for record in records if not links or record.id in links)
