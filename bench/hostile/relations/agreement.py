"""Comparison of two answers to the same question in other words.

Compared are, with these tolerances:

- exit codes: refused (1, 2) on both sides or on neither, and no crash on either. An open answer (3, or none
  in time) is counted, and only its proved parts are compared;
- cones: the same sets. Where coordinates are rounded anew, a pattern at a limit (flat, or with a margin of up
  to NOISE times this rounding) may exist on one side only, since a displacement of 1e-16 decides it;
- margins: equal to MARGIN, since the pages state three digits;
- brackets: proved bounds overlap, up to the rounding of the coordinates; computed ones are equal to NEAR;
- intervals: the same ends to NEAR, without intervals of one point;
- parts of answers: intervals, points and sums that one side states, the other states as well;
- standing: proved on both sides or on neither, where the change is exact. Sums are then in another order, but
  their terms are the same.

Forces along one line, or through one point, are in equilibrium only if their moment is exactly zero, so
rounded coordinates may change flat states, which have no proof, and cones whose margins are not known. Such
a difference is a RoundedAnew; only structures with random directions show that it is wrong.
"""

import math

import questions

#: Relative difference of computed numbers: programs are solved to 1e-9, and ends of intervals to 1e-7 of
#: their size.
NEAR = 2e-7
#: Relative difference of margins.
MARGIN = 2e-3
#: Displacements are determined by coordinates with a condition number of up to about this.
CONDITION = 1e6
#: Margin of a pattern that is at a limit, relative to the error of coordinates times CONDITION.
NOISE = 1e2
#: Exit codes of a call or an input that is refused.
REFUSED = (1, 2)


class Disagreement(Exception):
    """part: what differs; line: both answers"""

    def __init__(self, part, line):
        super().__init__(line)
        self.part, self.line = part, line


class RoundedAnew(Disagreement):
    """A disagreement that the rounding of coordinates may cause where directions are special."""


class Undecided(Exception):
    """No comparison, for the given reason."""


def near(a, b, room=NEAR):
    """True if two numbers agree, or neither is known. Infinity agrees with itself only."""
    if a is None or b is None:
        return a is b
    return a == b or math.isfinite(a) and math.isfinite(b) and abs(a - b) <= room * max(1.0, abs(a), abs(b))


def room_of(error):
    """Relative error of numbers after a relative error of coordinates."""
    return max(1e-9, CONDITION * error)


def crash(code, said):
    """@raises Disagreement at an exit code that is not documented, such as that of a signal"""
    if code not in (None, 0, *REFUSED, 3):
        raise Disagreement("crash", f"exit code {code}: {said}")


def exit_codes(one, other):
    for each in (one, other):
        crash(each.code, each.said)
    codes = one.code, other.code
    if any(code in REFUSED for code in codes):
        if codes[0] == codes[1]:
            raise Undecided("refused on both sides")
        raise Disagreement("exit code", f"exit code {codes[0]}, then {codes[1]}: {one.said} | {other.said}")
    if one.result is None or other.result is None:
        raise Undecided("no answer in time")


def _kind(effect, flat=True):
    """The disagreement to raise; flat: a flat state is involved, or may be."""
    return RoundedAnew if flat and not effect.exact else Disagreement


def standing(one, other, effect):
    if not effect.exact or one.is_open or other.is_open:
        return
    proved = questions.is_proved(one), questions.is_proved(other)
    if proved[0] != proved[1]:
        raise Disagreement(
            "standing", " but ".join(f"{'proved' if each else 'computed'}: {answer.said}"
                                     for each, answer in zip(proved, (one, other))))


def cone_name(key):
    """The numbers of the candidates in contact and of those separated."""
    sets = [" ".join(map(str, sorted(each))) or "-" for each in key]
    return f"{{{sets[0]} | {sets[1]}}}"


