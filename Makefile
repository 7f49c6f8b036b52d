# The front door. `make help` says what there is; CMake does the work (CMakePresets.json).
SHELL := /bin/bash
.DEFAULT_GOAL := help
.PHONY: help dependencies build pullout test install deb sanitize sanitize-fem format clean

# deal.II needs up to 1.5 GB for one file, so a machine with many cores and little memory gets fewer jobs.
JOBS ?= $(shell awk -v cores=$$(nproc) '/MemAvailable/ {n = int($$2/1500000); if (n < 1) n = 1; \
  print n < cores ? n : cores}' /proc/meminfo)
INSTALL ?= yes
RESULTS ?= results/quick
PREFIX ?= /usr/local

RELEASE := build/release
PACKAGE := build/package
SANITIZED := build/asan-ubsan

# Open MPI asks for these when it runs as root, in a container or with more ranks than cores.
export OMPI_ALLOW_RUN_AS_ROOT ?= 1
export OMPI_ALLOW_RUN_AS_ROOT_CONFIRM ?= 1
export OMPI_MCA_rmaps_base_oversubscribe ?= 1
export OMPI_MCA_btl_vader_single_copy_mechanism ?= none
export OMPI_MCA_btl_base_warn_component_unused ?= 0
export DESTDIR

help:
	@echo 'Interlock: pull-out tests of geogrids in ballast of clumps'
	@echo
	@echo '  make pullout    install what is missing, build, run the quick coupled pull-out test'
	@echo '  make test       install what is missing, build, run every test'
	@echo '  make build      install what is missing, build the program build/release/bin/interlock'
	@echo '  make install    build, then install program and libraries below PREFIX, for this machine'
	@echo '  make deb        build Debian packages for any x86-64 processor, in build/package'
	@echo '  make sanitize   unit tests under the address and undefined-behaviour sanitizers'
	@echo '  make sanitize-fem   the same for all tests of the beams and of their laboratory (half an hour)'
	@echo '  make format     clang-format on every source file'
	@echo '  make clean      remove the build folders (results/ stays)'
	@echo
	@echo '  Variables: JOBS=$(JOBS) (parallel jobs), INSTALL=no (leave the packages alone),'
	@echo '  RESULTS=$(RESULTS) (where make pullout writes), PREFIX=$(PREFIX), DESTDIR (where make install does)'

dependencies:
ifneq ($(INSTALL),no)
	@bash scripts/install_packages.sh
endif

build: dependencies
	@echo 'Building in $(RELEASE) with $(JOBS) jobs.'
	@cmake --preset release --log-level=WARNING >/dev/null
	@cmake --build --preset release --parallel $(JOBS)
	@echo 'The program: $(RELEASE)/bin/interlock. For "import interlock" in /usr/bin/python3:'
	@echo '  export PYTHONPATH=$(CURDIR)/$(RELEASE)/python'

pullout: build
	@echo 'Running the quick coupled pull-out test cases/pullout/quick.prm.'
	@$(RELEASE)/bin/interlock run cases/pullout/quick.prm --output $(RESULTS) --force
	@test -s $(RESULTS)/figures/force_displacement.png || \
	  { echo 'The run ended without its figure; see $(RESULTS)/run.log.' >&2; exit 1; }
	@echo
	@echo 'Pull-out force over displacement: $(RESULTS)/figures/force_displacement.png'
	@if [ -s $(RESULTS)/report.html ]; then echo 'Report: $(RESULTS)/report.html'; fi
	@echo 'Numbers: $(RESULTS)/summary.json and history.csv; stones and geogrid for ParaView: *.xdmf'

test: build
	@echo 'Running the tests with $(JOBS) jobs.'
	@bash scripts/run_tests.sh $(RELEASE) $(JOBS)

# With sudo: `make build` as yourself first. DESTDIR is put before PREFIX, for packagers.
install: build
	@cmake --install $(RELEASE) --prefix $(PREFIX) --strip >/dev/null
	@echo 'Installed: $(DESTDIR)$(PREFIX)/bin/interlock; for other programs: find_package(Interlock) of CMake.'

deb: dependencies
	@echo 'Building in $(PACKAGE) with $(JOBS) jobs.'
	@cmake --preset package --log-level=WARNING >/dev/null
	@cmake --build --preset package --parallel $(JOBS)
	@cd $(PACKAGE) && rm -f *.deb && cpack --config CPackConfig.cmake >/dev/null
	@ls $(PACKAGE)/*.deb

# Leaks inside MPI and PETSc start-up are not ours; everything else counts. Whole call stacks (no fast
# unwinding) are what tells the two apart. deal.II's debug library comes with them: it checks every answer of PETSc.
SANITIZERS := LSAN_OPTIONS=suppressions=$(CURDIR)/cmake/leak_suppressions.txt:print_suppressions=0 \
  ASAN_OPTIONS=fast_unwind_on_malloc=0 UBSAN_OPTIONS=print_stacktrace=1

sanitize: sanitized-target = unit_tests
sanitize: sanitized-tests = -L unit
sanitize-fem: sanitized-target = fem_tests
sanitize-fem: sanitized-tests = -R '/fem_|_laboratory'
sanitize sanitize-fem: dependencies
	@echo 'Building $(sanitized-target) with sanitizers in $(SANITIZED) with $(JOBS) jobs.'
	@cmake --preset asan-ubsan --log-level=WARNING >/dev/null
	@cmake --build --preset asan-ubsan --parallel $(JOBS) --target $(sanitized-target)
	@$(SANITIZERS) bash scripts/run_tests.sh $(SANITIZED) $(JOBS) $(sanitized-tests)

format:
	@command -v clang-format >/dev/null || { echo 'Install clang-format first.' >&2; exit 1; }
	@clang-format -i $$(git ls-files '*.h' '*.cc')

clean:
	@rm -rf build
	@echo 'Removed build/.'
