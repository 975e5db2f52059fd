#!/usr/bin/env python3
"""Plane-stress elements beside voussoir's arch and frame: writes CalculiX input, runs it, prints what the rows of
`voussoir verify elastic-frames` are compared with.

usage: plane_stress.py [elements across the thickness, ...]      needs CalculiX (Debian: calculix-ccx)
"""
import math
import subprocess
import sys
import tempfile
from pathlib import Path

YOUNG, POISSON, DENSITY, GRAVITY = 1e10, 0.2, 2400.0, 9.80


SHOE = 0.05  # m, below the feet of the frame: the middle of the held stones that turn there


class Mesh:
    """Quadrilaterals of eight nodes (CPS8) on patches of a grid, nodes merged by place."""

    def __init__(self):
        self.nodes, self.elements, self.index = [], [], {}

    def node(self, x, z):
        key = (round(x, 9), round(z, 9))
        if key not in self.index:
            self.index[key] = len(self.nodes) + 1
            self.nodes.append(key)
        return self.index[key]

    def patch(self, place, across, along):
        """place(u, v) of the unit square, right-handed"""
        def at(i, j):
            return self.node(*place(i / (2 * across), j / (2 * along)))
        for i in range(0, 2 * across, 2):
            for j in range(0, 2 * along, 2):
                self.elements.append([at(i, j), at(i + 2, j), at(i + 2, j + 2), at(i, j + 2),
                                      at(i + 1, j), at(i + 2, j + 1), at(i + 1, j + 2), at(i, j + 1)])

    def near(self, test):
        return [k + 1 for k, (x, z) in enumerate(self.nodes) if test(x, z)]


def arch(across, radius=5.0, thickness=0.8, opening=120.0):
    mesh = Mesh()
    half = math.radians(opening / 2)

    def place(u, v):
        r, angle = radius + (u - 0.5) * thickness, half * (2 * v - 1)
        return -r * math.sin(angle), r * math.cos(angle)
    mesh.patch(place, across, round(across * 2 * half * radius / thickness))

    def at_end(x, z):
        return abs(abs(math.atan2(x, z)) - half) < 1e-6
    crown = mesh.near(lambda x, z: abs(x) < 1e-9 and abs(z - radius) < 1e-6)
    return mesh, mesh.near(at_end), crown


def frame(across, span=5.0, height=4.0, width=0.8):
    """Axes: two posts of `height`, a beam of `span`. The feet turn freely about SHOE below them."""
    mesh = Mesh()
    h = 0.5 * width

    def box(left, right, low, high):
        mesh.patch(lambda u, v: (left + u * (right - left), low + v * (high - low)),
                   round(across * (right - left) / width), round(across * (high - low) / width))
    for side in (-0.5 * span, 0.5 * span):
        box(side - h, side + h, 0, height - h)
        box(side - h, side + h, height - h, height + h)
    box(-0.5 * span + h, 0.5 * span - h, height - h, height + h)
    middle = mesh.near(lambda x, z: abs(x) < 1e-9 and abs(z - height) < 1e-9)
    feet = [(mesh.near(lambda x, z, side=side: abs(z) < 1e-9 and x * side > 0), (0.5 * side * span, -SHOE))
            for side in (-1, 1)]
    return mesh, feet, middle


def run(name, mesh, held, point, modes=3):
    lines = ["*NODE, NSET=ALL"] + [f"{k}, {x:.12g}, {z:.12g}, 0" for k, (x, z) in enumerate(mesh.nodes, 1)]
    lines += ["*ELEMENT, TYPE=CPS8, ELSET=STONE"]
    lines += [", ".join(map(str, [k, *nodes])) for k, nodes in enumerate(mesh.elements, 1)]
    if isinstance(held[0], tuple):  # feet on hinges
        hinges = []
        for k, (foot, place) in enumerate(held):
            free, turning = len(mesh.nodes) + 2 * k + 1, len(mesh.nodes) + 2 * k + 2
            lines += ["*NODE"] + [f"{node}, {place[0]}, {place[1]}, 0" for node in (free, turning)]
            lines += [f"*NSET, NSET=FOOT{k}"] + [str(node) for node in foot]
            lines += [f"*RIGID BODY, NSET=FOOT{k}, REF NODE={free}, ROT NODE={turning}"]
            hinges.append(free)
        held = hinges
    lines += ["*NSET, NSET=HELD"] + [str(k) for k in held] + ["*NSET, NSET=POINT"] + [str(k) for k in point]
    lines += ["*MATERIAL, NAME=STONE", "*ELASTIC", f"{YOUNG}, {POISSON}", "*DENSITY", f"{DENSITY}",
              "*SOLID SECTION, ELSET=STONE, MATERIAL=STONE", "1", "*BOUNDARY", "HELD, 1, 2",
              "*STEP", "*STATIC", "*DLOAD", f"STONE, GRAV, {GRAVITY}, 1, 0, 0", "*NODE PRINT, NSET=POINT", "U",
              "*END STEP", "*STEP", "*STATIC", "*DLOAD, OP=NEW", f"STONE, GRAV, {GRAVITY}, 0, -1, 0",
              "*NODE PRINT, NSET=POINT", "U", "*END STEP", "*STEP", "*FREQUENCY", f"{modes}", "*END STEP"]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "job.inp").write_text("\n".join(lines) + "\n")
        subprocess.run(["ccx", "job"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        rows = [line.split() for line in Path(folder, "job.dat").read_text().splitlines()]
    moved = [list(map(float, row[1:3])) for row in rows if len(row) == 4 and row[0] == str(point[0])]
    frequencies = [float(row[3]) for row in rows if len(row) == 5 and row[0].isdigit()][:modes]
    print(f"{name}: {len(mesh.elements)} elements; aside {moved[0][0]:.6e} m under weight along x, "
          f"{-moved[1][1]:.6e} m down under its weight; " + ", ".join(f"{f:.4f}" for f in frequencies) + " Hz")


for across in map(int, sys.argv[1:] or ["2", "4", "8"]):
    run(f"arch,  {across} across", *arch(across))
    run(f"frame, {across} across", *frame(across))