def patterns(one, other, effect):
    if one.is_open or other.is_open:
        raise Undecided("undecided patterns")
    mine, theirs = questions.cones(one, range(len(one.names))), questions.cones(other, effect.original)
    limit = NOISE * room_of(effect.error) if effect.error else 0.0
    at_limit = False
    for key in sorted(mine.keys() ^ theirs.keys(), key=cone_name):
        state, margin = mine.get(key) or theirs[key]
        if effect.exact or state == "feasible" and margin > limit:
            raise Disagreement(
                "cones", f"{len(mine)}, then {len(theirs)} patterns; {cone_name(key)} ({state}, "
                f"margin {margin}) only {'before' if key in mine else 'after'}")
        at_limit = True
    if at_limit or not effect.exact and any(state != "feasible" or margin <= limit
                                            for state, margin in mine.values()):
        raise Undecided("patterns at a limit, coordinates rounded anew")
    for key, (state, margin) in mine.items():
        if theirs[key][0] != state:
            raise Disagreement("cones", f"{cone_name(key)} is {state}, then {theirs[key][0]}")
    count = int(one.result["count"])**effect.copies
    if int(other.result["count"]) != count:
        raise Disagreement("count", f"{one.result['count']}, then {other.result['count']} instead of {count}")
    for key, (state, margin) in mine.items():
        if state == "feasible" and not math.isclose(margin, theirs[key][1], rel_tol=MARGIN, abs_tol=1e-9):
            raise Disagreement("margins", f"{cone_name(key)}: margin {margin!r}, then {theirs[key][1]!r}")


def rays(one, other, effect):
    if one.is_open or other.is_open:
        raise Undecided("undecided rays")
    mine, theirs = questions.ray_cones(one,
                                       range(len(one.names))), questions.ray_cones(other, effect.original)
    if mine != theirs:
        raise _kind(effect)(
            "cones", f"{len(mine)}, then {len(theirs)} cones; "
            f"only on one side {sorted(map(cone_name, mine ^ theirs))[0]}")
    if not effect.copies > 1 and one.result["count"] != other.result["count"]:
        raise _kind(effect)("count", f"{one.result['count']}, then {other.result['count']} rays")


def overlap(part, mine, theirs, room, both_given=True):
    """Proved bounds do not contradict each other; with complete answers no bound is missing on one side
    only."""
    for lower, proved, upper, also, words in ((mine.low, mine.low_proved, theirs.high, theirs.high_proved,
                                               "before"), (theirs.low, theirs.low_proved, mine.high,
                                                           mine.high_proved, "after")):
        if lower is None or upper is None:
            continue
        apart = room if proved and also else max(room, NEAR)
        if (proved and also or both_given) and lower > upper + apart * max(1.0, abs(lower), abs(upper)):
            raise Disagreement(
                part, f"{mine.low!r} .. {mine.high!r}, then {theirs.low!r} .. {theirs.high!r}: "
                f"apart, the lower bound is the one {words}")
    if both_given and ((mine.low is None) != (theirs.low is None) or (mine.high is None) !=
                       (theirs.high is None)):
        raise Disagreement(part, f"{mine.low!r} .. {mine.high!r}, then {theirs.low!r} .. {theirs.high!r}")


def _coefficient(mine, theirs, effect, complete):
    """Brackets of a smallest coefficient."""
    try:
        overlap("bracket", mine.changed(effect.mu), theirs,
                room_of(effect.error) if effect.error else 0.0, complete)
    except Disagreement as found:
        # A flat state has no proved upper bound.
        flat = any(each.high is not None and not each.high_proved for each in (mine, theirs))
        raise _kind(effect, flat)(found.part, found.line) from None
    if not complete:
        raise Undecided("open bracket")


def critical(one, other, effect):
    mine, theirs = (questions.coefficient(each.result) for each in (one, other))
    _coefficient(mine, theirs, effect, not (one.is_open or other.is_open))


