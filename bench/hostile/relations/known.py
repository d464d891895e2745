"""Expected disagreements, from known-failures.toml. The file only becomes shorter: a disagreement that is no
longer there is an error."""

import sys
import tomllib

import checks


class Known:
    """Contents of the file.

    lines: RELATION | COMMAND | PART | CASE, as the command prints them; these cases are always checked.
    families: the same with a family instead of a case: other cases of this family may differ in this part.
    wrong: SUBCOMMAND | CASE: the answer about the file itself is wrong, and any relation may show it.
    Each entry of families and wrong needs a line that is one of its examples.
    """

    def __init__(self, path):
        groups = tomllib.loads(path.read_text()).get("failure", []) if path else []
        self.lines = self._listed(path, groups, "lines", 4)
        self.families = self._listed(path, groups, "families", 4)
        self.wrong = self._listed(path, groups, "wrong", 2)

    @staticmethod
    def _listed(path, groups, key, parts):
        found = {tuple(line.split(" | ")) for group in groups for line in group.get(key, ())}
        for line in found:
            if len(line) != parts:
                sys.exit(f"{path}: '{' | '.join(line)}' in {key}; expected {parts} parts, separated by ' | '")
        return found

    def cases(self):
        """{case: pairs of a relation and a command}"""
        result = {}
        for relation, command, _, case in sorted(self.lines):
            result.setdefault(case, []).append((relation, command))
        return result

    def expects(self, finding):
        return (finding.key in self.lines or (*finding.key[:3], finding.family) in self.families or
                (finding.command.split()[0], finding.case) in self.wrong)

    def obsolete(self, findings):
        """Entries without a disagreement in the cases of the lines."""
        shown = self.lines & {finding.key for finding in findings}
        families = {(*line[:3], checks.family_of(line[3])) for line in shown}
        wrong = {(line[1].split()[0], line[3]) for line in shown}
        return sorted((self.lines - shown) | (self.families - families) | (self.wrong - wrong))
