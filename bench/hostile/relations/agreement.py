"""Comparison of two answers to the same question in other words.

Compared are, with these tolerances:

- exit codes: refused (1, 2) on both sides or on neither. An open answer (3, or none in time) is counted, and
  only its proved parts are compared;
- cones: the same sets. Where coordinates are rounded anew, a pattern at a limit (flat, or with a margin of up
  to NOISE times this rounding) may exist on one side only, since a displacement of 1e-16 decides it;
- margins: equal to MARGIN, since the pages state three digits;
- brackets: proved bounds overlap, up to the rounding of the coordinates; computed ones are equal to NEAR;
- intervals: the same ends to NEAR, without intervals of one point;
- standing: proved on both sides or on neither, where the change is exact. Sums are then in another order, but
  their terms are the same.
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
#: Bracket of `critical`: two cells of the default width.
WIDTH = 2.1e-8


class Disagreement(Exception):
    """part: what differs; line: both answers"""

    def __init__(self, part, line):
        super().__init__(line)
        self.part, self.line = part, line


class Undecided(Exception):
    """No comparison, for the given reason."""


def near(a, b, room=NEAR):
    """True if two numbers agree, or neither is known."""
    if a is None or b is None:
        return a is b
    return a == b or abs(a - b) <= room * max(1.0, abs(a), abs(b))


def room_of(error):
    """Relative error of numbers after a relative error of coordinates."""
    return max(1e-9, CONDITION * error)


def exit_codes(one, other):
    codes = one.code, other.code
    if any(code not in (None, 0, 3) for code in codes):
        if codes[0] == codes[1]:
            raise Undecided("refused on both sides")
        raise Disagreement("exit code", f"exit code {codes[0]}, then {codes[1]}: {one.said} | {other.said}")
    if one.result is None or other.result is None:
        raise Undecided("no answer in time")


def standing(one, other, effect):
    if not effect.exact or one.is_open or other.is_open:
        return
    proved = questions.is_proved(one), questions.is_proved(other)
    if proved[0] != proved[1]:
        raise Disagreement(
            "standing", " but ".join(f"{'proved' if each else 'computed'}: {answer.said}"
                                     for each, answer in zip(proved, (one, other))))


def _name(key):
    sets = [" ".join(map(str, sorted(each))) or "-" for each in key]
    return f"{{{sets[0]} | {sets[1]}}}"


def patterns(one, other, effect):
    if one.is_open or other.is_open:
        raise Undecided("undecided patterns")
    mine, theirs = questions.cones(one, range(len(one.names))), questions.cones(other, effect.original)
    limit = NOISE * room_of(effect.error) if effect.error else 0.0
    at_limit = False
    for key in sorted(mine.keys() ^ theirs.keys(), key=_name):
        state, margin = mine.get(key) or theirs[key]
        if effect.exact or state == "alive" and margin > limit:
            raise Disagreement(
                "cones", f"{len(mine)}, then {len(theirs)} patterns; {_name(key)} ({state}, margin {margin}) "
                f"only {'before' if key in mine else 'after'}")
        at_limit = True
    if at_limit or not effect.exact and any(state != "alive" or margin <= limit
                                            for state, margin in mine.values()):
        raise Undecided("patterns at a limit, coordinates rounded anew")
    for key, (state, margin) in mine.items():
        if theirs[key][0] != state:
            raise Disagreement("cones", f"{_name(key)} is {state}, then {theirs[key][0]}")
    count = int(one.result["count"])**effect.copies
    if int(other.result["count"]) != count:
        raise Disagreement("count", f"{one.result['count']}, then {other.result['count']} instead of {count}")
    for key, (state, margin) in mine.items():
        if state == "alive" and not math.isclose(margin, theirs[key][1], rel_tol=MARGIN, abs_tol=1e-9):
            raise Disagreement("margins", f"{_name(key)}: margin {margin!r}, then {theirs[key][1]!r}")


def rays(one, other, effect):
    if one.is_open or other.is_open:
        raise Undecided("undecided rays")
    mine, theirs = questions.ray_cones(one,
                                       range(len(one.names))), questions.ray_cones(other, effect.original)
    if mine != theirs:
        if not effect.exact:
            raise Undecided("coordinates rounded anew")
        raise Disagreement(
            "cones", f"{len(mine)}, then {len(theirs)} cones; "
            f"only on one side {sorted(map(_name, mine ^ theirs))[0]}")
    if effect.exact and not effect.copies > 1 and one.result["count"] != other.result["count"]:
        raise Disagreement("count", f"{one.result['count']}, then {other.result['count']} rays")


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


def critical(one, other, effect):
    mine, theirs = (questions.bracket(each.result["critical_friction"]) for each in (one, other))
    complete = not (one.is_open or other.is_open)
    try:
        overlap("bracket", mine.changed(effect.mu), theirs,
                room_of(effect.error) if effect.error else 0.0, complete)
    except Disagreement:
        # A flat configuration, which no rounding may change, has no proved upper bound.
        if not effect.exact and not (mine.high_proved and theirs.high_proved):
            raise Undecided("critical at a limit, coordinates rounded anew") from None
        raise
    if not complete:
        raise Undecided("open bracket")


def sweep(one, other, effect):
    at = {point["mu"]: point["count"] for point in one.result["points"]}
    for point in other.result["points"]:
        before = next((count for mu, count in at.items() if near(mu * effect.mu, point["mu"], 1e-12)), None)
        if None in (before, point["count"]):
            raise Undecided("open counts")
        if int(point["count"]) != int(before)**effect.copies:
            if not effect.exact:
                raise Undecided("coordinates rounded anew")
            raise Disagreement("count", f"{before}, then {point['count']} at {point['mu']}")


def without_points(intervals):
    return [(low, high) for low, high in intervals if not near(low, high)]


def hold(one, other, effect):
    if one.result["holding_friction"] is not None:
        _holding_friction(one, other, effect)
    else:
        _holding_factors(one, other, effect)
    if one.result.get("grip") and other.result.get("grip"):
        _grip(one, other, effect)
    standing(one, other, effect)


def _holding_friction(one, other, effect):
    mine, theirs = (questions.bracket(each.result["holding_friction"]) for each in (one, other))
    complete = not (one.is_open or other.is_open)
    overlap("bracket", mine.changed(effect.mu), theirs,
            room_of(effect.error) if effect.error else 0.0, complete)
    if not complete:
        raise Undecided("open bracket")


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
        raise Disagreement("intervals", f"{mine}, then {theirs}")


def _grip(one, other, effect):
    mine, theirs = one.result["grip"], other.result["grip"]
    if None in (mine["held"], theirs["held"]) or one.is_open or other.is_open:
        raise Undecided("open sums")
    if mine["held"] != theirs["held"]:
        raise Disagreement("grip", f"{mine['held']}, then {theirs['held']}")
    if not mine["held"] or effect.copies > 1:
        return
    for end in ("least", "most"):
        a, b = (each[end] and each[end]["held"] for each in (mine, theirs))
        if (a is None) != (b is None) or a is not None and not near(a * effect.force, b,
                                                                    max(1e-6, room_of(effect.error))):
            raise Disagreement("grip", f"{end}: {a!r} times {effect.force!r}, then {b!r}")


def limit(one, other, effect):
    if one.result.get("member_loss"):
        _member_loss(one, other, effect)
        return
    mine, theirs = one.result, other.result
    room = max(NEAR, room_of(effect.error))
    # Nominal results of several load cases are those of the governing one, which may be another one of
    # equals.
    several = any(len(result.get("cases", ())) > 1 for result in (mine, theirs))
    for key in ("nominal_interval", "guaranteed_interval_of_all_cases", "guaranteed_interval"):
        if key == "guaranteed_interval" and "guaranteed_interval_of_all_cases" in theirs:
            continue
        a, b = mine.get(key), theirs.get(key)
        if key == "guaranteed_interval_of_all_cases" and a is None and b is not None:
            a = mine.get("guaranteed_interval")
        if a is None or b is None or several and key == "nominal_interval":
            continue
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
    mine, theirs = one.result["member_loss"], other.result.get("member_loss")
    if theirs is None:
        raise Disagreement("member loss", f"{one.said} | {other.said}")
    complete = not (one.is_open or other.is_open)
    if complete and mine["fatal"] != theirs["fatal"]:
        raise Disagreement("member loss", f"fatal: {mine['fatal']}, then {theirs['fatal']}")
    overlap("member loss",
            questions.bracket(mine).changed(effect.slope, effect.shift), questions.bracket(theirs),
            max(NEAR, room_of(effect.error)), complete)
    if not complete:
        raise Undecided("open loss")


def mip(one, other, effect):
    """Optimum and bound; the tolerance of objectives is 1e-8 (docs/result-files.md)."""
    mine, theirs = one.result, other.result
    objectives = [
        None if mine["objective"] is None else effect.factor(mine["objective"]), theirs["objective"]
    ]
    if not (one.is_open or other.is_open):
        if mine["answer"] != theirs["answer"]:
            raise Disagreement(
                "answer", f"{mine['answer']} {objectives[0]!r}, then {theirs['answer']} {objectives[1]!r}")
        if None not in objectives and not near(*objectives, 1e-7):
            raise Disagreement("optimum", f"{objectives[0]!r}, then {objectives[1]!r}")
    # A point of one program is not beyond a bound of the other one.
    sense = effect.sense
    bounds = [None if mine["bound"] is None else effect.factor(mine["bound"]), theirs["bound"]]
    for bound, objective in ((bounds[0], objectives[1]), (bounds[1], objectives[0])):
        if None not in (bound, objective
                        ) and sense * (bound - objective) > 1e-7 * max(1.0, abs(bound), abs(objective)):
            raise Disagreement("bound", f"bound {bound!r}, but a point of {objective!r}")
    for complete, open_one in ((one, other), (other, one)):
        if complete.code == 0 and complete.result["answer"] == "infeasible" and open_one.result[
                "objective"] is not None:
            raise Disagreement("answer", f"infeasible, but a point of {open_one.result['objective']!r}")
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
