# SPDX-License-Identifier: MIT
#
# The library by GNU make and a Fortran compiler, for those without fpm: `make help` tells how.

ifeq ($(origin FC),default)
FC = gfortran
endif
FFLAGS ?= -O2
PREFIX ?= /usr/local
LIBDIR = $(PREFIX)/lib
INCLUDEDIR = $(PREFIX)/include
BUILD = build/make
KINDS = real32 real64 real128
# For a linker that is not GNU's or LLVM's, these two:
SHARED_FLAGS = -shared -Wl,-soname,$(soname) -Wl,--version-script="$(CURDIR)/tools/furiko.map"
PIC = -fPIC

version := $(shell sed -n 's/^version = "\(.*\)"/\1/p' fpm.toml)
# Before 1.0 a new minor version is a new interface.
soname = libfuriko.so.$(basename $(version))
sources := $(shell cat src/order)
library = $(patsubst %,$(BUILD)/%.o,$(basename $(notdir $(sources))))
app := $(wildcard app/*.[fF]90)
program = $(patsubst %,$(BUILD)/program/%.o,$(basename $(notdir $(app))))
vpath %.f90 $(sort $(dir $(sources))) app tools
vpath %.F90 $(sort $(dir $(sources))) app

ifeq ($(sort $(KINDS)),real32 real64)
macros = -DFURIKO_NO_REAL128
else ifneq ($(sort $(KINDS)),real128 real32 real64)
$(error KINDS is "real32 real64" or "real32 real64 real128"; for others: tools/amalgamate.py --kinds real64)
endif
# A compiler reads its own modules only, so they lie in a folder of its own; named as by CMake.
about := $(shell $(FC) --version 2>&1)
ifneq ($(findstring GNU Fortran,$(about)),)
compiler = GNU-$(shell $(FC) -dumpfullversion)
# What a C compiler has to link beside a static library; libquadmath is of some processors only. Where there is no
# shared library, furiko.pc names it without --static, too.
private = -lgfortran $(if $(findstring /,$(shell $(FC) -print-file-name=libquadmath.a)),-lquadmath) -lm
else ifneq ($(findstring flang,$(about)),)
compiler = LLVMFlang-$(shell $(FC) -dumpversion)
else
compiler = $(notdir $(firstword $(FC)))
endif
MODULES = $(INCLUDEDIR)/furiko/$(compiler)

# Modules are written to and read from the folder where a compiler works, whatever its options are.
compile = $(FC) $(FFLAGS) $(if $(SHARED),$(PIC)) $(macros)

all: $(BUILD)/libfuriko.a $(if $(SHARED),$(BUILD)/$(soname))

help:
	@echo 'make [-j] [all]      the library, in $(BUILD)'
	@echo 'make check           does it compute right?'
	@echo 'make program         the program furiko'
	@echo 'make install         library, modules, furiko.pc, licence; make uninstall takes them away'
	@echo 'make clean'
	@echo 'FC=$(FC) FFLAGS="$(FFLAGS)"; SHARED=1: the shared library, too'
	@echo 'KINDS="real32 real64": without real128'
	@echo 'PREFIX=$(PREFIX) DESTDIR=; BUILD=$(BUILD)'
	@echo 'LIBDIR=$(LIBDIR) INCLUDEDIR=$(INCLUDEDIR) MODULES=$(MODULES)'

$(BUILD)/libfuriko.a: $(library)
	rm -f $@
	$(AR) rcs $@ $(library)

$(BUILD)/$(soname): $(library) tools/furiko.map
	$(FC) $(FFLAGS) $(LDFLAGS) $(SHARED_FLAGS) $(library) -o $@

$(BUILD)/%.o: %.F90
	cd $(BUILD) && $(compile) -c "$(CURDIR)/$<" -o $(@F)

$(BUILD)/%.o: %.f90
	cd $(BUILD) && $(compile) -c "$(CURDIR)/$<" -o $(@F)

$(BUILD)/program/%.o: %.F90
	cd $(BUILD)/program && $(compile) -I.. -c "$(CURDIR)/$<" -o $(@F)

$(BUILD)/program/%.o: %.f90
	cd $(BUILD)/program && $(compile) -I.. -c "$(CURDIR)/$<" -o $(@F)

program: $(BUILD)/program/furiko
$(BUILD)/program/furiko: $(program) $(BUILD)/libfuriko.a
	$(FC) $(FFLAGS) $(LDFLAGS) $(program) $(BUILD)/libfuriko.a -o $@

check: $(BUILD)/program/check
	$<
$(BUILD)/program/check: $(BUILD)/program/check.o $(BUILD)/libfuriko.a
	$(FC) $(FFLAGS) $(LDFLAGS) $^ -o $@

# Rooms change rarely, and doors include many: all are compiled again.
$(library): $(wildcard src/*/*.inc) $(BUILD)/command
$(program): $(wildcard app/*.inc)
$(program) $(BUILD)/program/check.o: $(library)

# As soon as the command to compile is another one, everything is compiled again.
$(BUILD)/command: always
	@command -v $(firstword $(FC)) >/dev/null || { echo 'no compiler $(FC); call make FC=...' >&2; exit 1; }
	@mkdir -p $(BUILD)/program
	@echo '$(compile)' | cmp -s - $@ || { rm -f $(BUILD)/*.mod $(BUILD)/program/*.mod; echo '$(compile)' >$@; }

$(BUILD)/depend: src/order $(sources) $(app)
	@mkdir -p $(BUILD)
	@tools/dependencies '$$(BUILD)' $(sources) >$@
	@tools/dependencies '$$(BUILD)/program' $(app) >>$@

ifneq ($(filter-out help clean uninstall,$(or $(MAKECMDGOALS),all)),)
-include $(BUILD)/depend
endif
# `make -j clean all`: one after the other
ifneq ($(filter clean,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif

# What is installed is written down, for `make uninstall`.
put = install -d "$(DESTDIR)$(2)" && install -m $(or $(3),644) $(1) "$(DESTDIR)$(2)/" && \
   for file in $(1); do echo "$(DESTDIR)$(2)/$$(basename $$file)" >>$(BUILD)/installed; done
install: all
	@touch $(BUILD)/installed
	sed -e 's|@prefix@|$(PREFIX)|; s|@libdir@|$(LIBDIR)|; s|@modules@|$(MODULES)|' \
	   -e 's|@includedir@|$(INCLUDEDIR)|; s|@version@|$(version)|; s|@private@|$(private)|' \
	   -e 's|@libs@|$(if $(SHARED),,$(private))|' tools/furiko.pc.in >$(BUILD)/furiko.pc
	$(call put,$(BUILD)/libfuriko.a,$(LIBDIR))
	$(if $(SHARED),$(call put,$(BUILD)/$(soname),$(LIBDIR),755))
	$(if $(SHARED),ln -sf $(soname) "$(DESTDIR)$(LIBDIR)/libfuriko.so")
	$(if $(SHARED),echo "$(DESTDIR)$(LIBDIR)/libfuriko.so" >>$(BUILD)/installed)
	$(call put,$(BUILD)/*.mod,$(MODULES))
	$(call put,include/furiko.h include/furiko.hpp include/furiko_gsl.h include/furiko_f77.inc,$(INCLUDEDIR))
	$(call put,$(BUILD)/furiko.pc,$(LIBDIR)/pkgconfig)
	$(call put,LICENSE,$(PREFIX)/share/licenses/furiko)

uninstall:
	while read -r file; do rm -f "$$file"; done <$(BUILD)/installed
	-rmdir "$(DESTDIR)$(MODULES)" "$(DESTDIR)$(INCLUDEDIR)/furiko" "$(DESTDIR)$(PREFIX)/share/licenses/furiko"
	rm $(BUILD)/installed

clean:
	rm -rf $(BUILD)

.PHONY: all help program check install uninstall clean always
.DELETE_ON_ERROR:
