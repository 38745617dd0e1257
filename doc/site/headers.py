#!/usr/bin/env python3
"""What Doxygen has to be told of our comments (INPUT_FILTER of doc/Doxyfile.in).
  headers.py FILE     prints it with the comment at its head marked as that of the file, and, where the
                      class that it is about has no comment of its own, as that of the class as well.
                      Lines keep their numbers.
"""

import re
import sys

HEAD = re.compile(r"\A((?://[^\n]*\n)+)#pragma once\n")
CLASS = re.compile(r"\n((?:template <[^\n]*\n)?(?:class|struct) (\w+)[^;\n]*\{)")


def described(text, first, name):
    """A line for the class that the file is about: the one that the head's first line names, else the first."""
    classes = list(CLASS.finditer(text))
    named = [found for found in classes if first.startswith(f"/// {found.group(2)}:")]
    for found in (named or classes)[:1]:
        if text[:found.start()].endswith("\n"):  # a blank line; a comment of its own stands in no other place
            return text[:found.start()] + f"/// \\copydoc {name}" + text[found.start():]
    return text


def told(text, name):
    head = HEAD.match(text)
    if not head:
        return text
    lines = [re.sub(r"^///?", "///", line) for line in head.group(1).splitlines()]
    rest = described(text[head.end():], lines[0], name)
    return "\n".join(lines) + "\n/// \\file\n" + rest


def escaped(line):
    """<Element> in running text is no tag of HTML; what stands in backticks or is set in stays."""
    if not re.match(r" *///(<? )?(?! {4})", line):
        return line
    parts = re.split(r"(`[^`]*`)", line)
    return "".join(part if part.startswith("`") else re.sub(r"<(?=[A-Za-z/])", r"\\<", part) for part in parts)


def name_of(file):
    """As sources include it."""
    return re.sub(r"^.*?(framework|elements)/", "", file)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        text = file.read()
    if sys.argv[1].endswith(".hpp"):
        text = re.sub(r"^( *///)   +(\S.*)$", r"\1        \2", told(text, name_of(sys.argv[1])), flags=re.M)
        text = "\n".join(escaped(line) for line in text.split("\n"))
    else:
        text = re.sub(r"\]\((\w+/README)\.md\)", r"](../framework/dynamy/\1.html)", text)
    sys.stdout.write(text)


if __name__ == "__main__":
    main()
