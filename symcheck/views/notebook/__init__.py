"""Notebooks: what cells call to show records, derivations and figures, and how notebooks are built, run and compared.

`show` is for readers. `source` makes a notebook of a Markdown file, `execute` runs it, `compare` tells what changed.
"""
