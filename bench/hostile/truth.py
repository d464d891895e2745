"""Writes tests/cases/truth.json: correct answers for the inputs there, by the oracle in 80 digits.

    python3 bench/hostile/truth.py tests/cases

No output of `kusabi` is copied. `exit` is the exit code; in the list of a block, margins are t* in
the unit of the block (docs/theory/wedged.md), correct to four digits; a critical coefficient is a
bracket of the exact one. In `cones` of rays, `contact` is without the inactive candidates.
"""

import json
import os
import sys
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal

import plane
import space
from oracle import Oracle

DIGITS = Decimal("1e-13")

#: file: (coefficients for patterns, coefficients for rays, further arguments of `critical`)
ASKED = {
    "plane_truss_and_post": (["1", "3"], ["1"], [["--method", "newton", "--mu-max", "1"]]),
    "two_pieces": (["3", "4.9", "5.1"], ["3", "5.1"], [["--method", "newton", "--mu-max", "6"], ["--method", "bisection", "--mu-max", "6"]]),
    "two_random_pieces_1": (["1"], ["1"], [["--method", "newton", "--mu-max", "2"], ["--method", "bisection", "--mu-max", "2"]]),
    "one_bay_plane": (["0.48", "0.47"], ["0.48", "0.47"], [["--method", "newton", "--mu-max", "0.65"], ["--method", "bisection", "--mu-max", "0.65"]]),
    "crit_wide_1098": (["0.2", "1"], [], []),
    "false_lower_101": (["1.13815"], ["1.13815"], [["--method", "newton", "--mu-max", "1.13815"]]),
    "false_lower_62": (["near"], ["near"], [["--method", "newton", "--mu-max", "near"]]),
    "undecided_contrast6_493": (["0.7261972342575947"], ["0.7261972342575947"], []),
    "undecided_10073": (["1.6914265214745143"], ["1.6914265214745143"], []),
    "undecided_lowcond_88": (["near"], ["near"], []),
    "margin_low_t1_3_20059": (["0.8176783003384308"], [], []),
    "tolerance_undecided": (["0.51200526"], [], []),
    "critical_wrong_1e6": (["560.546"], [], []),
    "critical_wrong_low": (["107.781"], [], []),
    "big_int": (["1.5"], ["1.5"], []),
    "rays_free_pair_of_bars": (["2.63494"], ["2.63494"], []),
    "critical_flat_rods": (["3"], ["3"], [["--method", "newton", "--mu-max", "5"], ["--method", "bisection", "--mu-max", "5"]]),
    "critical_flat_space_grid": (["0.9"], [], [["--method", "newton", "--mu-max", "2"]]),
    "critical_flat_grid": (["1.5"], ["1.5"], [["--method", "newton", "--mu-max", "2"]]),
}

#: Certificates that must be refused: {file: (arguments, permitted exit codes, reason)}
REFUSED = {
    "forged-decoupled-K.cert": (["--problem", "../../examples/plane-truss.toml"], [1], "the K is not that of the structure"),
    "everything-marginal.cert": ([], [1, 3], "every node is left open: nothing is proved"),
}


def structural_blocks(structure):
    """Candidates coupled through free displacements, by exact zeros of the directions of bars."""
    parent = {}

    def root(key):
        while parent.setdefault(key, key) != key:
            key = parent[key]
        return key

    free = lambda node, axis: axis not in structure.fixed.get(node, ())
    groups = []
    for _, a, b in structure.bars:
        along = [axis for axis in range(structure.dimension) if structure.nodes[a][axis] != structure.nodes[b][axis]]
        groups.append([(node, axis) for node in (a, b) for axis in along if free(node, axis)])
    for *_, between in structure.quads:
        groups.append([(node, axis) for node in between for axis in (0, 1) if free(node, axis)])
    for node, *_ in structure.candidates:
        groups.append([(node, axis) for axis in range(structure.dimension)])
    for group in groups:
        for key in group[1:]:
            parent[root(key)] = root(group[0])
    blocks = {}
    for i, (node, *_) in enumerate(structure.candidates):
        blocks.setdefault(root((node, 0)), []).append(i)
    return list(blocks.values())


