"""Relations between answers: commands against each other, neighbouring arguments, and certificates.

Each relation asks several questions about one structure. Near a critical value, arguments are NEAR below and
above. """

import copy
import dataclasses
import math
from collections.abc import Callable

import agreement
import questions
import table as tables
from agreement import Disagreement, Undecided
from questions import Question
from table import Unfit, scaled

#: Relative distance from a critical value or from an end.
NEAR = 1e-6
#: Relative distance from a sum of normal reactions, which may be computed to 1e-6 only.
SUM = 1e-5
#: Longest time of a certificate's verification in seconds.
SECONDS = 60


@dataclasses.dataclass(frozen=True)
class Between:
    """name; commands that it compares; check(asker, rng, case, mu), which raises as agreement.compare and
    Unfit"""

    name: str
    command: str
    check: Callable


class Asked:
    """Questions about one structure, each asked once."""

    def __init__(self, asker, case):
        self.asker, self.case, self.known = asker, case, {}
        self.last_table, self.last_question = case.table, None

    def __call__(self, question, table=None, *more):
        """The answer. @raises Undecided if it is refused or has no result"""
        self.last_table, self.last_question = table or self.case.table, question
        if table is None and not more and question in self.known:
            return self.known[question]
        path = self.asker.write(self.last_table, "between")
        answer = self.asker.ask(path, question, *more)
        if table is None and not more:
            self.known[question] = answer
        agreement.crash(answer.code, answer.said)
        if answer.code in agreement.REFUSED:
            if table is None and self.case.is_generated:
                raise Disagreement("refused", answer.said)
            raise Undecided(f"refused: {answer.said}")
        if answer.result is None:
            raise Undecided("no answer in time")
        return answer


def complete(answer):
    if answer.is_open:
        raise Undecided("open answer")
    return answer


def _count(asked, mu):
    return int(complete(asked(Question("patterns", mu=mu))).result["count"])


def _coefficient(asked):
    """Bracket of the critical coefficient; upper bound None: nothing sticks up to the lower one."""
    return questions.coefficient(complete(asked(Question("critical"))).result)


def patterns_at_critical(asked, rng, case, mu):
    """No pattern below the lower bound of `critical`, and at least one above the upper one."""
    found = _coefficient(asked)
    if found.low:
        count = _count(asked, found.low * (1 - NEAR))
        if count:
            raise Disagreement(
                "count",
                f"{count} patterns at {found.low * (1 - NEAR)!r}, critical: {found.low!r} .. {found.high!r}")
    if found.high is not None and _count(asked, found.high * (1 + NEAR)) == 0:
        raise Disagreement(
            "count",
            f"no pattern at {found.high * (1 + NEAR)!r}, but critical: {found.low!r} .. {found.high!r}")


def steps_at_critical(asked, rng, case, mu):
    """The first step of `sweep` is the bracket of `critical`, and so is the least coefficient of its
    patterns."""
    found = _coefficient(asked)
    if found.high is None:
        raise Unfit("nothing sticks")
    most = 1.5 * found.high
    answer = complete(asked(Question("sweep", more=("--mu-max", repr(most)))))
    first = min((pattern["lower"] for pattern in answer.result["patterns"]), default=None)
    upper = min((pattern["upper"] for pattern in answer.result["patterns"]), default=None)
    if first is None:
        raise Disagreement("steps",
                           f"no pattern up to {most!r}, but critical: {found.low!r} .. {found.high!r}")
    agreement.overlap("steps", questions.Bracket(first, upper), found, 2e-8)


