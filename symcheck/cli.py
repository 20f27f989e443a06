"""The command line. Wires papers, decider, cache, executor and terminal; imports each only where it is needed."""

from __future__ import annotations

import json
import os
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar

import click

from symcheck import __version__
from symcheck.core.files import put
from symcheck.core.interrupts import INTERRUPTED, leave, raise_from_now_on
from symcheck.core.verdicts import SymcheckError, Verdict
from symcheck.kernels.codegen import target_names
from symcheck.views.exports import format_names, format_of

if TYPE_CHECKING:
    from symcheck.ledger.record import Record

F = TypeVar("F", bound=Callable[..., Any])
DIFFERS, BAD_INPUT, BROKEN_PIPE = 1, 2, 141
MOST_TOLD = 30  # differences that are named one by one
CHECKED_IN = "numpy"  # the target whose files stand in generated/
PRELOAD = ("sympy", "flint", "lark", "symcheck.audit.decide")


@dataclass(frozen=True)
class How:
    """The options that all deciding commands share."""

    jobs: int
    timeout: float
    no_cache: bool


class Commands(click.Group):
    """A group whose every error is one line on standard error."""

    def make_context(self, *args: Any, **kwargs: Any) -> click.Context:
        with _one_line_errors():
            raise_from_now_on()
            return super().make_context(*args, **kwargs)

    def invoke(self, ctx: click.Context) -> Any:
        with _one_line_errors():
            return super().invoke(ctx)


@contextmanager
def _one_line_errors() -> Iterator[None]:
    try:
        yield
    except click.exceptions.NoArgsIsHelpError:
        raise
    except click.UsageError as error:
        where = f"{error.ctx.command_path} --help" if error.ctx else "symcheck --help"
        _leave(f"{error.format_message().rstrip('.')}; see `{where}`", BAD_INPUT)
    except SymcheckError as error:
        _leave(str(error), BAD_INPUT)
    except KeyboardInterrupt as stop:
        _leave(f"interrupted{stop}", INTERRUPTED)
    except BrokenPipeError:
        # What is still buffered must not fail again when the interpreter flushes it at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise click.exceptions.Exit(BROKEN_PIPE) from None


def _leave(message: str, code: int) -> NoReturn:
    _say(" ".join(message.split()))
    raise click.exceptions.Exit(code) from None


def _say(message: str) -> None:
    click.echo(f"symcheck: {message}", err=True)


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _chunks(context: click.Context, option: click.Parameter, given: Sequence[str]) -> dict[str, int]:
    pairs = [text.rpartition("=") for text in given]
    wrong = [
        text
        for text, (axis, _, points) in zip(given, pairs, strict=True)
        if not axis or not points.isdecimal() or points == "0"
    ]
    if wrong:
        raise click.BadParameter(f"{wrong[0]!r} must be AXIS=POINTS, as a=100")
    return {axis: int(points) for axis, _, points in pairs}


def deciding(command: F) -> F:
    """Add the options of `How` to a command, which receives them as its parameter `how`."""
    options = (
        click.option(
            "--jobs",
            type=click.IntRange(0),
            default=_cores,
            show_default="cores",
            help="Worker processes; 0 decides in this process, without a time limit.",
        ),
        click.option(
            "--timeout",
            type=click.FloatRange(0, min_open=True),
            default=60.0,
            show_default=True,
            help="Seconds that one declaration may take.",
        ),
        click.option("--no-cache", is_flag=True, help="Decide everything anew and keep nothing."),
    )

    def with_options(*args: Any, jobs: int, timeout: float, no_cache: bool, **kwargs: Any) -> Any:
        return command(*args, how=How(jobs, timeout, no_cache), **kwargs)

    with_options.__name__, with_options.__doc__ = command.__name__, command.__doc__
    decorated: Any = with_options
    for option in reversed(options):
        decorated = option(decorated)
    return decorated  # type: ignore[no-any-return]


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="symcheck")
def cli() -> None:
    """Audit the printed equations of mechanics papers: proved, refuted or undecided.

    Exit codes: 0 the verdicts are those recorded, 1 they differ, 2 bad input, 130 interrupted.
    """


