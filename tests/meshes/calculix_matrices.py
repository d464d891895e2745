#!/usr/bin/env python3
"""Stiffnesses of box-hex8.inp by CalculiX 2.20 (Debian's calculix-ccx), fixed at the bottom, E = 1, nu = 1/4.

    box-hex8-substructure.mtx   of the upper nodes of the group "right": *SUBSTRUCTURE GENERATE. Version 2.20 does not
                                condense: all other nodes are fixed
    box-hex8-stored.sti, .dof   whole and sparse: *FREQUENCY, SOLVER=MATRIXSTORAGE
"""
import pathlib
import shutil
import subprocess
import tempfile

HERE = pathlib.Path(__file__).parent


def sections(text):
    """The lines of each keyword, by the line of the keyword without blanks."""
    found, last = {}, None
    for line in text.splitlines():
        if line.startswith("*"):
            last = found.setdefault(line.replace(" ", "").upper(), [])
        elif last is not None:
            last.append(line)
    return found


def members(lines):
    return [name for line in lines for name in line.replace(" ", "").split(",") if name]


def run(deck, kept):
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "job.inp").write_text("\n".join(deck) + "\n")
        subprocess.run(["ccx", "job"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        for suffix, name in kept.items():
            shutil.copy(pathlib.Path(folder) / f"job{suffix}", HERE / name)


def main():
    mesh = sections((HERE / "box-hex8.inp").read_text())
    elements = {line.split(",")[0].strip(): members([line])[1:]
                for key, lines in mesh.items() if key.startswith("*ELEMENT,") for line in lines}
    nodes = {group: sorted({int(node) for element in members(mesh[f"*ELSET,ELSET={group}"])
                            for node in elements[element]}) for group in ("BOTTOM", "RIGHT")}
    body = ["*NODE", *mesh["*NODE"], "*ELEMENT, TYPE=C3D8, ELSET=BOX",
            *mesh["*ELEMENT,TYPE=C3D8,ELSET=VOLUME1"],
            "*MATERIAL, NAME=M", "*ELASTIC", "1., 0.25", "*DENSITY", "1.",
            "*SOLID SECTION, ELSET=BOX, MATERIAL=M",
            "*BOUNDARY", *(f"{node}, 1, 3" for node in nodes["BOTTOM"])]
    retained = [node for node in nodes["RIGHT"] if node not in nodes["BOTTOM"]]
    run([*body, "*STEP", "*SUBSTRUCTURE GENERATE", "*RETAINED NODAL DOFS, SORTED=NO",
         *(f"{node}, 1, 3" for node in retained),
         "*SUBSTRUCTURE MATRIX OUTPUT, STIFFNESS=YES, OUTPUT FILE=USER DEFINED, FILE NAME=job",
         "*END STEP"], {".mtx": "box-hex8-substructure.mtx"})
    run([*body, "*STEP", "*FREQUENCY, SOLVER=MATRIXSTORAGE", "1", "*END STEP"],
        {".sti": "box-hex8-stored.sti", ".dof": "box-hex8-stored.dof"})


if __name__ == "__main__":
    main()