def sorted_by_critical(asked, rng, case, mu):
    """The least coefficient of `patterns --sort critical` is that of `critical`, if it is one of these
    patterns."""
    found = _coefficient(asked)
    if found.high is None:
        raise Unfit("nothing sticks")
    answer = complete(asked(Question("patterns", mu=1.2 * found.high, more=("--sort", "critical"))))
    for pattern in answer.result["patterns"]:
        own = pattern.get("critical_friction")
        if own and own["upper"] is not None and own["upper"] < found.low * (1 - NEAR) - 2e-8:
            raise Disagreement(
                "coefficient",
                f"{pattern['contact']} sticks from {own['upper']!r}; critical {found.low!r} .. {found.high!r}"
            )
    steps = complete(asked(Question("sweep", more=("--mu-max", repr(1.2 * found.high)))))
    at = {(frozenset(each["contact"]), frozenset(each["separated"])): each
          for each in steps.result["patterns"] if each["absorbed"] is None}
    for pattern in answer.result["patterns"]:
        own, other = pattern.get("critical_friction"), at.get(
            (frozenset(pattern["contact"]), frozenset(pattern["separated"])))
        if own and other and own["upper"] is not None and (
                own["lower"] > other["upper"] + 1e-6 * other["upper"] or
                other["lower"] > own["upper"] + 1e-6 * own["upper"]):
            raise Disagreement(
                "coefficient", f"{pattern['contact']} sticks from {own['lower']!r} .. {own['upper']!r}, "
                f"but by sweep from {other['lower']!r} .. {other['upper']!r}")


def points_of_sweep(asked, rng, case, mu):
    """Counts of `sweep --mu` are those of `patterns`."""
    points = sorted({0.6 * mu, mu, 1.7 * mu})
    answer = asked(Question("sweep", more=("--mu", ",".join(map(repr, points)))))
    for point in answer.result["points"]:
        if point["count"] is not None and int(point["count"]) != _count(asked, point["mu"]):
            raise Disagreement(
                "count",
                f"{point['count']} patterns at {point['mu']!r}, {_count(asked, point['mu'])} by patterns")
    complete(answer)


def rays_of_patterns(asked, rng, case, mu):
    """Maximal cones of `rays` are the patterns of `patterns`."""
    if not tables.is_plane(case.table):
        raise Unfit("in space")
    patterns, rays = (complete(asked(Question(command, mu=mu))) for command in ("patterns", "rays"))
    numbers = range(len(patterns.names))
    mine, theirs = questions.cones(patterns, numbers).keys(), questions.ray_cones(rays, numbers)
    if mine != theirs:
        raise Disagreement(
            "cones", f"{len(mine)} patterns, {len(theirs)} cones of rays at {mu!r}; "
            f"only on one side {sorted(map(agreement.cone_name, mine ^ theirs))[0]}")


def one_exists(asked, rng, case, mu):
    """`patterns --exists` finds a pattern if and only if `patterns` does."""
    one = complete(asked(Question("patterns", mu=mu, more=("--exists", ))))
    if (int(one.result["count"]) > 0) != (_count(asked, mu) > 0):
        raise Disagreement("count",
                           f"{one.result['count']} with --exists, {_count(asked, mu)} patterns at {mu!r}")


def methods_of_patterns(asked, rng, case, mu):
    """Cuts, branching, polyhedral cones and the exact test do not change the list."""
    more = rng.choice(
        (("--cuts", "always"), ("--prove", ), ("--branching", "deepest"), ("--method", "polyhedral")))
    if more[-1] == "polyhedral" and tables.is_plane(case.table):
        raise Unfit("cones in the plane are polyhedral")
    one, other = complete(asked(Question("patterns",
                                         mu=mu))), complete(asked(Question("patterns", mu=mu, more=more)))
    mine, theirs = ({key: value[0]
                     for key, value in questions.cones(each, range(len(each.names))).items()}
                    for each in (one, other))
    if mine != theirs:
        raise Disagreement("cones", f"{len(mine)} patterns, {len(theirs)} with {' '.join(more)} at {mu!r}")


# Loads that are held
# -------------------------------------------------------------------------------------------


def _without_reference(table):
    table = copy.deepcopy(table)
    table["loads"] = [entry for entry in table["loads"] if entry["kind"] != "reference"]
    return table


def _at_factor(table, factor):
    """The dead load with the reference load times a factor, and without reference load."""
    table = copy.deepcopy(table)
    table["loads"] = [{**entry, "kind": "dead", "force": scaled(entry["force"], factor)}
                      if entry["kind"] == "reference" else entry for entry in table["loads"]]
    return table