def patterns(oracle, mu):
    """Expected output of `patterns`, and cones of `rays`."""
    whole = oracle.cones(mu)
    assert not whole.undecided, whole.undecided
    blocks, count = [], 1
    for block in structural_blocks(oracle.structure):
        friction = oracle.friction(mu)
        leaves, unsure = space.enumerate_cones(oracle.block(block), oracle.d, [friction[i] for i in block])
        assert not unsure
        listed = []
        for (pressing, parted), solid in sorted(plane.maximal(leaves).items(), key=lambda item: sorted(item[0][0])):
            named = lambda numbers: [oracle.names[block[k]] for k in sorted(numbers)]
            entry = {"contact": named(pressing), "separated": named(parted),
                     "inactive": named(set(range(len(block))) - pressing - parted), "state": "feasible" if solid else "flat"}
            if solid:
                low, high = oracle.block_margin(mu, entry["contact"], entry["separated"])
                assert high - low < abs(low) * Decimal("1e-4")
                entry["margin"] = float(f"{(low + high) / 2:.5g}")
            listed.append(entry)
        blocks.append({"candidates": [oracle.names[i] for i in block], "count": len(listed), "patterns": listed})
        count *= max(1, len(listed))
    count = count if any(block["count"] for block in blocks) else 0
    assert count == len(whole.cones), (count, len(whole.cones))
    return {"exit": 0, "count": count, "rays": whole.rays, "blocks": blocks}


def critical(oracle):
    """A bracket of the smallest coefficient at which something wedges, or None up to 10^6."""
    low, high = Decimal(0), Decimal(1)
    while not oracle.wedges(high):
        low, high = high, 2 * high
        if high > 10 ** 6:
            return None
    while high - low > DIGITS * high:
        middle = (low + high) / 2
        if oracle.wedges(middle):
            high = middle
        else:
            low = middle
    return low, high


def rounded(value, way):
    """13 significant digits, rounded outwards."""
    return str(value.quantize(Decimal(1).scaleb(value.adjusted() - 13), rounding=way))


def main():
    folder = sys.argv[1]
    truths = []
    for name, (at, rays_at, more) in ASKED.items():
        with open(os.path.join(folder, name + ".toml")) as file:
            oracle = Oracle(file.read())
        bracket = critical(oracle)
        near = f"{bracket[1] * Decimal('1.0001'):.10g}" if bracket else None
        file = name + ".toml"
        in_order = lambda names: [other for other in oracle.names if other in names]
        for mu in at:
            mu = near if mu == "near" else mu
            found = patterns(oracle, Decimal(float(mu)))
            rays = found.pop("rays")
            truths.append({"file": file, "command": ["patterns", "--mu", mu], "expected": found})
            print(file, "patterns", mu, found["count"], flush=True)
            if mu in [near if x == "near" else x for x in rays_at]:
                cones = [{"contact": in_order(s), "separated": in_order(g), "idle": in_order(set(oracle.names) - s - g)}
                         for s, g in oracle.cones(Decimal(float(mu))).cones]
                cones.sort(key=lambda cone: [oracle.names.index(name) for name in cone["contact"]])
                truths.append({"file": file, "command": ["rays", "--mu", mu],
                               "expected": {"exit": 0, "count": rays, "cones": cones}})
        expected = {"exit": 0, "nothing_up_to": 1e6} if bracket is None else \
            {"exit": 0, "critical_friction": [rounded(bracket[0], ROUND_FLOOR), rounded(bracket[1], ROUND_CEILING)]}
        if bracket is not None and bracket[0] < 1000 or bracket is None:
            truths.append({"file": file, "command": ["critical"], "expected": expected})
            for words in more:
                truths.append({"file": file, "command": ["critical"] + [near if w == "near" else w for w in words], "expected": expected})
        print(file, "critical", expected, flush=True)
    for file, (words, codes, why) in REFUSED.items():
        truths.append({"file": file, "command": ["verify"] + words, "expected": {"exit": codes, "why": why}})
    truths.append({"file": "tjoint.toml", "command": ["patterns", "--mu", "1"],
                   "expected": {"says": "two meshes that touch at nodes which do not match: a warning or an error"}})
    with open(os.path.join(folder, "truth.json"), "w") as file:
        file.write('{"about": "by bench/hostile/truth.py, 80 digits; never copied from an output",\n "cases": [\n')
        file.write(",\n".join(json.dumps(truth) for truth in truths))
        file.write("\n]}\n")


if __name__ == "__main__":
    main()
