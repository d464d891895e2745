"""Figures printed in the two papers, the calls that compute them, and the values in their results.

W is METR 2009-28 (wedged configurations), L is METR 2006-39 (worst-case limit loads). tools/papers
determines agreement from the figures; where they differ, `why` must give the reason.
"""
import re
from typing import Callable, NamedTuple

MISSING = "not available"
NOTHING = "–"  # described in the paper without a figure
PLANE_TRUSSES = (5, 7, 9, 11, 13, 15, 17, 19)
BODY = "examples/paper/elastic-body.toml"
SPACE = "examples/paper/space-truss-fit.toml"
THREE = "examples/paper/limit-3x3.toml"
FOUR = "examples/paper/limit-4x4.toml"
GAP = "examples/static-gap.toml"
BOTH = (f"kusabi limit {THREE} --alpha 20 --output two.json; "
        f"kusabi limit {THREE} --alpha 40 --curve --curve-load two.json --curve-to 2")
PRINTED = f"kusabi limit {FOUR} --alpha 40 --cuts disjunctive --big-m 5 --node-limit 1"
CLIQUES = "ours: [each is a maximal clique, and none is missing](theory/rays.md#maximal-cones)"


class Row(NamedTuple):
    place: str
    command: str
    printed: str
    read: Callable
    why: str = ""
    # slow: not in a quick run. seconds: a time, not in a quick run and never compared. ours: no
    # figure of the paper to compare with; `why` names the structure.
    kind: str = ""


# Values read from results.

def rays_and_cones(run):
    return f"{len(run.result['rays'])}, {len(run.result['cones'])}"


def cones(run):
    """Number of rays of each cone, and its contact set, with candidates counted from 0 at the lower end."""
    number = {each["node"]: at for at, each in enumerate(run.problem["contact"])}
    idle = [set(cone.get("idle", ())) for cone in run.result["cones"]]
    return "; ".join(f"{len(cone['rays'])}: {braced(number[each] for each in cone['contact'] if each not in rest)}"
                     for cone, rest in sorted(zip(run.result["cones"], idle), key=lambda pair: -len(pair[0]["rays"])))


def rays_of_cones(run):
    return ", ".join(str(each) for each in sorted((len(cone["rays"]) for cone in run.result["cones"]), reverse=True))


def braced(numbers):
    return "{" + ", ".join(str(each) for each in numbers) + "}"


def count(run):
    return str(run.result["count"])


def coefficients(digits):
    def read(run):
        ends = [(each["lower"], each["upper"]) for each in run.result["patterns"]]
        return ", ".join(enclosed(lower, upper, digits) for lower, upper in ends)
    return read


def critical(run):
    found = run.result["critical_friction"]
    return enclosed(found["lower"]["value"], found["upper"]["value"], 4)


def enclosed(lower, upper, digits):
    """A number between two bounds, if they agree to the given digits."""
    low, high = f"{lower:.{digits}f}", f"{upper:.{digits}f}"
    return low if low == high else f"{low} … {high}"


def imbalance(run):
    worst = max(each["imbalance"] for each in run.result["patterns"])
    return "all nodes and supports, out of balance by less than 10⁻¹²" if worst < 1e-12 else f"{worst:.0e}"


def exact_cones(run):
    return re.search(r"(\d+) maximal cones", run.text)[1]


def candidates(run):
    tested = run.result["candidates"]
    return f"{len(tested)}, {sum(not each['discarded'] for each in tested)}"


def swept(run):
    return ", ".join(str(each["count"]) for each in run.result["points"])


def matrix(run):
    lines = [each for each in run.text.splitlines() if not each.startswith("%")]
    return " × ".join(lines[0].split())


def cones_of_program(run):
    lines = run.text.splitlines()
    return f"{lines[lines.index('CON') + 1].split()[1]} conic constraints"


def sums_are_solutions(run):
    """True if the sum of all rays of each cone is a solution, u_n r_n = 0 (W 3.8, 3.9)."""
    worst = 0
    for cone in run.result["cones"]:
        rays = [run.result["rays"][number - 1] for number in cone["rays"]]
        for candidate in range(len(run.problem["contact"])):
            reaction = sum(ray["reaction"][candidate][0] for ray in rays)
            worst = max(worst, reaction * sum(ray["displacement"][candidate][0] for ray in rays))
    return f"largest u_n r_n {worst:g}"


def nominal(run):
    return f"{run.result['nominal']:.4f}"


def worst_case(run):
    ends = run.result["maximum"]
    return enclosed(ends["lower"]["value"], ends["upper"]["value"], 4)


