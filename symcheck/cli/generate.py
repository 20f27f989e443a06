"""`symcheck generate`: writes generated/, or kernels for another target."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from symcheck.cli.errors import DIFFERS, say
from symcheck.cli.options import SELECTION, AuditOptions, audit_options
from symcheck.cli.records import audited
from symcheck.core.counts import number_of
from symcheck.core.verdicts import SymcheckError
from symcheck.kernels.codegen import target_names

CHECKED_IN = "numpy"  # the target whose files stand in generated/


@click.command(short_help="Write kernels, certificates and recorded verdicts.")
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
@SELECTION
@audit_options
def generate(selection: Sequence[str], only_check: bool, name: str, output: Path | None, options: AuditOptions) -> None:
    """Write kernels, certificates and recorded verdicts to generated/, or check that they are what would be written.

    Without a selection: of all papers that come with symcheck. Of the folder of an audit: to generated/ in it. With
    another target write the kernels for Numba, in C, or for any library of the array API.
    """
    from symcheck import papers
    from symcheck.audit import kernels as writing
    from symcheck.audit import outputs
    from symcheck.coq import confirmed
    from symcheck.kernels.codegen.target import target
    from symcheck.ledger import selftested, store
    from symcheck.views import figures

    checked_in, known = name == CHECKED_IN, papers.load()
    if checked_in and output:
        raise SymcheckError("NumPy kernels belong in generated/; leave --output out, or choose another --target")
    if mixed := [each for each in selection if each not in known.folders]:
        raise SymcheckError(
            f"{mixed[0]} is not the folder of an audit; leave it out to write all that is in generated/"
        )
    keys, ours = [*selection] or known.built_in, checked_in and not selection
    folder = outputs.folder(keys[0]) if checked_in else output or Path(f"kernels-{name}")
    records, files = audited(keys, options), target(name).files
    compiled = {key: writing.compiled_kernels(known[key], records) for key in keys}
    texts = {key: (files(key, of_paper) if of_paper else {}, proofs) for key, (of_paper, proofs) in compiled.items()}
    if checked_in:
        recorded = confirmed.files(folder, records) | selftested.files(folder) | figures.files(folder) if ours else {}
        contents = outputs.files(records, texts) | recorded
    else:
        contents = {file: text.encode() for of_paper, _ in texts.values() for file, text in of_paper.items()}
    differing = store.differences(folder, contents, alone=checked_in)
    if only_check:
        click.echo(store.diff(folder, contents), nl=False)
    else:
        (store.write if checked_in else store.put)(folder, contents)
    left = differing if only_check else store.differences(folder, contents, alone=checked_in)
    outdated = selftested.outdated(folder, records) if ours else []
    for line in (*left, *outdated):
        say(f"{folder.name}/{line}")
    if any(not line.endswith(store.UNKNOWN) for line in left):
        command = "" if checked_in else f" --target {name} --output {folder}"
        say(f"run `symcheck generate{command}` to write what differs and to remove what is superfluous")
    if left or (outdated and only_check):
        raise click.exceptions.Exit(DIFFERS)
    done = number_of(len(differing), "differs", "differ") if only_check else f"{len(differing):,} rewritten"
    click.echo(f"{folder}: {number_of(len(contents), 'file')}, {done}")