@cli.command()
@click.argument("selection", nargs=-1, metavar="[PAPER[:NUMBER]]...")
@click.option("--json", "as_json", is_flag=True, help="One JSON object with all items instead of the table.")
@click.option("--verdict", type=click.Choice([str(v) for v in Verdict]), help="Show only rows of this verdict.")
@deciding
def check(selection: Sequence[str], as_json: bool, verdict: str | None, how: How) -> None:
    """Decide the relations and compare the verdicts with those recorded.

    Without a selection: all papers. `mirer2009:2.1` also means its links 2.1a, 2.1b.
    """
    from symcheck.audit.run import Interrupted

    try:
        records = audit(selection, how, weigh=as_json)
    except Interrupted as stop:
        _print_ledger(stop.records, as_json, verdict, partial=True)
        raise
    _print_ledger(records, as_json, verdict)
    _compare(selection, records, as_json)


@cli.command()
@click.argument("name", metavar="PAPER:NUMBER|KERNEL")
@click.option("--certificate", is_flag=True, help="Print the whole certificate.")
@deciding
def show(name: str, certificate: bool, how: How) -> None:
    """Show one relation: as printed, as read, hypotheses, steps of the proof, certificate, counterexample, erratum.

    Or one kernel: what it computes, how accurately, and the relations on which it rests.
    """
    from symcheck.views import terminal

    out = terminal.console()
    if ":" not in name:
        _show_kernel(out, name, how)
        return
    for record in audit([name], how):
        terminal.show(out, record, certificate)


def _show_kernel(out: Any, name: str, how: How) -> None:
    from difflib import get_close_matches

    from symcheck.audit import kernels
    from symcheck.papers import load
    from symcheck.views import terminal

    keys = list(load())
    named = {known: (key, kernel) for key in keys for known, kernel in kernels.declared(key).items()}
    if name not in named:
        near = get_close_matches(name, named, n=1)
        example = f"{name}:NUMBER" if name in keys else near[0] if near else f"{keys[0]}:{name}"
        raise SymcheckError(f"{name!r} is neither of the form PAPER:NUMBER nor a kernel; did you mean {example}?")
    key, kernel = named[name]
    terminal.kernel(out, key, name, kernel, audit([f"{key}:{number}" for number in kernel.claims], how, weigh=False))


@cli.command()
@click.argument("selection", nargs=-1, metavar="[PAPER[:NUMBER]]...")
@click.option("--json", "as_json", is_flag=True, help="One JSON object with these items instead of text.")
@deciding
def errata(selection: Sequence[str], as_json: bool, how: How) -> None:
    """List what is wrong as printed, each with what is right: the weightiest first.

    Formulas and statements come one by one, with a counterexample, the corrected form and its proof; rows of lists and
    cells of tables, and slips such as a lost prime, in one table for each kind; last what the text does not say as it
    stands, and is read otherwise.
    """
    records = [record for record in audit(selection, how, weigh=as_json) if record.corrected]
    if as_json:
        _print_json(records)
        return
    from symcheck.core.verdicts import Group
    from symcheck.views import terminal

    out = terminal.console()
    terminal.errata(out, records)
    damaged = sum(record.group is Group.DAMAGED for record in records)
    out.print(f"{len(records) - damaged} errata; {damaged} places of damaged text")


@cli.command()
def papers() -> None:
    """List the papers: key, title, source, number of declarations."""
    from symcheck.audit import decide
    from symcheck.papers import load
    from symcheck.views import terminal

    counts = {key: (paper, Counter(str(o.item.role) for o in decide.expand(paper))) for key, paper in load().items()}
    terminal.papers(terminal.console(), counts)


@cli.command()
@click.option("--check", "only_check", is_flag=True, help="Write nothing; exit 1, name what differs, diff the kernels.")
@click.option(
    "--target",
    "name",
    type=click.Choice(target_names()),
    default=CHECKED_IN,
    show_default=True,
    help="Language of the kernels; for any but NumPy nothing else is written.",
)
@click.option(
    "--output",
    type=click.Path(file_okay=False, path_type=Path),
    help="Folder for another target than NumPy; default kernels-TARGET.",
)
@deciding
def generate(only_check: bool, name: str, output: Path | None, how: How) -> None:
    """Write kernels, certificates and recorded verdicts to generated/, or check that they are what would be written.

    With another target write the kernels for Numba, in C, or for any library of the array API.
    """
    from symcheck import kernels, papers
    from symcheck.audit import kernels as writing
    from symcheck.audit import outputs
    from symcheck.coq import confirmed
    from symcheck.kernels.codegen.target import target
    from symcheck.ledger import selftested, store

    checked_in = name == CHECKED_IN
    if checked_in and output:
        raise SymcheckError("NumPy kernels belong in generated/; leave --output out, or choose another --target")
    folder = kernels.folder() if checked_in else output or Path(f"kernels-{name}")
    records, files = audit((), how), target(name).files
    made = {key: writing.made(paper, records) for key, paper in papers.load().items()}
    texts = {key: (files(key, of_paper) if of_paper else {}, proofs) for key, (of_paper, proofs) in made.items()}
    if checked_in:
        contents = outputs.files(records, texts) | confirmed.files(folder, records) | selftested.files(folder)
    else:
        contents = {file: text.encode() for of_paper, _ in texts.values() for file, text in of_paper.items()}
    differing = store.differences(folder, contents, alone=checked_in)
    if only_check:
        click.echo(store.diff(folder, contents), nl=False)
    else:
        (store.write if checked_in else store.put)(folder, contents)
    left = differing if only_check else store.differences(folder, contents, alone=checked_in)
    outdated = selftested.outdated(folder, records) if checked_in else []
    for line in (*left, *outdated):
        _say(f"{folder.name}/{line}")
    if any(not line.endswith(store.UNKNOWN) for line in left):
        command = "" if checked_in else f" --target {name} --output {folder}"
        _say(f"run `symcheck generate{command}` to write what differs and to remove what is superfluous")
    if left or (outdated and only_check):
        raise click.exceptions.Exit(DIFFERS)
    click.echo(f"{folder}: {len(contents)} files, {len(differing)} {'differ' if only_check else 'rewritten'}")


