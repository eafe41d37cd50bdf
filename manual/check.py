#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What can be wrong with the manual that Sphinx does not see: python3 manual/check.py HTML

Links and anchors of all pages lead somewhere, the Japanese pages have the sections of the English ones, the citation is
of this version, and worn wordings do not come back.
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).parent.parent
TRANSLATED = {"README.md": "README.ja.md", "doc/pendulum-exactly.md": "doc/pendulum-exactly.ja.md"}
# Sentences at which readers stumbled
WORN = ["made right", "names what is missing", "(over the weight)", "what q says", "what k says", "what the ratio says",
        "is no number", "are no numbers", "pay for their last digit"]
PROSE = ["README.md", "CONTRIBUTING.md", "doc/*.md", "manual/*.toml", "app/*.f90", "include/*", "build/manual/source/reference/*.md"]
SECTION = re.compile(r"^(##+) .*?(?: *<!-- (.*) -->)?$", re.M)


class Page(html.parser.HTMLParser):
    """The anchors and the links of a page"""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.anchors.update(attributes[key] for key in ("id", "name") if attributes.get(key))
        self.links += [attributes[key] for key in ("href", "src") if attributes.get(key)]


def broken_links(folder):
    pages = {path: Page(path.read_text()) for path in folder.rglob("*.html")}
    for path, page in pages.items():
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if not target.exists():
                yield f"{path}: {link} is not there"
            elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].anchors:
                yield f"{path}: {link} has no such anchor"


def missing_sections():
    """As many headings of each depth in each place"""
    for english, japanese in TRANSLATED.items():
        here, there = ([match[1] for match in SECTION.finditer(re.sub(r"^```.*?^```$", "", (ROOT / page).read_text(), flags=re.M | re.S))]
                       for page in (english, japanese))
        if here != there:
            yield f"{japanese} has not the {len(here)} sections of {english}, in this order"


def citation():
    version = re.search(r'^version = "(.*)"', (ROOT / "fpm.toml").read_text(), re.M)[1]
    if f"\nversion: {version}\n" not in (ROOT / "CITATION.cff").read_text():
        yield f"CITATION.cff is not of version {version}"


def worn_wordings():
    for pattern in PROSE:
        for path in ROOT.glob(pattern):
            text = re.sub(r"\s+(?:!> ?|! ?|//! ?)?", " ", path.read_text())
            yield from (f"{path.relative_to(ROOT)}: '{words}'" for words in WORN if words in text)


def main():
    faults = [*broken_links(pathlib.Path(sys.argv[1]).resolve()), *missing_sections(), *citation(), *worn_wordings()]
    print("\n".join(faults) or "links, anchors, sections, citation and wording are fine")
    sys.exit(bool(faults))


main()
