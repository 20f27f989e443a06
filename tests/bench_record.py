"""Runs benchmarks one after another, and records what each prints in generated/bench.json and generated/figures.md.

python tests/bench_record.py bench.py bench_kernels.py ...
"""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from datetime import date
from pathlib import Path

from symcheck import kernels
from symcheck.views.figures import Output, record

TITLES = {
    "bench.py": "Proofs against SymPy's own means, and the checker",
    "bench_kernels.py": "Each kernel: speed against `lambdify(cse=True)`, and accuracy",
    "bench_mixes.py": "Kernels as they are called: numbers beside arrays, shapes, `out=`",
    "bench_engines.py": "Compiled kernels against what limits them",
    "bench_c.py": "Kernels in C",
    "bench_numba.py": "Kernels for Numba",
    "bench_envelope.py": "Momentum envelopes against Qhull",
    "bench_ensemble.py": "Ensembles of paths against plain NumPy",
    "bench_decide.py": "Any formula: corrections of public texts, beside other tools",
    "bench_corpus.py": "The reader on displays of public repositories, beside other parsers",
    "bench_sweep.py": "Sweeps: what they cost besides the function",
}
MARKDOWN = ("bench_kernels.py", "bench_mixes.py", "bench_engines.py", "bench_decide.py", "bench_corpus.py")


def machine() -> str:
    """The machine in words: cores, kind of processor, Python."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return f"{cores} cores ({platform.machine()}), Python {platform.python_version()}"


def printed(script: str) -> list[str]:
    """The lines that a script prints, which are shown while it runs; CalledProcessError if it fails."""
    lines = []
    command = [sys.executable, str(Path(__file__).with_name(script))]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            lines.append(line.rstrip())
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, command)
    while lines and not lines[-1]:
        lines.pop()
    return lines


def main(scripts: list[str]) -> None:
    """Run, show and record each script."""
    for script in scripts:
        lines, today = printed(script), date.today().isoformat()
        output = Output(script, TITLES[script], today, machine(), script in MARKDOWN, tuple(lines))
        record(kernels.folder(), output)


if __name__ == "__main__":
    main(sys.argv[1:])