@cli.command()
@click.argument("name", required=False)
@click.option(
    "--output",
    type=click.Path(dir_okay=False, readable=False, path_type=Path),
    help="A .png, .pdf or .svg file; default NAME.png.",
)
@click.option("--show", is_flag=True, help="Open the file in the viewer of this system.")
def plot(name: str | None, output: Path | None, show: bool) -> None:
    """Draw a figure of the numeric layer to a file. Without NAME: list the figures."""
    from symcheck.numeric import figures

    if name is None:
        if output or show:
            raise SymcheckError("which figure? `symcheck plot` lists them")
        names = list(figures.figures())
        for each in names:
            click.echo(f"{each:{max(map(len, names))}}  {figures.summary(each)}")
        return
    path = output or Path(f"{name}.png")
    with _output(path), _extra("plots"):
        try:
            figures.draw(name, path)
        except ValueError as error:
            raise SymcheckError(str(error)) from error
    click.echo(str(path))
    if show and click.launch(str(path)) != 0:
        raise SymcheckError(f"no viewer opens {path} here; the file is written")


@cli.command()
@click.argument("spec", type=click.Path(path_type=Path))
@click.option(
    "--out", required=True, type=click.Path(path_type=Path), help="FILE.zarr or FILE.nc, written when all is done."
)
@click.option(
    "--scheduler", metavar="ADDRESS", help="A dask.distributed scheduler, as tcp://HOST:8786; default threads."
)
@click.option(
    "--threads", type=click.IntRange(1), default=_cores, show_default="cores", help="Threads of this process."
)
@click.option("--chunk", "chunks", multiple=True, metavar="AXIS=POINTS", callback=_chunks, help="Length of a chunk.")
@click.option(
    "--chunk-memory",
    type=click.FloatRange(0, min_open=True),
    default=32.0,
    show_default=True,
    help="Megabytes of results in a chunk, along the axes whose length is not given.",
)
@click.option(
    "--wait",
    type=click.FloatRange(0, min_open=True),
    default=10.0,
    show_default=True,
    help="Seconds to wait for the scheduler and for workers.",
)
def sweep(
    spec: Path,
    out: Path,
    scheduler: str | None,
    threads: int,
    chunks: dict[str, int],
    chunk_memory: float,
    wait: float,
) -> None:
    """Evaluate a function on the outer product of its parameters, as the TOML file SPEC says, and keep the result.

    What was stopped goes on with the same command. Described in `symcheck.numeric.sweep`.
    """
    from symcheck.numeric.sweep import SweepError
    from symcheck.numeric.sweep import sweep as run

    try:
        with _progress("sweeping") as move:
            said = run(
                spec,
                out,
                scheduler=scheduler,
                threads=threads,
                chunks=chunks,
                memory=1e6 * chunk_memory,
                patience=wait,
                progress=move,
            )
    except SweepError as error:
        raise SymcheckError(str(error)) from error
    click.echo(said)


