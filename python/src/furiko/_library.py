# SPDX-License-Identifier: MIT
"""The shared library: found, loaded, and of this version."""

import ctypes
import os
from importlib.resources import files

from ._version import __version__


def _path() -> str:
    """Of the library beside this file, or of another that is asked for"""
    if asked := os.environ.get("FURIKO_LIBRARY"):
        return asked
    for entry in files(__package__).iterdir():
        if entry.name in ("libfuriko.so", "libfuriko.dylib", "libfuriko.dll"):
            return str(entry)
    raise ImportError("furiko: no shared library; 'pip install ./python' builds it, FURIKO_LIBRARY names another")


def _load(loader: type) -> ctypes.CDLL:
    try:
        return loader(_path())
    except OSError as error:
        raise ImportError(f"furiko: {error}") from None


# Calls of `library` let other threads of Python run meanwhile; for one number that takes longer than to compute it.
library, quick_library = _load(ctypes.CDLL), _load(ctypes.PyDLL)
_number = library.furiko_version() if hasattr(library, "furiko_version") else 0
if f"{_number // 10000}.{_number // 100 % 100}.{_number % 100}" != __version__:
    raise ImportError(f"furiko: {_path()} is not the library of furiko {__version__}")