def sway(mode):
    return lambda run: "sway" if run.result[mode]["along_reference_load"] else "not sway"


def sizes(run):
    return f"n^m = {run.problem['members']}, m = {run.result['uncertain_components']}"


def yielding(mode):
    return sorted("-".join(each["member"]) for each in mode["yielding"])


def same_mode(run):
    both = run.result["nominal_mode"], run.result["collapse_mode"]
    return "as nominal" if yielding(both[0]) == yielding(both[1]) else "another"


def objective(run):
    return f"{run.result['objective']:.4f}"


def opposite_objective(run):
    return f"{-run.result['objective']:.4f}"


def corners(pieces):
    return [pieces[0]["factor_from"], *(each["factor_to"] for each in pieces)]


def curve_ends(name):
    return lambda run: f"{corners(run.result[name])[0]:.4f}, {corners(run.result[name])[-1]:.4f}"


def curve_modes(name):
    return lambda run: ", ".join("sway" if each["along_reference_load"] else "not sway" for each in run.result[name])


def breakpoints(run):
    places = [each["from"] for name in ("curve", "worst_curve") for each in run.result[name] if each["from"] > 0]
    return "β = " + ", ".join(f"{each:.4f}" for each in places)


def stopped(run):
    return f"{run.statistics['zero_one']['nodes']} nodes, still open"


def samples(run):
    least, worst = run.result["samples"]["least"], run.result["maximum"]["upper"]["value"]
    return "all above λ_min" if least >= worst else f"some below: {least:.4f}"


def seconds(run):
    return f"{run.seconds:.2f}"


PRINTED_TABLE_2 = {5: (8, 1, 0.11), 7: (24, 3, 0.31), 9: (47, 5, 0.87), 11: (100, 9, 2.78), 13: (273, 15, 10.89),
                   15: (744, 30, 74.05), 17: (2048, 57, 572.57), 19: (5413, 108, 3245.94)}


def table_2():
    for number, (rays, cliques, _) in PRINTED_TABLE_2.items():
        yield Row(f"Table 2, N = {number}: rays, cliques", f"kusabi rays plane-{number}.toml --mu 0.65",
                  f"{rays}, {cliques}", rays_and_cones, CLIQUES if number > 13 else "", "slow" if number > 15 else "")


def exact_cliques():
    for number, printed in ((15, "30"), (17, "57"), (19, "108")):
        yield Row(f"Table 2, N = {number}: cliques in exact arithmetic",
                  f"python3 tests/reference/exact_cliques.py {number}", printed, exact_cones, CLIQUES, "slow")


def cliques_by_patterns():
    for number, printed in ((15, "30"), (17, "57"), (19, "108")):
        yield Row(f"Table 2, N = {number}: cliques by the tree of sign patterns",
                  f"kusabi patterns plane-{number}.toml --mu 0.65", printed, count, CLIQUES)


def table_2_seconds():
    for number, (_, _, printed) in PRINTED_TABLE_2.items():
        yield Row(f"W Table 2, N = {number}", f"kusabi rays plane-{number}.toml --mu 0.65",
                  str(printed), seconds, "", "seconds")