@cli.command()
@click.option("--only", multiple=True, metavar="NAME", help="A notebook, 6_errata, or the beginning of its name.")
@click.option("--kernel", is_flag=True, help="Run through a Jupyter kernel instead of in this process.")
@click.option("--write", is_flag=True, help="Accept what comes out: write notebooks/ anew.")
def notebooks(only: Sequence[str], kernel: bool, write: bool) -> None:
    """Execute the notebooks and compare what they show with what is committed; pictures are not compared."""
    from symcheck.views.notebook import committed

    differing = []
    for name in committed.names(only):
        with _progress(name) as move, _extra("notebooks"):
            found = committed.executed(name, kernel, move)
        if write:
            committed.write(name, found)
        told = committed.differences(name, found)
        differing += told
        click.echo(f"{name}: {sum('execution_count' in cell for cell in found.cells)} cells, {len(told)} differ")
    for line in differing[:MOST_TOLD]:
        _say(line)
    if differing:
        _say("run `symcheck notebooks --write` to accept what is shown now")
        raise click.exceptions.Exit(DIFFERS)


@contextmanager
def _extra(name: str) -> Iterator[None]:
    """What needs a library of this extra; SymcheckError says how to get it."""
    try:
        yield
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] == "symcheck":
            raise
        raise SymcheckError(f"{error.name} is not installed; run `pip install 'symcheck[{name}]'`") from error


@cli.command()
@click.option("--json", "as_json", is_flag=True, help="One JSON object with all counts instead of the table.")
@click.option("--seed", type=int, default=0, show_default=True, help="The same seed plants the same faults.")
@click.option("--faults", type=click.IntRange(1), default=21_000, show_default=True, help="About how many to plant.")
@click.option("--record", "recording", is_flag=True, help="Keep the result in generated/, for the report.")
@deciding
def selftest(as_json: bool, seed: int, faults: int, recording: bool, how: How) -> None:
    """Plant faults and count those that go unnoticed: the error rate of the audit itself.

    In statements, hypotheses, certificates, kernels, notation tables and proof methods; and true statements written
    otherwise, which must not be rejected. Exit code 1 if fewer than 99.9 % of the faults were rejected, or anything
    right was.
    """
    from symcheck.audit.executor import Pool, Serial
    from symcheck.selftest.run import classes, run
    from symcheck.selftest.table import show

    records = audit((), how)
    modules = (*PRELOAD, *(each.places.__module__ for each in classes().values()))
    with _progress("planting faults") as move:
        result = run(records, Pool(how.jobs, modules) if how.jobs else Serial(), faults, seed, move)
    told = result.to_json()
    if recording:
        from symcheck import kernels
        from symcheck.ledger import selftested

        _say(f"{selftested.record(kernels.folder(), told, records)} written")
    if as_json:
        click.echo(json.dumps(told, ensure_ascii=False, indent=1))
    else:
        from symcheck.views.terminal import console

        show(console(), told)
    if not result.is_sound:
        raise click.exceptions.Exit(DIFFERS)


def audit(selection: Sequence[str], how: How, *, weigh: bool = True) -> list[Record]:
    """The records of a selection: from the cache where it has them, else decided in workers, with a progress bar.

    Without `weigh` nothing is said about which hypotheses are needed.
    """
    from symcheck.audit import decide, run
    from symcheck.audit.cache import Cache, location
    from symcheck.audit.executor import Pool, Serial
    from symcheck.papers import load

    papers = load()
    cache = Cache(None if how.no_cache else location(), _say)
    executor = Pool(how.jobs, (*PRELOAD, *(f"symcheck.papers.{key}" for key in papers))) if how.jobs else Serial()
    state = [0, 0]
    try:
        with _progress("deciding") as move:

            def progress(done: int, total: int) -> None:
                state[:] = done, total
                move(done, total)

            return run.audit(
                selection,
                papers=papers,
                decide=decide,
                cache=cache,
                executor=executor,
                timeout=how.timeout,
                weigh=weigh,
                progress=progress,
            )
    except run.Interrupted as stop:
        kept = "nothing is kept" if how.no_cache else f"{state[0]} of {state[1]} declarations are decided and kept"
        raise run.Interrupted(stop.records, f"; {kept}") from None
    finally:
        cache.close()


@contextmanager
def _progress(what: str) -> Iterator[Callable[[int, int], None]]:
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from symcheck.views.terminal import progress_bar

    with progress_bar(what) as move:
        yield move


def _print_ledger(records: Sequence[Record], as_json: bool, verdict: str | None, partial: bool = False) -> None:
    """The rows of a verdict; a ledger that is partial says so before and after."""
    shown = [record for record in records if verdict is None or record.verdict == verdict]
    if as_json:
        _print_json(shown, partial)
        return
    from symcheck.views import terminal

    out = terminal.console()
    note = "PARTIAL: interrupted before all relations were decided" if partial else ""
    out.print(note, end="\n" * partial)
    for key, rows in _by_paper(shown).items():
        terminal.ledger(out, key, rows)
    terminal.summary(out, records)
    out.print(note, end="\n" * partial)