def sweep(one, other, effect):
    mine, theirs = one.result["points"], other.result["points"]
    same = len(mine) == len(theirs) and all(
        near(a["mu"] * effect.mu, b["mu"], 1e-12) for a, b in zip(mine, theirs))
    if not same:
        if one.is_open or other.is_open:
            raise Undecided("open points")
        raise Disagreement("points", f"{[each['mu'] for each in mine]} times {effect.mu}, "
                           f"then {[each['mu'] for each in theirs]}")
    for before, after in zip(mine, theirs):
        if None in (before["count"], after["count"]):
            raise Undecided("open counts")
        if int(after["count"]) != int(before["count"])**effect.copies:
            raise _kind(effect)("count", f"{before['count']}, then {after['count']} at {after['mu']}")


def without_points(intervals):
    return [(low, high) for low, high in intervals if not near(low, high)]


def hold(one, other, effect):
    if "holding_friction" in one.result:
        _holding_friction(one, other, effect)
    else:
        _holding_factors(one, other, effect)
    grips = [answer.result.get("grip") is not None for answer in (one, other)]
    if all(grips):
        _grip(one, other, effect)
    elif any(grips) and not (one.is_open or other.is_open):
        raise Disagreement("grip", f"sums of normal reactions {'before' if grips[0] else 'after'} only")
    standing(one, other, effect)


def _holding_friction(one, other, effect):
    mine, theirs = (questions.bracket(each.result["holding_friction"]) for each in (one, other))
    _coefficient(mine, theirs, effect, not (one.is_open or other.is_open))


def _holding_factors(one, other, effect):
    mine = [tuple(sorted((effect.factor(low), effect.factor(high)))) for low, high in questions.held(one)]
    mine, theirs = sorted(mine), sorted(questions.held(other))
    if one.is_open or other.is_open:
        # Factors held in an open answer are held in a complete one as well.
        for part, whole, is_open, complete in ((mine, theirs, one.is_open, not other.is_open),
                                               (theirs, mine, other.is_open, not one.is_open)):
            for low, high in part if is_open and complete else ():
                if not any(a - NEAR * max(1, abs(a)) <= low and high <= b + NEAR * max(1, abs(b))
                           for a, b in whole):
                    raise Disagreement("intervals",
                                       f"[{low!r}, {high!r}] is held in an open answer, but {whole} are all")
        raise Undecided("open factors")
    room = max(NEAR, room_of(effect.error))
    mine, theirs = without_points(mine), without_points(theirs)
    if len(mine) != len(theirs) or not all(
            near(x, y, room) for a, b in zip(mine, theirs) for x, y in zip(a, b)):
        flat = any(each["standing"] != "proved" for answer in (one, other) for each in answer.result["intervals"])
        raise _kind(effect, flat)("intervals", f"{mine}, then {theirs}")


def _grip(one, other, effect):
    mine, theirs = one.result["grip"], other.result["grip"]
    if "computed" in (mine["standing"], theirs["standing"]) or one.is_open or other.is_open:
        raise Undecided("open sums")
    if mine["held"] != theirs["held"]:
        raise Disagreement("grip", f"{mine['held']}, then {theirs['held']}")
    if not mine["held"] or effect.copies > 1:
        return
    for end, (a, b) in zip(("minimum", "maximum"), zip(questions.sums(mine), questions.sums(theirs))):
        if (a is None) != (b is None) or a is not None and not near(a, b / effect.force,
                                                                    max(1e-6, room_of(effect.error))):
            raise Disagreement("grip", f"{end}: {a!r} times {effect.force!r}, then {b!r}")


