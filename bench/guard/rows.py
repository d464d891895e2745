"""The rows: calls that stand for what README.md and bench/README.md claim, and smaller ones of the same
families for every day. Their expected answers come from the papers, other programs or other methods
(bench/history.md), never from the table.
"""

from calls import (Row, as_published, bench, bracket, count, example, interval, knapsack, printed_line,
                   shipped, solve, verified, verify, within, written)

import faces
import hold
import structures

PUBLISHED = "3 counts as published"

# Number of nodes in the output of calls without a result file.
COVERING = r"(\d+) nodes? covers?"
TREE = r"nodes +(\d+)"
OPENED = r"(\d+) nodes opened"


def space_truss(rows, depth):
    return example("space-truss", "--rows", rows, "--depth", depth)


def patterns(problem, mu=0.5):
    return solve("patterns", problem, "--mu", mu, certificate=True)


def critical(problem):
    return solve("critical", problem, certificate=True)


def ends(mesh):
    """Both ends of the critical coefficient without a tree."""
    return solve("critical", written(mesh), "--node-limit", 1)


def proved(key, truth, relative=1e-6):
    """Answer and expected answer of a bracket around this number."""
    return bracket(key, truth, relative), f"solved, proved to {relative}, {truth}"


def friction(truth):
    return proved("critical_friction", truth)


def holding(truth):
    return proved("holding_friction", truth, 1e-8)


def worst(truth):
    return proved("maximum", truth)


def between(least, most):
    """Answer and expected answer of a bracket between these coefficients."""
    return within(least, most), f"node-limit, proved within {least} and {most}"


def pressed(name):
    """A slab between two walls."""
    return solve("hold", written(hold.ROWS[name]), "--mu", 0.2, certificate=True)


def arch(voussoirs):
    return solve("hold", written(structures.arch(voussoirs)), certificate=True)


def rays(rows, *words):
    return solve("rays", example("plane-truss", "--rows", rows, *words), "--mu", 0.65)


def grid(bays):
    return example("grid", "--bays", bays)


def limit(problem, alpha, *words):
    return solve("limit", problem, "--alpha", alpha, *words, certificate=True)


def dome(segments, rings):
    return limit(written(structures.dome(segments, rings)), 1)


def uts(tree):
    return bench("uts", "--tree", tree, "--rounds", 1)


EXAMPLE = shipped("space-truss.toml")
BRIDGE = shipped("truss-bridge.toml")

DAILY = [
    Row("readme-patterns", patterns(EXAMPLE, 0.65), count, "solved, 27 found"),
    Row("patterns-15x2", patterns(space_truss(15, 2)), count, "solved, 72 found"),
    Row("patterns-6x5", patterns(space_truss(6, 5)), count, "solved, 67 found"),
    Row("critical-example", critical(EXAMPLE), *friction(0.470279645)),
    Row("critical-15x2", critical(space_truss(15, 2)), *friction(0.46934911)),
    Row("face-50", ends(faces.face(50)), *between(1, 5.41), exit_code=3),
    Row("hold-space-18", pressed("space-18"), interval, "solved, -17.28 to 28.25"),
    Row("arch-8", arch(8), *holding(0.34989642217)),
    Row("rays-paper-15", rays(15, "--paper"), count, "solved, 744 found"),
    Row("rays-11", rays(11), count, "solved, 3,022 found"),
    Row("limit-8", limit(grid(8), 40), *worst(1.40955087)),
    Row("limit-10", limit(grid(10), 40), *worst(-1.53016484)),
    Row("dome-8", dome(8, 3), *worst(1.11614366)),
    Row("loss-bridge", limit(BRIDGE, 1, "--lose", 1), *proved("factor", -1.34)),
    Row("verify-patterns", verify(patterns(space_truss(15, 2))), verified, "proved", opened=COVERING),
    Row("verify-critical", verify(critical(space_truss(15, 2)), ".lower"), verified, "proved",
        opened=COVERING),
    Row("verify-hold", verify(pressed("space-18")), verified, "proved"),
    Row("verify-limit", verify(limit(grid(10), 40)), verified, "proved", opened=COVERING),
    Row("uts-t1-7", uts("T1-7"), as_published, PUBLISHED, opened=TREE),
    Row("engine-knapsack", knapsack(2000, 1), printed_line("value"), "value 627846", opened=OPENED),
]

NIGHTLY = [
    Row("patterns-8x5", patterns(space_truss(8, 5)), count, "solved, 228 found"),
    Row("patterns-10x5", patterns(space_truss(10, 5)), count, "solved, 1,698 found"),
    Row("face-100", ends(faces.face(100)), *between(2.578, 5.295), exit_code=3),
    Row("cube-49", ends(faces.cube("cube-49", 6, 6)), *between(0.983, 1.3061), exit_code=3),
    Row("cube-100", ends(faces.cube("cube-100", 9, 9)), *between(0.967, 1.2945), exit_code=3),
    Row("hold-space-50", pressed("space-50"), interval, "solved, -6.87 to 11.20"),
    Row("arch-24", arch(24), *holding(0.35199637038)),
    Row("rays-paper-19", rays(19, "--paper"), count, "solved, 5,413 found"),
    Row("rays-14", rays(14), count, "solved, 60,132 found"),
    Row("limit-16", limit(grid(16), 40), *worst(-10.2734734)),
    Row("limit-20", limit(grid(20), 40), *worst(-16.6738075)),
    Row("dome-24", dome(24, 6), *worst(0.3599869)),
    Row("uts-t1", uts("T1"), as_published, PUBLISHED, opened=TREE),
]

ROWS = [*DAILY, *NIGHTLY]
