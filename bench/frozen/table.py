"""The committed table: one line for each call and kind of output, with a hash of its structure, a hash of its
words, and the number and the checksum of its numbers."""

from comparing import Summary

_HEADER = """\
# Outputs of the command, written by `python3 bench/frozen --renew`; README.md describes the columns.
# call\toutput\tstructure\twords\tnumbers\tchecksum
"""


def load(path):
    """{call: {output: summary}}"""
    rows = {}
    for line in path.read_text().splitlines():
        if line.startswith("#"):
            continue
        call, output, structure, words, count, checksum = line.split("\t")
        rows.setdefault(call, {})[output] = Summary(structure, words, int(count), float(checksum))
    return rows


def save(path, rows, order):
    """@param order names of all calls: rows of others are dropped"""
    with open(path, "w", encoding="utf-8") as file:
        file.write(_HEADER)
        for call in order:
            for output, row in sorted(rows.get(call, {}).items()):
                hashes = f"{row.structure}\t{row.words}"
                file.write(f"{call}\t{output}\t{hashes}\t{row.count}\t{row.checksum:.9f}\n")
