"""Parts of a Markdown page for tools/docs: blocks of commands and of output, links, tables. Text
only; nothing is run here."""
import dataclasses
import re

FENCE = re.compile(r"^(`{3,})(\S*)\s*$")
# Remarks: comments for this program above a block, invisible to readers.
KINDS = "not run|run instead|run before|printed by|exit code|needs"
REMARK = re.compile(rf"<!-- ({KINDS})(?:, [^:]*)?:\s(.*?)\s-->", re.DOTALL)
PROGRAM = re.compile(r"(kusabi|mpirun|python3|cmake|glpsol|gmsh|(\./)?(build|run|tools|bench)/\S+|CC=\S+)( |$)")
LINK = re.compile(r"!?\[(?:[^\]\[]|\[[^\]]*\])*\]\(([^()\s]+)\)")
# Options, named by themselves, of mpirun, CMake and scripts.
OTHERS = {"--allow-run-as-root", "--use-hwthread-cpus", "--oversubscribe", "--mca", "--preset", "--check"}
# Pictures that only the site shows, since tools/site draws them.
ON_THE_SITE = re.compile(r"<!-- on the site: (!\[[^\]]*\]\([^()\s]+\)) -->")
PICTURE = re.compile(r"!\[[^\]]*\]\(([^()\s]+)\)")


@dataclasses.dataclass
class Block:
    """A block of code of a page: the lines between `first` and `last`; `inset` is the indentation
    of each line. `remarks` are pairs of kind and text."""

    first: int
    last: int
    inset: str
    language: str
    lines: list
    remarks: list

    @property
    def text(self):
        return "\n".join(self.lines) + "\n"

    def remark(self, what):
        return next((text for name, text in self.remarks if name == what), None)

    @property
    def commands(self):
        """The command lines: all lines of a block that begins with a program, up to the first empty
        line of an indented one that no program follows."""
        if self.remark("printed by") or not (self.language in ("sh", "console") or
                                             (not self.language and PROGRAM.match(self.lines[0]))):
            return []
        ends = (k for k, line in enumerate(self.lines) if self.inset and not line and not PROGRAM.match(self.lines[k + 1]))
        return self.lines[:next(ends, len(self.lines))]

    @property
    def shown(self):
        """Index of the first line of output in an indented block."""
        return len(self.commands) + 1 if len(self.commands) < len(self.lines) else None


def remarks_above(lines, first):
    """The remarks directly above a block."""
    end = first
    while end > 0 and not lines[end - 1].strip():
        end -= 1
    begin = end
    while begin > 0 and lines[begin - 1].strip() and not lines[begin - 1].startswith(("    ", "```", "|", "#")):
        begin -= 1
    # Comments directly above the block.
    above = re.search(r"(?:<!--(?:(?!-->).)*-->\s*)+$", "\n".join(lines[begin:end]), re.DOTALL)
    return [(what, text.strip()) for what, text in REMARK.findall(above[0])] if above else []


def remark_faults(path, text):
    """Comments that begin like a remark and are none."""
    for comment in re.finditer(rf"<!--\s*(?:{KINDS})\b.*?-->", text, re.DOTALL):
        if not REMARK.fullmatch(comment[0]):
            line = text.count("\n", 0, comment.start()) + 1
            yield f"{path}:{line}: comment is not read; expected <!-- printed by: COMMANDS -->, or another kind of tools/docs"


def blocks(text):
    """All blocks of code of a page."""
    lines, found, at = text.splitlines(), [], 0
    while at < len(lines):
        fence = FENCE.match(lines[at])
        if fence:
            end = next(k for k in range(at + 1, len(lines)) if lines[k].startswith(fence[1]))
            found.append(Block(at + 1, end, "", fence[2] or "", lines[at + 1:end], remarks_above(lines, at)))
            at = end + 1
        elif lines[at].startswith("    ") and (at == 0 or not lines[at - 1].strip() or lines[at - 1].endswith("-->")):
            end = at
            while end < len(lines) and (not lines[end].strip() or lines[end].startswith("    ")):
                end += 1
            after = end
            while not lines[end - 1].strip():
                end -= 1
            found.append(Block(at, end, "    ", "", [line[4:] for line in lines[at:end]], remarks_above(lines, at)))
            at = after
        else:
            at += 1
    return found


def prose(text):
    """The lines of the page, with blocks of code left blank."""
    lines = text.splitlines()
    for block in blocks(text):
        lines[block.first:block.last] = [""] * (block.last - block.first)
    return lines


def without_code(text):
    """The page without code, with its lines at their numbers."""
    text = re.sub(r"(`+)[^`\n]+\1", lambda span: " " * len(span[0]), "\n".join(prose(text)))
    return ON_THE_SITE.sub(lambda span: re.sub(".", " ", span[0]), text)


def anchors(text):
    """Targets of links within a page: its headings as GitHub names them, and names of <a id>."""
    names = set(re.findall(r'<a id="([^"]+)"', text))
    for line in prose(text):
        heading = re.match(r"#{1,6} +(.*?)\s*$", line)
        if not heading:
            continue
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).lower()
        name = re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")
        number = 0
        while (unique := f"{name}-{number}" if number else name) in names:
            number += 1
        names.add(unique)
    return names


def link_faults(path, text):
    """Links of the page at `path` without a target. Web links are not checked."""
    for number, line in enumerate(without_code(text).splitlines(), 1):
        for target in LINK.findall(line):
            if re.match(r"[a-z]+:", target):
                continue
            name, _, anchor = target.partition("#")
            other = path.parent / name if name else path
            if not other.exists():
                yield f"{path}:{number}: link to '{target}': there is no such file"
            elif anchor and anchor not in anchors(text if other == path else other.read_text()):
                yield f"{path}:{number}: link to '{target}': there is no such heading"


def option_faults(path, text, known):
    """Options in the prose that the command does not have; calls of other programs are skipped."""
    for number, line in enumerate(prose(text), 1):
        for code in re.findall(r"`([^`]+)`", line):
            call = re.match(r"(?:.* )?kusabi (.*)|(--.*)", code)
            for option in re.findall(r"(?<![\w-])--[a-z][\w-]*", "".join(call.groups("")) if call else ""):
                if option not in known | OTHERS:
                    yield f"{path}:{number}: '{code}': kusabi has no option {option}"


def cells(line):
    return len(re.split(r"(?<!\\)\|", line.strip().strip("|")))


def table_faults(path, text):
    """Tables with rows of another width than their head, or without rows."""
    lines, head = prose(text), None
    for number, line in enumerate(lines, 1):
        if not re.fullmatch(r"\|.*\|\s*", line):
            head = None
        elif head is None:
            head = cells(line)
            rule = lines[number] if number < len(lines) else ""
            if not re.fullmatch(r"\|(\s*:?-+:?\s*\|)+\s*", rule):
                yield f"{path}:{number}: a row without a table: no rule is below it, and no row above"
        elif cells(line) != head:
            yield f"{path}:{number}: {cells(line)} cells; expected {head}, as in the head of the table"
