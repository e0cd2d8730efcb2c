# Every target builds .venv first if it has to; all that must be there is Python 3.11 or later with venv.
PYTHON ?= $(shell for p in python3 python3.14 python3.13 python3.12 python3.11; do \
	$$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $$p && break; done)
BIN := .venv/bin
READY := .venv/.ready
# tests run side by side: numpy's own threads would wait for each other
export OPENBLAS_NUM_THREADS ?= 1

.PHONY: demo test lint generate bench notebooks picture clean

demo: $(READY)
	@mkdir -p out
	@$(BIN)/python -m osculant.compiled.prebuilt kernels/libraries conics curves enclosures
	$(BIN)/osculant approximate "t*cos(t), t*sin(t)" --from pi/6 --to 2*pi \
		--with conic --tolerance 1e-6 --write out/spiral.svg

test: $(READY)
	$(BIN)/pytest -n 2 --nbmake tests osculant notebooks

lint: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/python -m osculant.codegen.generate --check

generate: $(READY)
	$(BIN)/python -m osculant.codegen.generate

bench: $(READY)
	$(BIN)/python -m benchmarks.run
	$(BIN)/python -m benchmarks.peers.table

notebooks: $(READY)
	$(BIN)/jupyter nbconvert --to notebook --execute --inplace --ExecutePreprocessor.record_timing=False notebooks/*.ipynb

picture: $(READY)
	$(BIN)/python docs/picture.py

clean:
	rm -rf .venv out build dist *.egg-info .pytest_cache .mypy_cache .ruff_cache .import_linter_cache .hypothesis .benchmarks
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

$(READY): pyproject.toml constraints.txt
	@test -n "$(PYTHON)" || { echo "osculant needs Python 3.11 or later: make PYTHON=/path/to/python3 …"; exit 1; }
	$(PYTHON) -m venv .venv
	$(BIN)/pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[dev,plot]'
	@touch $@
