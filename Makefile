# Two commands matter: `make audit` and `make test`. Needs Python 3.11 or newer and make, nothing else.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.stamp

.PHONY: audit test test-full gates bench coq clean

audit: $(STAMP)
	$(BIN)/symcheck check

test: gates
	$(BIN)/python -m pytest -n 2 -q -m "not slow"

test-full: gates
	$(BIN)/python -m pytest -n 2 -q

gates: $(STAMP)
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy --strict symcheck
	$(BIN)/lint-imports --no-cache
	$(BIN)/symcheck generate --check --no-cache
	$(BIN)/python -m symcheck.checker generated/certificates

bench: $(STAMP)
	$(BIN)/python tests/bench.py
	$(BIN)/python tests/bench_kernels.py

# Coq's kernel checks the proofs. It is not installed by this: what is missing is said (Debian: coq, libcoq-coquelicot).
coq: $(STAMP)
	$(BIN)/python -m symcheck.export.coq.compile
	rm -rf build/coq
	$(BIN)/symcheck export --format coq --output build/coq
	$(BIN)/python -m symcheck.export.coq.comparison build/coq
	$(BIN)/python -m symcheck.export.coq.compile build/coq --jobs 2

clean:
	rm -rf $(VENV) build dist *.egg-info .mypy_cache .ruff_cache .pytest_cache .import_linter_cache .hypothesis
	find symcheck generated tests -name __pycache__ -type d -prune -exec rm -rf {} +

# The versions are pinned once, in constraints.txt; the build runs with the pinned setuptools of the environment.
$(STAMP): pyproject.toml constraints.txt
	$(PYTHON) -c 'import sys; sys.exit("symcheck needs Python 3.11 or newer" if sys.version_info < (3, 11) else 0)'
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt setuptools
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt --no-build-isolation -e '.[dev]'
	touch $@