def _is_held(asked, table, mu):
    """True, False, or None if it is open. A dead load of zero is held."""
    table = {**table, "loads": [entry for entry in table["loads"] if any(entry["force"])]}
    if not table["loads"] and "gravity" not in table:
        return True
    answer = asked(Question("hold", mu=mu), table)
    return None if answer.is_open else bool(questions.held(answer))


def _needs_reference(case):
    if not any(entry["kind"] == "reference" for entry in tables.entries(case.table, "loads")):
        raise Unfit("no reference load")


def _inside(intervals, factor, room):
    """True: well inside an interval; False: well outside all; None: near an end."""
    if any(low + room < factor < high - room for low, high in intervals):
        return True
    return None if any(low - room <= factor <= high + room for low, high in intervals) else False


def ends_of_factors(asked, rng, case, mu):
    """A factor just inside an interval of `hold` is held as a dead load, one just outside is not."""
    _needs_reference(case)
    answer = complete(asked(Question("hold", mu=mu)))
    intervals = questions.held(answer)
    ends = [end for interval in intervals for end in interval if math.isfinite(end)]
    points = {end + sign * NEAR * max(1.0, abs(end))
              for end in ends for sign in (-1, 1)} | {0.0, rng.uniform(-2, 2)}
    compared = 0
    for factor in rng.sample(sorted(points), min(4, len(points))):
        expected = _inside(intervals, factor, 0.1 * NEAR * max(1.0, abs(factor)))
        if expected is None:
            continue
        got = _is_held(asked, _at_factor(case.table, factor), mu)
        compared += got is not None
        if got is not None and got != expected:
            raise Disagreement(
                "held",
                f"factors {intervals} at {mu!r}, but {factor!r} as dead load is {'' if got else 'not '}held")
    if not compared:
        raise Undecided("no factor away from ends")


def zero_and_dead_load(asked, rng, case, mu):
    """The factor 0 is held at a coefficient if and only if `hold` without a coefficient says so."""
    _needs_reference(case)
    found = questions.bracket(complete(asked(Question("hold"))).result["holding_friction"])
    compared = 0
    for at in [mu] + [
            x for x in (found.low and found.low * (1 - NEAR), found.high and found.high * (1 + NEAR)) if x
    ]:
        expected = True if found.high is not None and at > found.high else False if at < found.low else None
        if expected is None or at > 1000:
            continue
        answer = asked(Question("hold", mu=at))
        if answer.is_open:
            continue
        held = _inside(questions.held(answer), 0.0, 1e-7)
        compared += held is not None
        if held is not None and held != expected:
            raise Disagreement(
                "held",
                f"held from {found.low!r} .. {found.high!r} on, but at {at!r} {questions.held(answer)}")
    if not compared:
        raise Undecided("the factor zero is at an end")


def more_friction(asked, rng, case, mu):
    """What is held at one coefficient is held at a larger one."""
    _needs_reference(case)
    one, other = (complete(asked(Question("hold", mu=at))) for at in (mu, 1.5 * mu))
    small, large = questions.held(one), questions.held(other)
    for low, high in agreement.without_points(small):
        if not any(a - 1e-6 * max(1, abs(a)) <= low and high <= b + 1e-6 * max(1, abs(b)) for a, b in large):
            raise Disagreement("intervals", f"[{low!r}, {high!r}] at {mu!r}, but at {1.5 * mu!r} {large}")


def sums_of_reactions(asked, rng, case, mu):
    """Sums of normal reactions beyond the ends of `--grip` are not held."""
    answer = complete(asked(Question("hold", mu=mu, more=("--grip", ))))
    grip = answer.result.get("grip")
    least, most = questions.sums(grip) if grip else (None, None)
    if not grip or not grip["held"] or least is None:
        raise Unfit("no state under the dead load")
    compared = 0
    beyond = [least - SUM * max(1.0, least)] + ([] if most is None else [most + SUM * max(1.0, most)])
    for total in beyond:
        if total <= 0:
            continue
        got = asked(Question("hold", mu=mu, total=total))
        if got.is_open:
            continue
        compared += 1
        if _inside(questions.held(got), 0.0, 0.0) is True:
            raise Disagreement("grip",
                               f"sums {least!r} to {most!r} at {mu!r}, but 0 is held with the sum {total!r}")
    if not compared:
        raise Undecided("no sum beyond the ends")


