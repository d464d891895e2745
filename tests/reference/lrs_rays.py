# Writes lrs_rays.json: all extremal rays of C_r that satisfy the complementarity condition, for
# compliances with integer entries, by lrs 7.1 in exact arithmetic (all rays, then filtered).
#
#   python3 lrs_rays.py > lrs_rays.json
import json
import random
import subprocess
from fractions import Fraction


def case(seed, m, mu):
    bits = random.Random(seed)
    half = [[bits.randint(-4, 4) for _ in range(2 * m)] for _ in range(2 * m)]
    compliance = [[sum(a * b for a, b in zip(u, v)) + (3 if u is v else 0) for v in half] for u in half]
    rows = []
    for k in range(2 * m):
        rows.append([1 if j == k else 0 for j in range(2 * m)])
    for i in range(m):
        row = []
        for k in range(m):
            by_normal = Fraction(compliance[2 * i][2 * k]) / (2 * mu)
            by_tangential = Fraction(compliance[2 * i][2 * k + 1], 2)
            row += [by_normal - by_tangential, by_normal + by_tangential]
        rows.append(row)
    text = f"cone\nH-representation\nbegin\n{3 * m} {2 * m + 1} rational\n"
    for row in rows:
        text += " ".join(["0"] + [str(entry) for entry in row]) + "\n"
    out = subprocess.run(["lrs"], input=text + "end\n", capture_output=True, text=True).stdout
    rays = []
    for line in out.splitlines():
        words = line.split()
        if len(words) != 2 * m + 1 or words[0] != "0":
            continue
        x = [Fraction(word) for word in words[1:]]
        gaps = [sum(a * b for a, b in zip(row, x)) for row in rows[2 * m:]]
        if all(gaps[i] == 0 or x[2 * i] + x[2 * i + 1] == 0 for i in range(m)):
            total = sum(x) / (2 * mu)
            ray = []
            for i in range(m):
                ray += [(x[2 * i] + x[2 * i + 1]) / (2 * mu) / total, (x[2 * i + 1] - x[2 * i]) / 2 / total]
            rays.append([float(entry) for entry in ray])
    return {"compliance": compliance, "friction": float(mu), "rays": sorted(rays)}


cases = [case(1, 3, Fraction(4)), case(2, 4, Fraction(2)), case(3, 5, Fraction(3)), case(4, 6, Fraction(5, 4))]
print("[\n" + ",\n".join(json.dumps(each) for each in cases) + "\n]")
