"""Running a notebook: in this process, for speed, or through a real Jupyter kernel. Both fill in the same outputs."""

from __future__ import annotations

import ast
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from symcheck.notebook.shown import Shown
from symcheck.statement import SymcheckError

Progress = Callable[[int, int], None]
TIMEOUT = 60  # seconds that a cell may take in a kernel


def in_process(notebook: Any, progress: Progress = lambda done, total: None) -> Any:
    """The notebook with the outputs of its cells, run in a namespace of its own; SymcheckError names a cell that fails."""
    from nbformat.v4 import new_output

    namespace: dict[str, Any] = {"__name__": "__main__"}
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    for count, cell in enumerate(cells, 1):
        shown = _run(cell.id, cell.source, namespace)
        cell.execution_count = count
        cell.outputs = [new_output("execute_result", shown, execution_count=count)]
        progress(count, len(cells))
    return notebook


def _run(id: str, source: str, namespace: dict[str, Any]) -> dict[str, str]:
    *statements, last = ast.parse(source).body
    if not isinstance(last, ast.Expr):
        raise SymcheckError(f"cell {id} shows nothing; its last line must be what it shows")
    try:
        exec(compile(ast.Module(statements, []), f"<{id}>", "exec"), namespace)
        shown = eval(compile(ast.Expression(last.value), f"<{id}>", "eval"), namespace)
    except Exception as error:
        raise SymcheckError(f"cell {id} fails with {type(error).__name__}: {error}") from error
    if not isinstance(shown, Shown):
        raise SymcheckError(f"cell {id} ends in a {type(shown).__name__}; end it in a call of symcheck.notebook.show")
    return shown._repr_mimebundle_()


def in_kernel(notebook: Any, folder: Path, progress: Progress = lambda done, total: None) -> Any:
    """The same through a Jupyter kernel of this Python, which runs in `folder`."""
    from jupyter_client.kernelspec import KernelSpecManager
    from jupyter_client.manager import AsyncKernelManager
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError

    total = sum(cell.cell_type == "code" for cell in notebook.cells)
    manager = AsyncKernelManager(kernel_spec_manager=KernelSpecManager(ensure_native_kernel=True))
    client = NotebookClient(
        notebook,
        km=manager,
        timeout=TIMEOUT,
        resources={"metadata": {"path": str(folder)}},
        record_timing=False,
        on_cell_executed=lambda cell, cell_index, execute_reply: progress(cell.execution_count, total),
    )
    try:
        client.execute(env={**os.environ, "PYDEVD_DISABLE_FILE_VALIDATION": "1"})
    except CellExecutionError as error:
        raise SymcheckError(f"a cell fails in the kernel with {error.ename}: {error.evalue}") from error
    for cell in notebook.cells:
        if streams := [output for output in cell.get("outputs", ()) if output.output_type != "execute_result"]:
            raise SymcheckError(f"cell {cell.id} has more than a result: {streams[0]}")
    return notebook
