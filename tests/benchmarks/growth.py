#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Measures how the time from file to proved castable grows with the part, and draws it.

    tests/benchmarks/growth.py build/release/bin docs/growth.svg docs/growth.md MESH...

Every mesh is subdivided and roughened to each of the sizes (moldwright-large-part), then designed 80 mm long with 1 degree
of draft, nothing filled, files and mold written. The page has the numbers, the picture the curves.
"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

VERTICES = [3000, 10000, 30000, 100000]
COLOURS = ["#1f6fb2", "#b2561f", "#3a8f4d", "#8a4fae", "#777777"]

HEAD = """# How time grows with the part

Made by `tests/benchmarks/growth.py`: parts subdivided and roughened to each size, then `design --size 80 --draft 1 --fill
none --mold`, from file to proved castable with both halves written; wall-clock seconds of the whole command.

![Time against vertices](growth.svg)

| part | faces | castable | seconds | µs a face | MB | plane | tetrahedra | bending | finish and proof | mold |
|---|---|---|---|---|---|---|---|---|---|---|
"""


def measure(binaries, mesh, faces, folder):
    part = folder / f"{mesh.stem}.ply"
    subprocess.run([binaries / "moldwright-large-part", mesh, part, str(faces)], check=True, stdout=subprocess.DEVNULL)
    out = folder / "out"
    start = time.monotonic()
    process = subprocess.Popen([binaries / "moldwright-cli", "design", part, "--out", out, "--size", "80", "--draft", "1",
                                "--fill", "none", "--mold", "--quiet"], stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.monotonic() - start
    design = json.loads((out / "design.json").read_text())
    return {"faces": design["input"]["faces"], "vertices": design["input"]["vertices"], "seconds": seconds,
            "castable": os.waitstatus_to_exitcode(status) == 0, "megabytes": usage.ru_maxrss / 1024,
            "stages": json.loads((out / "timings.json").read_text())}


def row(name, m):
    stages = [m["stages"].get(key, 0) for key in ("plane", "tetrahedralize", "elastoplastic", "postprocess", "mold")]
    return (f"| {name} | {m['faces']} | {'yes' if m['castable'] else 'no'} | {m['seconds']:.1f} | "
            f"{1e6 * m['seconds'] / m['faces']:.0f} | {m['megabytes']:.0f} | "
            + " | ".join(f"{s:.1f}" for s in stages) + " |\n")


def plot(curves):
    """Seconds against vertices, both axes logarithmic; a grey line shows linear growth."""
    width, height, left, bottom, top, right = 640, 400, 70, 50, 20, 120
    xs = [p["vertices"] for points in curves.values() for p in points]
    ys = [p["seconds"] for points in curves.values() for p in points]
    low_x, high_x = math.log10(min(xs)), math.log10(max(xs))
    low_y, high_y = math.floor(math.log10(min(ys))), math.ceil(math.log10(max(ys)))

    def at(x, y):
        return (left + (math.log10(x) - low_x) / (high_x - low_x) * (width - left - right),
                height - bottom - (math.log10(y) - low_y) / (high_y - low_y) * (height - bottom - top))

    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
             'font-family="sans-serif" font-size="12">', '<rect width="100%" height="100%" fill="white"/>']
    for power in range(low_y, high_y + 1):
        _, y = at(min(xs), 10 ** power)
        lines.append(f'<path d="M{left} {y:.1f}H{width - right}" stroke="#ddd"/>'
                     f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{10.0 ** power:g} s</text>')
    for count in VERTICES:
        x, _ = at(count, 1)
        lines.append(f'<path d="M{x:.1f} {top}V{height - bottom}" stroke="#eee"/>'
                     f'<text x="{x:.1f}" y="{height - bottom + 18}" text-anchor="middle">{count:,}</text>')
    lines.append(f'<text x="{(left + width - right) / 2}" y="{height - 10}" text-anchor="middle">vertices</text>')
    first = next(iter(curves.values()))
    start, ratio = first[0], first[-1]["vertices"] / first[0]["vertices"]
    ends = [at(start["vertices"], start["seconds"]), at(start["vertices"] * ratio, start["seconds"] * ratio)]
    lines.append('<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="#aaa" stroke-dasharray="5 4"/>'.format(*ends[0], *ends[1])
                 + f'<text x="{ends[1][0] + 8:.1f}" y="{ends[1][1] + 4:.1f}" fill="#888">linear</text>')
    for colour, (name, points) in zip(COLOURS, curves.items()):
        places = [at(p["vertices"], p["seconds"]) for p in points]
        lines.append(f'<path d="M{"L".join(f"{x:.1f} {y:.1f}" for x, y in places)}" fill="none" stroke="{colour}" '
                     'stroke-width="2"/>')
        lines += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>' for x, y in places]
    for i, (colour, name) in enumerate(zip(COLOURS, curves)):
        y = top + 16 * (i + 1)
        lines.append(f'<circle cx="{left + 16}" cy="{y - 4}" r="4" fill="{colour}"/>'
                     f'<text x="{left + 26}" y="{y}">{name}</text>')
    return "\n".join(lines + ["</svg>", ""])


def main():
    binaries, picture, page = (pathlib.Path(a) for a in sys.argv[1:4])
    curves, rows = {}, []
    for mesh in map(pathlib.Path, sys.argv[4:]):
        name = mesh.stem.replace("_", " ")
        for vertices in VERTICES:
            with tempfile.TemporaryDirectory() as folder:
                measured = measure(binaries, mesh, 2 * vertices, pathlib.Path(folder))
            curves.setdefault(name, []).append(measured)
            rows.append(row(name, measured))
            print(rows[-1], end="", flush=True)
    picture.write_text(plot(curves), encoding="utf-8")
    page.write_text(HEAD + "".join(rows), encoding="utf-8")


main()