# Limit loads
# ---------------------------------------------------------------------------------------------------


def _uncertain(case):
    for question in case.questions:
        if question.command == "limit" and (question.alpha is not None or
                                            question.group_alpha) and question.lose is None:
            return question
    raise Unfit("no half-widths")


def no_half_width(asked, rng, case, mu):
    """With half-widths of zero, the guaranteed interval is that of the nominal load."""
    question = _uncertain(case)
    if question.alpha is None or question.group_alpha or any("case" in entry
                                                             for entry in case.table["loads"]):
        raise Unfit("half-widths of the file, or load cases")
    nominal = complete(asked(Question("limit"))).result["nominal_interval"]
    found = questions.guaranteed(complete(asked(dataclasses.replace(question, alpha=0.0))).result)
    ends = nominal if isinstance(nominal, list) else [nominal["lower"], nominal["upper"]]
    for end, value in zip(("lower", "upper"), ends):
        if value is not None and found["empty"] is False and not (
                found[end]["lower"]["value"] - 1e-7 * max(1, abs(value)) <= value <=
                found[end]["upper"]["value"] + 1e-7 * max(1, abs(value))):
            raise Disagreement(
                "interval", f"{end} end {found[end]['lower']!r} .. {found[end]['upper']!r}, nominal {ends}")


def wider_loads(asked, rng, case, mu):
    """Larger half-widths carry no more factors."""
    question = _uncertain(case)
    if question.alpha is None:
        raise Unfit("half-widths by name")
    one, other = (questions.guaranteed(complete(asked(each)).result)
                  for each in (question, dataclasses.replace(question, alpha=1.25 * question.alpha)))
    if one["empty"] and other["empty"] is False:
        raise Disagreement("interval", f"empty at {question.alpha!r}, not at {1.25 * question.alpha!r}")
    if one["empty"] is False and other["empty"] is False:
        for end, sign in (("lower", -1), ("upper", 1)):
            a, b = one[end], other[end]
            least, most = (b, a) if sign == 1 else (a, b)
            least, most = least["lower"]["value"], most["upper"]["value"]
            if least > most + 1e-7 * max(1, abs(most)):
                raise Disagreement("interval",
                                   f"{end}: {a} at {question.alpha!r}, {b} at {1.25 * question.alpha!r}")


def sweep_of_half_widths(asked, rng, case, mu):
    """The points of `sweep --alpha` are the worst cases of `limit --alpha`."""
    question = _uncertain(case)
    if question.alpha is None or question.group_alpha or any("case" in entry
                                                             for entry in case.table["loads"]):
        raise Unfit("half-widths by name, or load cases")
    one = complete(asked(question)).result
    other = complete(asked(Question("sweep", more=("--alpha", repr(question.alpha))))).result["points"][0]
    ours, theirs = one["maximum"], other["maximum"]
    if ours["lower"] is None or theirs["lower"] is None:
        if theirs["lower"] != ours["lower"]:
            raise Disagreement("worst case", f"{ours} by limit, {theirs} by sweep")
        return
    agreement.overlap("worst case", questions.bracket(ours), questions.bracket(theirs), 1e-7)


