"""Software bill of materials: valid SPDX references, and every library of the command.

    python3 sbom_test.py BILL KUSABI
"""
import json
import pathlib
import re
import subprocess
import sys

#: Parts of names of libraries that the compiler, the system or another library brings.
SYSTEM = re.compile(r"lib(c|m|stdc\+\+|gcc_s|pthread|dl|rt|util|open-rte|open-pal|hwloc|event|udev|cap|nl|psm|ucx|fabric|"
                    r"pmix|mpich|mpi|amd|colamd|suitesparseconfig|ltdl|gomp|quadmath|asan|ubsan|z)[\d.-]*\.so|linux-vdso|ld-linux")
NAMES = {"boost_serialization": "Boost", "fmt": "fmt", "glpk": "GLPK", "cholmod": "CHOLMOD", "blas": "BLAS", "openblas": "BLAS", "qd": "QD", "gmp": "GMP", "gmpxx": "GMP", "mpfr": "MPFR",
         "tomlplusplus": "toml++"}

bill = json.loads(pathlib.Path(sys.argv[1]).read_text())
ids = {package["SPDXID"] for package in bill["packages"]} | {bill["SPDXID"]}
assert len(ids) == len(bill["packages"]) + 1, "identifiers repeat"
for relation in bill["relationships"]:
    assert relation["spdxElementId"] in ids and relation["relatedSpdxElement"] in ids, relation
known = {package["name"] for package in bill["packages"]}
linked = subprocess.run(["readelf", "-d", sys.argv[2]], capture_output=True, text=True, check=True).stdout
for library in re.findall(r"\(NEEDED\).*\[(.*?)\]", linked):
    name = re.match(r"(?:lib)?([\w+-]*)", library)[1]
    assert SYSTEM.search(library) or NAMES.get(name) in known, f"{library} is not in the bill of materials"
