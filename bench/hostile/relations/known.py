"""Expected disagreements, from known-failures.toml. The file only becomes shorter: a line whose check agrees,
or does not apply to its case, is an error."""

import sys
import tomllib

import checks


class Known:
    """Contents of the file.

    lines: RELATION | COMMAND | PART | CASE, as the command prints them; these cases are always checked.
    families: the same with a family instead of a case: other cases of this family may differ in this part.
    Each entry needs a line that is one of its examples.
    """

    def __init__(self, path):
        groups = tomllib.loads(path.read_text(encoding="utf-8")).get("failure", []) if path else []
        self.lines = self._listed(path, groups, "lines")
        self.families = self._listed(path, groups, "families")

    @staticmethod
    def _listed(path, groups, key):
        found = {tuple(line.split(" | ")) for group in groups for line in group.get(key, ())}
        for line in found:
            if len(line) != 4:
                sys.exit(f"{path}: '{' | '.join(line)}' in {key}; expected 4 parts, separated by ' | '")
        return found

    def cases(self):
        """{case: pairs of a relation and a command}"""
        result = {}
        for relation, command, _, case in sorted(self.lines):
            result.setdefault(case, []).append((relation, command))
        return result

    def expects(self, finding):
        return finding.key in self.lines or (*finding.key[:3], finding.family) in self.families

    def obsolete(self, outcomes):
        """Lines whose check agrees or does not apply, and families without another line. An open check shows
        neither that its line is needed nor that it is not."""
        old = {line for line in self.lines if outcomes[line[0], line[1], line[3]] in ("agree", "unfit")}
        families = {(*line[:3], checks.family_of(line[3])) for line in self.lines - old}
        return sorted(old | (self.families - families))