def without_each_member(asked, rng, case, mu):
    """The least factor after a loss is the least of the trusses without one member."""
    bars = [(k, each) for k, entry in enumerate(case.table["members"]) for each in entry["between"]]
    if any("case" in entry for entry in case.table["loads"]) or len(bars) > 16:
        raise Unfit("load cases, or many members")
    loss = complete(asked(Question("limit", lose=1))).result
    if loss["kind"] != "member-loss":
        raise Unfit("not carried")
    remaining = f"{loss['factor']['lower']!r} .. {loss['factor']['upper']!r}"
    whole = complete(asked(Question("limit"))).result["nominal"]
    least = whole
    for k, each in bars:
        table = copy.deepcopy(case.table)
        table["members"][k]["between"].remove(each)
        table["members"] = [entry for entry in table["members"] if entry["between"]]
        try:
            answer = asked(Question("limit"), table)
        except Undecided as why:
            if "mechanism" in str(why) or "no member" in str(why):
                return  # with no strength at all a node has no equilibrium: `limit` refuses such a file
            raise
        nominal = answer.result["nominal"]
        if nominal is None:
            if complete(answer) and loss["fatal"] is None:
                raise Disagreement("member loss", f"not carried without {each}, but {remaining} remains")
            return
        least = min(least, nominal)
    bracket, room = questions.bracket(loss["factor"]), 1e-6 * max(1, abs(least))
    if loss["fatal"] or not bracket.low - room <= least <= bracket.high + room:
        raise Disagreement("member loss", f"{remaining}, fatal {loss['fatal']}; one by one {least!r}")


# Pieces
# --------------------------------------------------------------------------------------------------------


def _pieces(table):
    """Tables of the parts that no member, element, pair or tie connects; supported nodes connect nothing."""
    ground = {node for node, axes in tables.supported_axes(table).items() if len(axes) == table["dimension"]}
    part = {node: node for node in table["nodes"]}

    def root(node):
        while part[node] != node:
            node = part[node]
        return node

    joined = [each for entry in tables.entries(table, "members", "elements") for each in entry["between"]]
    for entry in tables.entries(table, "contact", "ties"):
        for k, place in enumerate(entry.get("against", entry.get("to", ()))):
            joined.append([*entry["nodes"], *(place["nodes"] if isinstance(place, dict) else [place])])
    for each in joined:
        free = [node for node in each if node not in ground]
        for node in free[1:]:
            part[root(node)] = root(free[0])
    kept = lambda entry, key, test: {**entry, key: [each for each in entry[key] if test(each)]}
    for head in sorted({root(node) for node in table["nodes"] if node not in ground}):
        of_piece = lambda node: node not in ground and root(node) == head
        piece = copy.deepcopy(table)
        for section in ("members", "elements"):
            piece[section] = [
                kept(entry, "between", lambda each: any(map(of_piece, each)))
                for entry in table.get(section, ())
            ]
        used = {
            node
            for entry in tables.entries(piece, "members", "elements") for each in entry["between"]
            for node in each
        }
        used |= {node for node in table["nodes"] if of_piece(node)}
        piece["nodes"] = {node: place for node, place in table["nodes"].items() if node in used}
        for section in ("supports", "springs", "loads", "contact", "ties"):
            # The places of pairs and ties are in the order of their nodes.
            own = [entry for entry in table.get(section, ()) if any(map(of_piece, entry["nodes"]))]
            if section in ("supports", "springs", "loads"):
                own = [kept(entry, "nodes", used.__contains__) for entry in table.get(section, ())]
            elif all("against" not in entry and "to" not in entry for entry in own):
                own = [kept(entry, "nodes", of_piece) for entry in own]
            elif not all(of_piece(node) for entry in own for node in entry["nodes"]):
                raise Unfit("a group of several pieces")
            piece[section] = own
        for section in ("members", "elements", "supports", "springs", "loads", "contact", "ties"):
            key = "between" if section in ("members", "elements") else "nodes"
            piece[section] = [entry for entry in piece[section] if entry[key]]
            if not piece[section]:
                del piece[section]
        yield piece


def _several_pieces(case):
    if any(key in case.table for key in ("uncertainty", "actions", "stiffness")):
        raise Unfit("uncertain loads")
    pieces = list(_pieces(case.table))
    if len(pieces) < 2:
        raise Unfit("one piece")
    return pieces


