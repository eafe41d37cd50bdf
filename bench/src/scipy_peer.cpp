// SPDX-License-Identifier: MIT
//
// SciPy's functions of scipy.special.cython_special for the benchmark, called through the pointers that it
// offers to other modules (__pyx_capi__). FURIKO_LIBPYTHON names the Python library to load, as
// `bench/run --scipy` does; nothing of Python is needed to build this.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>

static struct {
   double (*k)(double, int), (*e)(double, int);
   double (*f)(double, double, int), (*einc)(double, double, int), (*rc)(double, double, int);
   double (*rf)(double, double, double, int), (*rd)(double, double, double, int), (*rg)(double, double, double, int);
   double (*rj)(double, double, double, double, int);
   void (*jacobi)(double, double, double *, double *, double *, double *);
} peer;

// Fills the table at an address with the functions of doubles, in its order.
static const char script[] = R"(
import ctypes
from scipy.special.cython_special import __pyx_capi__ as offered
name = ctypes.pythonapi.PyCapsule_GetName
name.restype, name.argtypes = ctypes.c_char_p, [ctypes.py_object]
pointer = ctypes.pythonapi.PyCapsule_GetPointer
pointer.restype, pointer.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
wanted = 'ellipk ellipe ellipkinc ellipeinc elliprc elliprf elliprd elliprg elliprj ellipj'.split()
table = (ctypes.c_void_p * len(wanted)).from_address(%ju)
for i, function in enumerate(wanted):
    forms = [offered[key] for key in (function, '__pyx_fuse_0' + function, '__pyx_fuse_1' + function) if key in offered]
    form = next(form for form in forms if name(form).startswith((b'double (', b'void (')))
    table[i] = pointer(form, name(form))
)";

// 1 where SciPy is there, 0 where it was not asked for; ends the program where it was and is not to be had
static int loaded() {
   const char *path = std::getenv("FURIKO_LIBPYTHON");
   if (!path) return 0;
   void *python = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
   auto start = python ? reinterpret_cast<void (*)(int)>(dlsym(python, "Py_InitializeEx")) : nullptr;
   auto run = python ? reinterpret_cast<int (*)(const char *)>(dlsym(python, "PyRun_SimpleString")) : nullptr;
   char text[sizeof script + 32];
   std::snprintf(text, sizeof text, script, static_cast<uintmax_t>(reinterpret_cast<uintptr_t>(&peer)));
   if (start) start(0);
   if (start && run && run(text) == 0) return 1;
   std::fprintf(stderr, "bench: no SciPy by %s\n", path);
   std::exit(1);
}

extern "C" {
int scipy_is_there() {
   static const int there = loaded();
   return there;
}
double scipy_k(double m) { return peer.k(m, 0); }
double scipy_e(double m) { return peer.e(m, 0); }
double scipy_f(double phi, double m) { return peer.f(phi, m, 0); }
double scipy_einc(double phi, double m) { return peer.einc(phi, m, 0); }
double scipy_rc(double x, double y) { return peer.rc(x, y, 0); }
double scipy_rf(double x, double y, double z) { return peer.rf(x, y, z, 0); }
double scipy_rd(double x, double y, double z) { return peer.rd(x, y, z, 0); }
double scipy_rg(double x, double y, double z) { return peer.rg(x, y, z, 0); }
double scipy_rj(double x, double y, double z, double p) { return peer.rj(x, y, z, p, 0); }
void scipy_jacobi(double u, double m, double *sn, double *cn, double *dn, double *am) { peer.jacobi(u, m, sn, cn, dn, am); }
}
