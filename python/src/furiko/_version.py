# SPDX-License-Identifier: MIT
# Written by tools/make_python.py.
__version__ = "0.3.0"