TABLES = {
    "wedged-methods": [
        Row("Proposition 3.9, (11)", "kusabi rays plane-5.toml --mu 1", NOTHING, sums_are_solutions,
            "the sum of all rays of a cone is a solution, for each cone", "ours"),
        Row("Algorithms 4.1, 4.2", "kusabi rays plane-11.toml --mu 0.65 --method double-description", "100, 9",
            rays_and_cones),
        Row("the same, by the tree of sign patterns", "kusabi rays plane-11.toml --mu 0.65 --method tree", "100, 9", rays_and_cones),
        Row("Proposition 4.9, cliques, N = 5", "python3 tests/reference/exact_cliques.py 5", "1", exact_cones),
        Row("Algorithm 5.1, t̂ at N = 5", "kusabi patterns plane-5.toml --mu 1", "5", count),
        Row("Remark 5.2, breadth-first", "kusabi patterns plane-5.toml --mu 1 --order breadth-first", "5", count),
        Row("Remark 5.5, the rule", "kusabi patterns plane-5.toml --mu 1 --branching paper", "5", count),
        Row("Algorithm 5.8, Y_1 … Y_k, and those that remain", f"kusabi patterns {SPACE} --mu 0.65 --method polyhedral --facets 8",
            NOTHING, candidates, "found with polyhedral cones, and feasible with the friction cones", "ours"),
        Row("Algorithm 6.1", "kusabi critical plane-5.toml --method bisection --mu-max 1", "0.6072", critical),
        Row("(3)", "kusabi export matrix plane-5.toml", NOTHING, matrix, "K, condensed to the candidates", "ours"),
        Row("(18), (23), the root", "kusabi export cbf plane-5.toml --mu 1", NOTHING, cones_of_program,
            "as a cone program for other solvers", "ours"),
        Row("(4), (5)", "kusabi patterns plane-5.toml --mu 1", NOTHING, imbalance, "in the result file", "ours"),
    ],
    "wedged-body": [
        Row("7.1: extremal rays, cliques", f"kusabi rays {BODY} --mu 1.5", "5, 2", rays_and_cones),
        Row("Figure 3: (a)–(d) go together, (e) alone", f"kusabi rays {BODY} --mu 1.5", "4 and 1",
            lambda run: " and ".join(str(size) for size in
                                     sorted((len(each["rays"]) for each in run.result["cones"]), reverse=True))),
        Row("Table 1: μᶜ of both patterns", f"kusabi critical {BODY} --method newton --mu-max 1.5", f"1.2689, {MISSING}",
            coefficients(4), "the first is the same; the second entry is not available"),
        Row("7.1: μᶜ", f"kusabi critical {BODY}", "1.2689", critical),
        Row("Figure 2: the rays drawn", f"kusabi rays {BODY} --mu 1.5", MISSING, cones,
            "rays of each cone, and the candidates at which they are in contact; the picture is not available"),
    ],
    "wedged-plane": [
        *table_2(),
        *exact_cliques(),
        *cliques_by_patterns(),
        Row("Figures 8, 9: rays, N = 5, μ = 1", "kusabi rays plane-5.toml --mu 1", "25",
            lambda run: str(len(run.result["rays"]))),
        Row("Figure 5: t̂", "kusabi rays plane-5.toml --mu 1", "5", lambda run: str(len(run.result["cones"]))),
        Row("Figure 5: the circles", "kusabi rays plane-5.toml --mu 1", MISSING, cones,
            "rays of each cone, and the candidates at which they are in contact; the picture is not available"),
        Row("7.2: rays (a)–(i) of one pattern", "kusabi rays plane-5.toml --mu 1", "9", rays_of_cones,
            "rays of each of our five cones; none has nine"),
        Row("Table 3: μᶜ of (a)–(e)", "kusabi critical plane-5.toml --method bisection --mu-max 1",
            "0.6072, 0.6718, 0.7804, 0.7909, 0.9422", coefficients(4)),
        Row("Table 3, by one sweep", "kusabi sweep plane-5.toml --mu-max 1 --svg chart.svg",
            "0.6072, 0.6718, 0.7804, 0.7909, 0.9422", coefficients(4)),
        Row("7.2: μᶜ", "kusabi critical plane-5.toml", "0.6072", critical),
    ],
    "wedged-space": [
        Row(f"Table 4, μ = {mu}: sign patterns", f"kusabi patterns {SPACE} --mu {mu}", printed, count,
            "the picture of the truss is not available; this truss was fitted to the table", "ours")
        for mu, printed in ((0.55, "0"), (0.6, "1"), (0.65, "26"), (0.7, "61"), (1.0, "236"))
    ] + [
        Row("Table 4, by one sweep", f"kusabi sweep {SPACE} --mu 0.55,0.6,0.65,0.7,1 --svg chart.svg", "0, 1, 26, 61, 236", swept,
            "of the fitted truss", "ours"),
    ],
    "limit-methods": [
        Row("(5)", f"kusabi export mps {THREE} --program static --output 5.mps; kusabi mip 5.mps", "48.3662",
            opposite_objective),
        Row("(15), Proposition 3.4", f"kusabi export mps {THREE} --program kinematic --output 15.mps; kusabi mip 15.mps",
            "48.3662", objective),
        Row("(6), Assumption 3.1", "kusabi limit examples/gust.toml --alpha 0.5", NOTHING, worst_case,
            "a gust at several nodes: columns of T of any direction", "ours"),
        Row("(12), (13)", f"kusabi limit {THREE} --alpha 40", "37.0120", worst_case),
        Row("(29), Propositions 3.6, 4.1", f"kusabi export mps {THREE} --alpha 40 --output 29.mps; kusabi mip 29.mps",
            "37.0120", objective),
        Row("Algorithm 4.2, a small truss", f"kusabi limit {GAP} --alpha 0.45 --cuts none --big-m 20", NOTHING, worst_case,
            "2.0071 by all 2⁷ corners", "ours"),
        Row("Algorithm 5.1, then 4.2", f"kusabi limit {GAP} --alpha 0.45 --cuts disjunctive --big-m 20", NOTHING,
            worst_case, "the same", "ours"),
        Row("Remark 4.5, v^U from 100 loads", f"kusabi limit {FOUR} --alpha 40 --cuts none --big-m 5 --samples 100 "
            "--node-limit 1", NOTHING, lambda run: f"{run.result['zero_one']['start']:.3f}",
            "above λ_min, as it must be", "ours"),
        Row("Remark 3.3", f"kusabi limit {THREE} --alpha 40 --curve", NOTHING, breakpoints,
            "where the mode changes, for β ζ₁ and for λ_min(β α₁)", "ours"),
    ],
    "limit-three": [
        Row("6.1: n^m, m", f"kusabi limit {THREE} --alpha 40", "n^m = 42, m = 24", sizes),
        Row("6.1: λ\\* of the nominal load", f"kusabi limit {THREE}", "48.3662", nominal),
        Row("Figure 2: its mode", f"kusabi limit {THREE}", "sway", sway("nominal_mode")),
        Row("6.1: λ_min, α = 40 kN", f"kusabi limit {THREE} --alpha 40", "37.0120", worst_case),
        Row("Figure 3: its mode", f"kusabi limit {THREE} --alpha 40", "not sway", sway("collapse_mode")),
        Row("6.1: λ_min, α = 20 kN", f"kusabi limit {THREE} --alpha 20", "44.3662", worst_case),
        Row("Figure 4: its mode", f"kusabi limit {THREE} --alpha 20", "sway", sway("collapse_mode")),
        Row("Figure 5, (A), (C) of the solid line", f"kusabi limit {THREE} --alpha 40 --curve", "48.3662, 37.0120",
            curve_ends("curve")),
        Row("Figure 5, modes along it", f"kusabi limit {THREE} --alpha 40 --curve", "sway, not sway", curve_modes("curve")),
        Row("Figure 5, (D) of the dashed line", BOTH, MISSING, lambda run: curve_ends("load_curve")(run).split(", ")[1],
            "λ\\* under 2 ζ₂; printed only in the picture, which is not available"),
        Row("Figure 5, modes along it", BOTH, "sway", curve_modes("load_curve")),
        Row("Figure 5, (A), (E), (C)", f"kusabi limit {THREE} --alpha 40 --curve", f"48.3662, {MISSING}, 37.0120",
            lambda run: ", ".join(f"{each:.4f}" for each in corners(run.result["worst_curve"])),
            "λ_min(β α₁), proved; (E), at β = 0.7779, is printed only in the picture"),
    ],
    "limit-four": [
        Row("6.2: n^m, m", f"kusabi limit {FOUR} --alpha 40", "n^m = 68, m = 34", sizes),
        Row("6.2, Figure 7: λ\\* of the nominal load", f"kusabi limit {FOUR}", "14.2650", nominal),
        Row("6.2, Figure 8: λ_min, α = 40 kN", f"kusabi limit {FOUR} --alpha 40", "7.7296", worst_case),
        Row("Figure 8: its mode", f"kusabi limit {FOUR} --alpha 40", "as nominal", same_mode),
        Row("6.2: iterations of Algorithm 5.1", PRINTED, "61", lambda run: str(run.result["zero_one"]["cut_rounds"])),
        Row("6.2: cuts kept", PRINTED, "34", lambda run: str(run.result["zero_one"]["cuts"]),
            "[which cuts are kept](theory/limit.md#the-0-1-program-l-29) depends on the units of motions and on the simplex method"),
        Row("6.2: programs of Algorithm 4.2", f"{PRINTED[:-2]} 20000", "9", stopped,
            "not reached: (38) begins at −3385.7 with M = 5, [see there](theory/limit.md#the-0-1-program-l-29)", "slow"),
        Row("the same by static cuts", f"kusabi limit {FOUR} --alpha 40", NOTHING,
            lambda run: f"{run.result['programs']['cuts']} cuts, "
                        f"{run.result['programs']['load_factors'] + run.result['programs']['relaxations']} programs",
            "no M, no tree", "ours"),
        Row("Figure 10: random loads", f"kusabi limit {FOUR} --alpha 40 --samples 1000", "all above λ_min", samples),
    ],
    "seconds": [
        Row("W 7.1, Algorithm 4.2", f"kusabi rays {BODY} --mu 1.5", "18.72", seconds, "", "seconds"),
        *table_2_seconds(),
        Row("L 6.2, Algorithm 5.1", PRINTED, "229.5", seconds, "", "seconds"),
        Row("L 6.2, Algorithm 4.2 after it", f"kusabi limit {FOUR} --alpha 40", "28.5", seconds,
            "by static cuts, with both bounds proved", "seconds"),
    ],
}