def _print_json(records: Sequence[Record], partial: bool = False) -> None:
    items = ",\n".join(json.dumps(record.to_json(), ensure_ascii=False) for record in records)
    said = '"partial": true, ' if partial else ""
    click.echo(f'{{"schema": 1, {said}"items": [\n{items}\n]}}')


def _by_paper(records: Sequence[Record]) -> dict[str, list[Record]]:
    papers: dict[str, list[Record]] = {}
    for record in records:
        papers.setdefault(record.paper, []).append(record)
    return papers


def _compare(selection: Sequence[str], records: Sequence[Record], quiet: bool) -> None:
    """Tell how the verdicts differ from those recorded, and exit 1 if they do."""
    from symcheck import kernels
    from symcheck.ledger import store

    folder, differing = kernels.folder(), []
    for key, rows in _by_paper(records).items():
        complete = not selection or key in selection
        differing += store.disagreements(rows, store.expected(folder, key), complete)
    for line in differing[:MOST_TOLD]:
        _say(line)
    if len(differing) > MOST_TOLD:
        _say(f"and {len(differing) - MOST_TOLD} more differences; ask for a smaller selection to see them")
    if differing:
        raise click.exceptions.Exit(DIFFERS)
    if not quiet:
        click.echo("All verdicts are those recorded.")


@cli.command()
@click.argument("selection", nargs=-1, metavar="[PAPER[:NUMBER]]...")
@click.option(
    "--output",
    type=click.Path(dir_okay=False, readable=False, path_type=Path),
    default=Path("symcheck-report.html"),
    show_default=True,
    help="The file to write.",
)
@click.option("--open", "show", is_flag=True, help="Open the file in the browser of this system.")
@deciding
def report(selection: Sequence[str], output: Path, show: bool, how: How) -> None:
    """Write the audit as one page to look at: errata, ledger, certificates, pictures.

    The page needs no network and no server. Notebooks in a folder notebooks/ here are searched for cells that name a
    claim.
    """
    from symcheck import kernels, papers
    from symcheck.ledger import selftested
    from symcheck.views import pictures
    from symcheck.views.page import sources
    from symcheck.views.page.page import Beside, Pictures, page

    records, known = audit(selection, how), papers.load()
    beside = Beside(
        sources.kernels(known, kernels.folder()),
        sources.cells(Path("notebooks")),
        Pictures(pictures.envelopes(), pictures.densities(), pictures.stability()),
        selftested.recorded(kernels.folder()),
    )
    text = page(records, sources.publications(known), beside).encode()
    with _output(output):
        put(output, text)
    click.echo(f"{output}: {len(records)} items, {len(text) / 1e6:.2f} MB")
    if show and click.launch(str(output)) != 0:
        raise SymcheckError(f"no browser opens {output} here; the file is written")


@cli.command()
@click.argument("selection", nargs=-1, metavar="[PAPER[:NUMBER]]...")
@click.option("--format", "name", type=click.Choice(format_names()), required=True, help="What to write.")
@click.option(
    "--output",
    type=click.Path(readable=False, path_type=Path),
    help="The file to write, or the folder for a format of many files; default: standard output, or symcheck-FORMAT.",
)
@deciding
def export(selection: Sequence[str], name: str, output: Path | None, how: How) -> None:
    """Write the ledger and the errata for other tools."""
    chosen = format_of(name)
    records = audit(selection, how)
    if chosen.files:
        folder = output or Path(f"symcheck-{name}")
        contents = chosen.files(records)
        for file, text in contents.items():
            with _output(folder / file):
                put(folder / file, text.encode())
        click.echo(f"{folder}: {len(contents)} files")
    elif chosen.text:
        text = chosen.text(records)
        if output:
            with _output(output):
                put(output, data := text.encode())
            click.echo(f"{output}: {len(records)} items, {len(data) / 1e6:.2f} MB")
        else:
            click.echo(text, nl=False)


@contextmanager
def _output(file: Path) -> Iterator[None]:
    """What goes to a file that was asked for; SymcheckError says why it cannot."""
    try:
        yield
    except OSError as error:
        why = error.strerror or error
        raise SymcheckError(f"{file} cannot be written ({why}); choose another with --output") from error


def main() -> None:
    """The entry point `symcheck`."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    try:
        cli(prog_name="symcheck")
    except SystemExit as stop:
        if stop.code == INTERRUPTED:
            leave()
        raise
