"""Running a notebook: in this process, for speed, or through a real Jupyter kernel. Both fill in the same outputs."""

from __future__ import annotations

import ast
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from symcheck.core.verdicts import SymcheckError
from symcheck.views.notebook.live import VIEW
from symcheck.views.notebook.output import Output

if TYPE_CHECKING:
    from nbformat import NotebookNode

Progress = Callable[[int, int], None]
TIMEOUT = 60  # seconds that a cell may take in a kernel


def in_process(notebook: NotebookNode, progress: Progress = lambda done, total: None) -> NotebookNode:
    """The notebook with the outputs of its cells, run in one namespace; SymcheckError names a cell that fails."""
    from nbformat.v4 import new_output

    namespace: dict[str, object] = {"__name__": "__main__"}
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    for count, cell in enumerate(cells, 1):
        shown = _run(cell.id, cell.source, namespace)
        cell.execution_count = count
        cell.outputs = [new_output("execute_result", shown, execution_count=count)]
        progress(count, len(cells))
    return notebook


def _run(id: str, source: str, namespace: dict[str, object]) -> dict[str, str]:
    *statements, last = ast.parse(source).body
    if not isinstance(last, ast.Expr):
        raise SymcheckError(f"cell {id} shows nothing; its last line must be what it shows")
    try:
        exec(compile(ast.Module(statements, []), f"<{id}>", "exec"), namespace)
        value = eval(compile(ast.Expression(last.value), f"<{id}>", "eval"), namespace)
    except Exception as error:
        raise SymcheckError(f"cell {id} fails with {type(error).__name__}: {error}") from error
    if not isinstance(value, Output):
        raise SymcheckError(
            f"cell {id} ends in a {type(value).__name__}; end it in a call of symcheck.views.notebook.show"
        )
    return value._repr_mimebundle_()


def in_kernel(notebook: NotebookNode, folder: Path, progress: Progress = lambda done, total: None) -> NotebookNode:
    """The same through a Jupyter kernel of this Python, which runs in `folder`."""
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

    total, metadata = sum(cell.cell_type == "code" for cell in notebook.cells), notebook.metadata.copy()
    client = NotebookClient(
        notebook,
        kernel_name="python3",
        timeout=TIMEOUT,
        extra_arguments=["--log-level=ERROR"],
        shutdown_kernel="immediate",  # a kernel that is asked to end, and given time, tells of what it was at
        resources={"metadata": {"path": str(folder)}},
        record_timing=False,
        on_cell_executed=lambda cell, cell_index, execute_reply: progress(cell.get("execution_count") or 0, total),
    )
    try:
        client.execute()
    except CellExecutionError as error:
        raise SymcheckError(f"a cell fails in the kernel with {error.ename}: {error.evalue}") from error
    except Exception as error:
        if hasattr(client, "_async_cleanup_kernel_future"):  # where nbclient takes Ctrl-C itself, and ends the kernel
            raise KeyboardInterrupt from None
        if isinstance(error, CellTimeoutError):
            raise SymcheckError(f"a cell takes more than {TIMEOUT} s in the kernel; run without --kernel") from error
        if isinstance(error, DeadKernelError):
            raise SymcheckError("the kernel has died; run without --kernel") from error
        raise
    notebook.metadata = metadata  # the kernel has put its version there, and the state of widgets
    for cell in notebook.cells:
        for output in cell.get("outputs", ()):
            if output.output_type != "execute_result":
                raise SymcheckError(
                    f"cell {cell.id} prints something in addition to what it shows: {output.get('text', output)}"
                )
            output.data.pop(VIEW, None)
    return notebook
