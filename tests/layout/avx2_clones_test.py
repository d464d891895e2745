"""Functions marked KUSABI_ALSO_FOR_AVX2 are compiled twice.

GCC ignores the mark silently where it does not apply it, for instance on a member of a class template
whose declaration lacks it. The program is then right and half as fast, and no other test fails; likewise
if a mark is lost. So each marked function must have its clones, and the number of marks is fixed.

    avx2_clones_test.py PROGRAM SOURCE_DIR
"""

import re
import subprocess
import sys
from pathlib import Path

#: Marks in the sources. A commit that adds or removes one changes this number.
MARKS = 23

MARK = re.compile(
    r"^\s*KUSABI_ALSO_FOR_AVX2\s+[\w:<>,&*\s]*?(?:(?P<type>\w+)(?:<[\w, ]+>)?::)?(?P<name>\w+)\(",
    re.MULTILINE,
)
TYPE = re.compile(r"^(?:class|struct) (\w+)[^;]*?\{", re.MULTILINE)
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.MULTILINE)
TEMPLATE = r"(?:<[^()]*>)?"
CLONE = re.compile(r" \[clone \.avx2[^\]]*\]$")
OTHER_CLONE = re.compile(r" \[clone [^\]]*\]")


def marked_functions(source_dir):
    """Namespace, type (empty for a free function) and name of each marked function, with its file."""
    for path in sorted(source_dir.glob("*/**/*.[ch]pp")):
        relative = path.relative_to(source_dir)
        if relative.parts[0].startswith("build") or relative.name == "simd.hpp":
            continue
        text = path.read_text(encoding="utf-8")
        marks = list(MARK.finditer(text))
        # A mark that the pattern does not understand must not be passed over.
        assert len(marks) == text.count("KUSABI_ALSO_FOR_AVX2"), f"{relative}: a mark without a function"
        for mark in marks:
            enclosing = [one for one in TYPE.finditer(text) if one.end() < mark.start()]
            in_class = path.suffix == ".hpp" and enclosing
            of_type = mark["type"] or (enclosing[-1][1] if in_class else "")
            yield NAMESPACE.search(text)[1], of_type, mark["name"], relative


def defined_symbols(program):
    listed = subprocess.run(
        ["nm", "-C", "--defined-only", program], capture_output=True, text=True, check=True
    ).stdout
    return {line.split(" ", 2)[2] for line in listed.splitlines() if line.count(" ") >= 2}


def functions_without_clone(symbols, namespace, of_type, name):
    """The compiled instances of a function that have no clone; [None] if there is no instance."""
    scope = namespace + r"::(?:\(anonymous namespace\)::)?" + (of_type + TEMPLATE + "::" if of_type else "")
    instance = re.compile(rf"(?:^|[ *&]){scope}{name}{TEMPLATE}\(")
    instances = {one for one in symbols if instance.search(one)}
    plain = {OTHER_CLONE.sub("", one) for one in instances}
    cloned = {CLONE.sub("", one) for one in instances if CLONE.search(one)}
    return sorted(plain - cloned) if plain else [None]


def main(program, source_dir):
    symbols = defined_symbols(program)
    marks = list(marked_functions(Path(source_dir)))
    faults = [
        f"{path}: {of_type + '::' if of_type else ''}{name}: "
        + ("not in the program" if missing is None else f"no AVX2 clone of {missing}")
        for namespace, of_type, name, path in marks
        for missing in functions_without_clone(symbols, namespace, of_type, name)
    ]
    if len(marks) != MARKS:
        faults.append(f"{len(marks)} marked functions, expected MARKS = {MARKS}")
    print("\n".join(faults) or f"{len(marks)} marked functions, each with a clone of every instance")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
