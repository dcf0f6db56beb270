#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Writes docs/quality.md: how much of each shape a design keeps, for the default and the published method.

    tests/benchmarks/quality.py build/release/bin/moldwright-cli docs/quality.md MESH...

Every mesh is designed 80 mm long with 1 degree of draft, at the plane that the program chooses.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

HEAD = """# Quality: what a design keeps of the shape

Made by `tests/benchmarks/quality.py` from the program's own `design.json`: every shape 80 mm long, draft 1°, at the plane
that the program chooses; for each the default and, below it, the published method (`--method paper`).

- **castable**: proved on the coordinates as written; otherwise the worst angle left and the share of the area that misses
  the draft. A shape that stopped short of castable naturally changed less: compare rows that are both castable.
- **mean, largest**: distance between the surfaces after the best rigid fit, % of the diagonal. **volume**: over the
  part's. **filled**: share of the part's volume that filling added.
- **strain**: rms of the principal stretches of the surface less 1. **stretch**: their 1st and 99th percentile by area.
  **rough**: rms angle between neighbouring faces over that of the part.
  Long thin faces of made parts that the clean-up joined differently count as strained (xy joint).
- **limbs**: the smallest length and volume of any limb, over the part's. Limbs are found on the part; corners of plates
  count as limbs too.

| shape | method | castable | mean | largest | volume | filled | strain | stretch | rough | limbs |
|---|---|---|---|---|---|---|---|---|---|---|
"""


def design(cli, mesh, method, folder):
    command = [cli, "design", str(mesh), "--out", str(folder), "--size", "80", "--draft", "1",
               "--method", method, "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True)
    result = folder / "design.json"
    if not result.exists():
        return None, done.stderr.strip().splitlines()[-1] if done.stderr.strip() else "no result"
    return json.loads(result.read_text()), ""


def row(name, method, d):
    change, strain = d["change"], d["strain"]
    limbs = d["limbs"]
    if d["castable"]:
        verdict = f"yes, {d['worst_draft_deg']:.1f}°"
    else:
        verdict = f"no, {d['worst_draft_deg']:.1f}°, {100 * d['violating_area_fraction']:.2f} %"
    shortest = min((limb["length_ratio"] for limb in limbs), default=None)
    smallest = min((limb["volume_ratio"] for limb in limbs), default=None)
    kept = f"{shortest:.2f}, {smallest:.2f}" if limbs else "–"
    return (f"| {name} | {method} | {verdict} | {100 * change['mean_distance']:.2f} | "
            f"{100 * change['max_distance']:.1f} | {change['volume_ratio']:.3f} | "
            f"{change['filled_volume_fraction']:.3f} | {strain['rms']:.3f} | "
            f"{strain['stretch_p01']:.2f} to {strain['stretch_p99']:.2f} | {strain['roughness_ratio']:.2f} | {kept} |\n")


def main():
    cli, page, meshes = sys.argv[1], pathlib.Path(sys.argv[2]), [pathlib.Path(m) for m in sys.argv[3:]]
    lines = [HEAD]
    for mesh in meshes:
        for method in ("default", "paper"):
            with tempfile.TemporaryDirectory() as folder:
                result, why = design(cli, mesh, method, pathlib.Path(folder))
            shown = mesh.stem.replace("_", " ")
            lines.append(row(shown, method, result) if result
                         else f"| {shown} | {method} | {why} | | | | | | | | |\n")
            print(lines[-1], end="", flush=True)
    page.write_text("".join(lines), encoding="utf-8")


main()
