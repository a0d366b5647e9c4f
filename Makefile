# Needs python3 (3.11 or newer) and make, nothing else. Everything goes into .venv.
PYTHON ?= python3
BIN := .venv/bin
EXAMPLE := src/kinetruss/library/examples/double_octahedral_slew.yaml

.PHONY: setup demo shell test quick lint docs pictures bench bench-peers lock viewer clean

# Everything for work on kinetruss: what the demo needs, test tools, a browser's driver, the site's builder.
setup: .venv/.ready

.venv/.ready: requirements.lock .venv/.demo
	@echo "Setting up .venv: the other packages (1.5 GB) ..."
	@$(BIN)/python .ci/packages.py requirements.lock
	@$(BIN)/kinetruss compile
	@touch $@
	@echo "Ready. To use kinetruss in a shell: . .venv/bin/activate   (or: make shell)"

# What kinetruss itself needs, with the studio.
.venv/.demo: requirements-demo.lock pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	  echo "kinetruss needs Python 3.11 or newer; $(PYTHON) is $$($(PYTHON) -V 2>&1). Name another one: make PYTHON=python3.12" >&2; exit 2; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { \
	  echo "$(PYTHON) cannot make a virtual environment: its ensurepip module is missing." >&2; \
	  echo "On Debian or Ubuntu: apt-get install python3-venv" >&2; \
	  echo "(for a python3 that is not the system's own: apt-get install python3.N-venv)" >&2; exit 2; }
	@echo "Setting up .venv: packages first (0.8 GB), then the kernels ..."
	@$(PYTHON) -m venv .venv
	@$(BIN)/python .ci/packages.py requirements-demo.lock
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e .
	@$(BIN)/python -m compileall -q src
	@echo "Compiling the kernels, once: about a minute ..."
	@$(BIN)/kinetruss compile --runs
	@touch $@
	@echo "Ready. To use kinetruss in a shell: . .venv/bin/activate   (or: make shell)"

# A shell in which `kinetruss` and `python` are those of .venv.
shell: .venv/.demo
	@PATH="$(CURDIR)/$(BIN):$$PATH" VIRTUAL_ENV="$(CURDIR)/.venv" $${SHELL:-/bin/sh}

# The main job: a double-octahedral bay slews; forces, margins, motor currents, pictures.
demo: .venv/.demo
	@$(BIN)/kinetruss run $(EXAMPLE) -o runs/demo --overwrite --pictures

test: setup
	@$(BIN)/pytest -n 2 --dist loadfile

# The quick tests of the parts that a change touches, or of one: make quick PART=statics
quick: setup
	@$(BIN)/python tests/quick.py $(PART)

lint: setup
	@$(BIN)/ruff check .
	@$(BIN)/ruff format --check .
	@$(BIN)/mypy
	@$(BIN)/lint-imports

# The site into build/site: tutorials and gallery are executed, links between pages are checked.
docs: setup
	@$(BIN)/python -m sphinx -W --keep-going -j auto -q -b html docs build/site
	@echo "build/site/index.html"

# The pictures under docs/pictures, anew; needs chromium and pdftoppm.
pictures: setup
	@$(BIN)/python docs/site/pictures.py

bench: setup
	@$(BIN)/python bench/inverse_dynamics.py

# The codes that bench/forward.py and bench/robots.py compare with, into .venv.
bench-peers: setup
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[peers]' --no-build-isolation

# Pins for Python 3.11 and newer, hashes included; needs uv. Those of the demo are among those of everything.
PINS := --universal --python-version 3.11 --generate-hashes --no-header --no-annotate --quiet
lock:
	uv pip compile pyproject.toml --extra cluster --extra exchange --extra export --extra mesh --extra notebook --extra optimum --extra render --extra studio --group dev $(PINS) -o requirements.lock
	uv pip compile pyproject.toml --extra studio --group build -c requirements.lock $(PINS) -o requirements-demo.lock

# The page of kinetruss view, bundled from viewer-src; needs node and npm. Its units and colours come from the package.
viewer: setup
	@$(BIN)/python -m kinetruss.display.palettes viewer-src/src/display.js
	cd viewer-src && npm ci --ignore-scripts --no-audit --no-fund --silent && npm run --silent build

clean:
	rm -rf .venv build dist runs
