# Everything runs in .venv, which is made when it is first needed and kept up to date.
PYTHON ?= python3
HOST ?= 127.0.0.1
PORT ?= 8000
DATA ?= data

VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed
# The generated client is installed too, as soon as there is one.
CLIENT := $(wildcard sdk/python/pyproject.toml)

.DEFAULT_GOAL := help
.PHONY: help venv serve demo pictures test lint format types contracts tests bench openapi sdk clean

help: ## Show this list
	@awk -F ':.*## ' '/^[a-z]+:.*## / {printf "  make %-10s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

venv: $(STAMP) ## Make or refresh .venv (PYTHON=python3)

$(STAMP): pyproject.toml constraints.txt $(CLIENT)
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	  echo "parmech needs Python 3.11 or newer, and '$(PYTHON)' is not one." \
	    "Name another: make PYTHON=python3.12 $(MAKECMDGOALS)" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' || { \
	  echo "'$(PYTHON)' cannot make virtual environments." \
	    "On Debian and Ubuntu: apt-get install python3-venv" >&2; exit 1; }
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check \
	  --constraint constraints.txt --editable '.[test]' $(CLIENT:%/pyproject.toml=--editable %)
	@touch $@

serve: $(STAMP) ## Serve on HOST=127.0.0.1 PORT=8000, keeping everything in DATA=data
	@exec $(BIN)/parmech serve --host $(HOST) --port $(PORT) --data $(DATA)

demo: $(STAMP) ## Run the papers' two examples through HTTP; pictures and grids go to out/
	$(BIN)/python examples/demo.py

pictures: $(STAMP) ## Draw the papers' figures through HTTP again, into examples/pictures/
	$(BIN)/python examples/papers.py

test: lint types contracts tests ## Lint, types, import contracts, tests

lint: $(STAMP) ## ruff: rules and format
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

format: $(STAMP) ## Put the code into the format that lint asks for
	$(BIN)/ruff check --fix-only .
	$(BIN)/ruff format .

types: $(STAMP) ## mypy, strict
	$(BIN)/mypy .

contracts: $(STAMP) ## Who may import whom
	$(BIN)/lint-imports

# What only computes runs on all cores; what starts servers, kills and times them runs alone.
COMPUTING := analyses exports mechanics properties reference schemas
tests: $(STAMP) ## pytest (ARGS="tests/mechanics -k effort" for some)
ifdef ARGS
	$(BIN)/pytest $(ARGS)
else
	$(BIN)/pytest --numprocesses=auto --dist=loadscope $(COMPUTING:%=tests/%)
	$(BIN)/pytest $(COMPUTING:%=--ignore=tests/%)
endif

bench: $(VENV)/.bench ## Measure the kernels against floors and rivals
	$(BIN)/python -m benchmarks
	$(BIN)/python -m benchmarks.assembly

$(VENV)/.bench: $(STAMP)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check \
	  --constraint constraints.txt --editable '.[bench]'
	@touch $@

openapi: $(STAMP) ## Write openapi.json as the application describes itself
	$(BIN)/python -m service.openapi openapi.json

sdk: $(STAMP) ## Generate sdk/python from openapi.json
	$(BIN)/python sdk/generate.py sdk/python

clean: ## Remove what make made; DATA stays
	rm -rf $(VENV) out build dist .mypy_cache .pytest_cache .ruff_cache .import_linter_cache .hypothesis
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
