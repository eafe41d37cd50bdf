# SPDX-License-Identifier: MIT
"""Sphinx's settings. All that is not standard: formulas become MathML, by docutils, so that no page asks the network."""
import pathlib
import re

from docutils.nodes import SkipNode
from docutils.utils.math import MathError
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.util import logging

ROOT = pathlib.Path(__file__).parent.parent

project = "furiko"
author = "The furiko founders"
copyright = "2026, the furiko founders"
version = release = re.search(r'^version = "(.*)"', (ROOT / "fpm.toml").read_text(), re.M)[1]
extensions = ["myst_parser"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
# A dollar is money where it has a space inside
myst_dmath_allow_space = False
suppress_warnings = ["myst.header", "misc.highlighting_failure"]
html_theme = "furo"
html_title = f"furiko {release}"
html_show_sphinx = False
html_copy_source = False
html_math_renderer = "mathml"
html_static_path = ["static"]
html_css_files = ["math.css"]


def mathml(display):
    """A visitor that writes MathML"""
    def visit(writer, node):
        try:
            writer.body.append(tex2mathml(node.astext(), as_block=display))
        except MathError as error:
            logging.getLogger(__name__).warning("formula: %s", error, location=node)
        raise SkipNode
    return visit, None


def setup(app):
    app.add_html_math_renderer("mathml", mathml(False), mathml(True))
