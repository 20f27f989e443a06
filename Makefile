# Two commands matter: `make audit` and `make test`. Needs Python 3.11 or newer and make, nothing else.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.stamp
DEV := $(VENV)/.dev
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt

# The newest of these Pythons that is there, which the quick tests run on too; pyenv has it whichever is current.
NEWEST := $(firstword $(foreach version,3.14 3.13,$(shell PYENV_VERSION=$(version) python$(version) -c 'print("python$(version)")' 2>/dev/null)))
NEWEST_VENV := .venv-newest

# Cases of a test that are run, evenly spread, where it has more; all of them are run by `make test-full`.
CASES ?= 8

.PHONY: audit test test-full test-newest quick stripped gates notebooks docs bench bench-gpu selftest browser coq coq-check install-coq clean

audit: $(STAMP)
	$(BIN)/symcheck check

test: gates quick

test-full: gates
	$(BIN)/python -m pytest -n 2 -q

# As they are, and without docstrings, as -OO leaves them out. Where there is no such Python it says so, which is no
# failure.
test-newest:
ifeq ($(NEWEST),)
	@echo "no Python newer than 3.12: the quick tests on it are skipped"
else
	PYENV_VERSION=$(NEWEST:python%=%) $(MAKE) VENV=$(NEWEST_VENV) PYTHON=$(NEWEST) quick
	PYENV_VERSION=$(NEWEST:python%=%) $(MAKE) VENV=$(NEWEST_VENV) PYTHON=$(NEWEST) stripped
endif

# Without docstrings; pytest says that the assertions of its helpers are left out, too.
stripped: $(DEV)
	PYTHONOPTIMIZE=2 $(BIN)/python -m pytest -n 2 -q -m "not slow" --cases $(CASES) -W ignore::pytest.PytestConfigWarning

quick: $(DEV)
	$(BIN)/python -m pytest -n 2 -q -m "not slow" --cases $(CASES)

gates: $(DEV)
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy --strict symcheck
	$(BIN)/lint-imports --no-cache
	rm -rf build/cache
	SYMCHECK_CACHE=build/cache $(BIN)/symcheck generate --check
	SYMCHECK_CACHE=build/cache $(BIN)/symcheck generate symcheck/relations --check
	$(BIN)/python -m symcheck.checker generated symcheck/relations/generated

notebooks: $(DEV)
	$(BIN)/jupyter lab notebooks

# The reference of all public names, from their docstrings; it needs no network, and a warning is an error.
docs: $(DEV)
	$(BIN)/python tests/build_docs.py build/docs

# What they print is recorded in generated/figures.md.
bench: $(DEV)
	OPENBLAS_NUM_THREADS=1 $(BIN)/python tests/bench_record.py bench_ensemble.py
	$(BIN)/python tests/bench_record.py bench.py bench_kernels.py bench_mixes.py bench_engines.py bench_c.py bench_numba.py bench_envelope.py bench_sweep.py bench_decide.py bench_corpus.py

# Plants faults and keeps what becomes of them, for the report and generated/figures.md.
selftest: $(DEV)
	$(BIN)/symcheck selftest --record

bench-gpu: $(DEV)
	$(BIN)/symcheck generate --target array --output kernels-array
	$(BIN)/python tests/bench_gpu.py kernels-array

# Chromium and Firefox for the tests of the report, from Debian; they are skipped where there is none.
browser:
	which chromium firefox-esr >/dev/null || { apt-get update -qq && apt-get install -y -qq chromium firefox-esr; }

# Coq's kernel checks the proofs; what comes out is written to generated/coq, or compared with what is there. Coq is not
# installed by this: what is missing is said.
coq: AFTER := --record
coq-check: AFTER := --check
coq coq-check: $(STAMP)
	$(BIN)/python -m symcheck.coq.compile
	rm -rf build/coq
	$(BIN)/symcheck export --format coq --output build/coq
	$(BIN)/python -m symcheck.coq.comparison build/coq
	$(BIN)/python -m symcheck.coq.compile build/coq --jobs 2 $(AFTER)

install-coq:
	test -d "$$(coqc -where 2>/dev/null)/user-contrib/Coquelicot" || { apt-get update -qq && apt-get install -y -qq coq libcoq-coquelicot; }

clean:
	rm -rf $(VENV) $(NEWEST_VENV) kernels-* build dist *.egg-info .mypy_cache .ruff_cache .pytest_cache .import_linter_cache .hypothesis
	find symcheck generated tests -name __pycache__ -type d -prune -exec rm -rf {} +

# The versions are pinned once, in constraints.txt; the build runs with the pinned setuptools of the environment.
$(STAMP): pyproject.toml constraints.txt
	$(PYTHON) -c 'import sys; sys.exit("symcheck needs Python 3.11 or newer" if sys.version_info < (3, 11) else 0)'
	$(PYTHON) -m venv $(VENV)
	$(PIP) setuptools
	$(PIP) --no-build-isolation -e .
	touch $@

# What the tests, the benchmarks and the optional parts need beside it.
$(DEV): $(STAMP)
	$(PIP) --no-build-isolation -e '.[dev]'
	touch $@