def limit(one, other, effect):
    if one.result["kind"] == "member-loss":
        _member_loss(one, other, effect)
        return
    mine, theirs = one.result, other.result
    room = max(NEAR, room_of(effect.error))
    # Nominal results of several load cases are those of the governing one, which may be another one of
    # equals.
    several = any(len(result.get("cases", ())) > 1 for result in (mine, theirs))
    for key, a, b in (("nominal_interval", mine.get("nominal_interval"), theirs.get("nominal_interval")),
                      ("guaranteed_interval", questions.guaranteed(mine), questions.guaranteed(theirs))):
        if a is None and b is None or several and key == "nominal_interval":
            continue
        if a is None or b is None:
            if one.is_open or other.is_open:
                raise Undecided("open interval")
            raise Disagreement(key, f"{'only after' if a is None else 'only before'}: {a or b}")
        if key == "nominal_interval":
            ends, theirs_ends = ([each[end] for end in ("lower", "upper")] if isinstance(each, dict) else each
                                 for each in (a, b))
            ends = [None if end is None else effect.factor(end)
                    for end in ends][::1 if effect.slope > 0 else -1]
            if not all(near(x, y, room) for x, y in zip(ends, theirs_ends)):
                raise Disagreement(key, f"{ends}, then {theirs_ends}")
            continue
        if one.is_open or other.is_open:
            raise Undecided("open interval")
        if a["empty"] != b["empty"]:
            raise Disagreement(key, f"empty: {a['empty']}, then {b['empty']}")
        brackets = [
            questions.bracket(a[end]).changed(effect.slope, effect.shift) for end in ("lower", "upper")
        ]
        if effect.slope < 0:
            brackets.reverse()
        for end, own in zip(("lower", "upper"), brackets):
            overlap(f"{key}, {end}", own, questions.bracket(b[end]), room)
    if not several and effect.slope > 0:
        a, b = mine["nominal"], theirs["nominal"]
        if (a is None) != (b is None) or a is not None and not near(effect.factor(a), b, room):
            raise Disagreement("nominal", f"{a!r}, then {b!r}")
    if one.is_open or other.is_open:
        raise Undecided("open factor")
    standing(one, other, effect)


def _member_loss(one, other, effect):
    mine, theirs = one.result, other.result
    if theirs["kind"] != "member-loss":
        raise Disagreement("member loss", f"{one.said} | {other.said}")
    complete = not (one.is_open or other.is_open)
    if complete and mine["fatal"] != theirs["fatal"]:
        raise Disagreement("member loss", f"fatal: {mine['fatal']}, then {theirs['fatal']}")
    overlap("member loss",
            questions.bracket(mine["factor"]).changed(effect.slope, effect.shift), questions.bracket(theirs["factor"]),
            max(NEAR, room_of(effect.error)), complete)
    if not complete:
        raise Undecided("open loss")


def mip(one, other, effect):
    """Optimum and bound; the tolerance of objectives is 1e-8 of them (docs/result-files.md)."""
    mine, theirs = one.result, other.result

    def both(key):
        own, other = (value["value"] if isinstance(value, dict) else value
                      for value in (mine.get(key), theirs.get(key)))
        return [None if own is None else effect.factor(own), other]

    def room(a, b):
        return 1e-7 * max(abs(a), abs(b), abs(effect.shift))

    objectives = both("objective")
    if not (one.is_open or other.is_open):
        if mine["state"] != theirs["state"]:
            raise Disagreement(
                "answer", f"{mine['state']} {objectives[0]!r}, then {theirs['state']} {objectives[1]!r}")
        if None not in objectives and abs(objectives[0] - objectives[1]) > room(*objectives):
            raise Disagreement("optimum", f"{objectives[0]!r}, then {objectives[1]!r}")
    # A point of one program is not beyond a bound of the other one.
    sense = effect.sense
    bounds = both("bound")
    for bound, objective in ((bounds[0], objectives[1]), (bounds[1], objectives[0])):
        if None not in (bound, objective) and sense * (bound - objective) > room(bound, objective):
            raise Disagreement("bound", f"bound {bound!r}, but a point of {objective!r}")
    for complete, open_one in ((one, other), (other, one)):
        point = open_one.result.get("objective")
        if complete.code == 0 and complete.result["state"] == "infeasible" and point is not None:
            raise Disagreement("answer", f"infeasible, but a point of {point!r}")
    if one.is_open or other.is_open:
        raise Undecided("open optimum")


COMPARE = {
    "mip": mip, "patterns": patterns, "rays": rays, "critical": critical, "sweep": sweep, "hold": hold,
    "limit": limit
}


def compare(question, one, other, effect):
    """@raises Disagreement, or Undecided if an answer is open"""
    exit_codes(one, other)
    COMPARE[question.command](one, other, effect)
