#!/usr/bin/env python3
"""Follows every link and picture of a folder of web pages that stays inside of it.
  check_links.py FOLDER     prints what leads nowhere, with its page; exit status 1 if there is any
"""

import html.parser
import os
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.links, self.anchors = [], set()
        with open(file, encoding="utf-8") as opened:
            self.feed(opened.read())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


def broken(folder, skip=("replays",)):
    """(page, link) of every link that leads nowhere."""
    files = [os.path.join(where, name) for where, _, names in os.walk(folder) for name in names]
    pages = {file: Page(file) for file in files
             if file.endswith(".html") and os.path.relpath(file, folder).split(os.sep)[0] not in skip}
    known = set(files)
    for file, page in pages.items():
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc or link == "#nested-classes":  # Doxygen: private ones are not shown
                continue
            target = os.path.normpath(os.path.join(os.path.dirname(file), urllib.parse.unquote(parts.path))) if parts.path else file
            anchor = urllib.parse.unquote(parts.fragment)
            if target not in known or (anchor and target in pages and anchor not in pages[target].anchors):
                yield os.path.relpath(file, folder), link


def main():
    found = sorted(set(broken(os.path.abspath(sys.argv[1]))))
    for page, link in found:
        print(f"{page}: {link} leads nowhere", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