def coefficients_of_pieces(asked, rng, case, mu):
    """The critical coefficient is the least of those of the pieces alone."""
    whole = _coefficient(asked)
    alone = [
        questions.coefficient(complete(asked(Question("critical"), piece)).result)
        for piece in _several_pieces(case) if piece.get("contact")
    ]
    highs = [each.high for each in alone if each.high is not None]
    least = questions.Bracket(min(each.low for each in alone), min(highs, default=None))
    agreement.overlap("bracket", whole, least, 2e-8)


def holding_of_pieces(asked, rng, case, mu):
    """A dead load is held if and only if every piece alone holds its own."""
    pieces = _several_pieces(case)
    whole = _is_held(asked, _at_factor(case.table, 0.0), mu)
    alone = []
    for piece in pieces:
        loads = [entry for entry in piece.get("loads", ()) if entry["kind"] == "dead" and any(entry["force"])]
        if not loads or not piece.get("contact"):
            continue
        alone.append(_is_held(asked, {**piece, "loads": loads}, mu))
    if whole is None or None in alone or not alone:
        raise Undecided("open")
    if whole != all(alone):
        raise Disagreement("held",
                           f"the whole is {'' if whole else 'not '}held at {mu!r}, its pieces: {alone}")


# Certificates
# --------------------------------------------------------------------------------------------------


def _certified(command):

    def check(asked, rng, case, mu):
        """With --certificate the exit code is that without it, and `verify` proves what the command says is
        proved."""
        fitting = [question for question in case.questions if question.command == command]
        if not fitting:
            raise Unfit("another command")
        question = rng.choice(fitting)
        asker = asked.asker
        for old in asker.folder.glob("cert*"):
            old.unlink()
        plain = asked(question)
        answer = asked(question, None, "--certificate", "cert")
        if plain.code != answer.code and None not in (plain.code, answer.code):
            raise Disagreement("exit code",
                               f"exit code {plain.code}, with --certificate {answer.code}: {answer.said}")
        if answer.code != 0:
            raise Undecided("open answer")
        written = sorted(path.name for path in asker.folder.glob("cert*") if path.suffix != ".tmp")
        if not written:
            if questions.is_proved(answer) and "ertificate" not in answer.text:
                raise Disagreement("certificate", f"none was written, and no word about it: {answer.said}")
            raise Undecided("no certificate")
        for name in written:
            # Loads are in the problem file only.
            with_problem = ("--problem", "between.toml")
            for more in (with_problem, ) if command == "hold" else ((), with_problem):
                code, text = asker.run("verify", name, "--serial", *more, seconds=SECONDS)
                agreement.crash(code, text)
                if code is None:
                    raise Undecided("no proof in time")
                if code != 0 and questions.is_proved(answer):
                    last = [line for line in text.strip().splitlines() if line][-1]
                    raise Disagreement("verify", f"exit code {code} of {name} {' '.join(more[:1])}: {last}")

    return check


RELATIONS = [
    Between("patterns beside critical", "critical", patterns_at_critical),
    Between("first step of sweep", "sweep", steps_at_critical),
    Between("patterns sorted by coefficient", "patterns", sorted_by_critical),
    Between("points of sweep", "sweep", points_of_sweep),
    Between("cones of rays", "rays", rays_of_patterns),
    Between("one pattern exists", "patterns", one_exists),
    Between("methods of patterns", "patterns", methods_of_patterns),
    Between("ends of factors", "hold", ends_of_factors),
    Between("factor zero", "hold", zero_and_dead_load),
    Between("more friction", "hold", more_friction),
    Between("sums of reactions", "hold", sums_of_reactions),
    Between("coefficients of pieces", "critical", coefficients_of_pieces),
    Between("pieces alone", "hold", holding_of_pieces),
    Between("half-width zero", "limit", no_half_width),
    Between("wider half-widths", "limit", wider_loads),
    Between("sweep of half-widths", "limit", sweep_of_half_widths),
    Between("one member less", "limit", without_each_member),
    *(Between("certificate", command, _certified(command))
      for command in ("patterns", "critical", "hold", "limit")),
]
