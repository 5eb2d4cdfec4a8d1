"""Checks the One Definition Rule where neither compiler nor linker does: a type's name is defined once
in a namespace. Two types of one name, each private to the files that include its header, link without
a word, and inline functions of one are taken for the other's.

    check_names.py SOURCE_ROOT

Types of unnamed namespaces are private to their file; a header has none.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

from check import ALLOWED, check

# As clang-format leaves them: what a namespace holds begins a line, and its end names it.
OPENS = re.compile(r"namespace ([\w:]+ )?\{$")
CLOSES = re.compile(r"\}  // namespace\b")
DEFINES = re.compile(r"(?:struct|class|enum class|enum|union) (\w+)(?: final)?(?: : [^;]*)?(?: \{|$)"
                     r"|using (\w+) =")


def defined_types(path):
    """Yields line number and qualified name of each type that the file defines in a named namespace."""
    namespaces = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if opened := OPENS.match(line):
            namespaces.append((opened[1] or "").strip())
        elif CLOSES.match(line):
            namespaces.pop()
        elif (defined := DEFINES.match(line)) and all(namespaces):
            yield number, "::".join([*namespaces, defined[1] or defined[2]])


def program_of(path):
    """Tests of different folders are different programs, as are those in a folder of their own."""
    return path.parts[:2] if path.parts[0] == "tests" else ()


def violations(root):
    """Yields a line of text for each name that is defined again."""
    places = defaultdict(list)
    for folder in ALLOWED:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".cpp", ".h"):
                name = path.relative_to(root)
                for number, type_name in defined_types(path):
                    places[program_of(name), type_name].append(f"{name}:{number}")
    for (_, type_name), found in sorted(places.items()):
        if len(found) > 1:
            yield f"{found[1]}: {type_name} is defined at {found[0]} already; choose another name"


if __name__ == "__main__":
    sys.exit(check(violations, sys.argv[1:], __doc__))
