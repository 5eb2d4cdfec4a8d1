"""Checks the One Definition Rule where neither compiler nor linker does: a type name is defined once per
namespace. Two types of the same name, each used only by files that include its header, link silently, and
inline functions of one replace those of the other.

    check_names.py SOURCE_ROOT

Types in unnamed namespaces are private to their file; headers have none.
"""

import re
import sys
from collections import defaultdict
from pathlib import Path

from check import ALLOWED, check

# As clang-format writes them: a namespace's contents are not indented, and its end names it.
OPENS = re.compile(r"namespace ([\w:]+ )?\{$")
CLOSES = re.compile(r"\}  // namespace\b")
DEFINES = re.compile(r"(?:struct|class|enum class|enum|union) (\w+)(?: final)?(?: : [^;]*)?(?: \{|$)"
                     r"|using (\w+) =")


def defined_types(path):
    """Yields the line number and qualified name of each type that the file defines in a named namespace."""
    namespaces = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if opened := OPENS.match(line):
            namespaces.append((opened[1] or "").strip())
        elif CLOSES.match(line):
            namespaces.pop()
        elif (defined := DEFINES.match(line)) and all(namespaces):
            yield number, "::".join([*namespaces, defined[1] or defined[2]])


def program_of(path):
    """The program a file belongs to: tests of different folders are different programs."""
    return path.parts[:2] if path.parts[0] == "tests" else ()


def violations(root):
    """Yields a line of text per name that is defined again."""
    places = defaultdict(list)
    for folder in ALLOWED:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in (".cpp", ".h"):
                name = path.relative_to(root)
                for number, type_name in defined_types(path):
                    places[program_of(name), type_name].append(f"{name}:{number}")
    for (_, type_name), found in sorted(places.items()):
        if len(found) > 1:
            yield f"{found[1]}: {type_name} is already defined at {found[0]}; choose another name"


if __name__ == "__main__":
    sys.exit(check(violations, sys.argv[1:], __doc__))
