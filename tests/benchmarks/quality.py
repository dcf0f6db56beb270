#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Writes docs/quality.md and its pictures: how much of each shape a design keeps, for the default and the published method.

    tests/benchmarks/quality.py build/release/bin docs/quality.md docs/quality MESH...

Every mesh is designed 80 mm long with 1 degree of draft, at the plane that the program chooses.
"""
import json
import pathlib
import shutil
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
- **limbs**: length and volume of each, over the part's. Limbs are found on the part; corners of plates count as limbs too.

"""

TABLE = """| shape | method | castable | mean | largest | volume | filled | strain | stretch | rough | limbs: length, volume |
|---|---|---|---|---|---|---|---|---|---|---|
"""

PICTURES = """
## Pictures

The part at the default's plane, the default's cast and the published method's at its own plane, coloured by draft: red is
undercut, yellow below the draft asked for, blue above it.

| shape | part | default | published method |
|---|---|---|---|
"""

# Figures of which less is better, or nearer to 1.
CHANGES = {
    "mean": lambda d: d["change"]["mean_distance"],
    "largest": lambda d: d["change"]["max_distance"],
    "volume": lambda d: abs(d["change"]["volume_ratio"] - 1),
    "strain": lambda d: d["strain"]["rms"],
    "roughness": lambda d: abs(d["strain"]["roughness_ratio"] - 1),
    "shortest limb": lambda d: max((1 - limb["length_ratio"] for limb in d["limbs"]), default=0),
    "smallest limb": lambda d: max((1 - limb["volume_ratio"] for limb in d["limbs"]), default=0),
}
NOTICEABLE = 0.01  # of the diagonal, or of 1


def design(binaries, mesh, method, folder):
    command = [binaries / "moldwright-cli", "design", mesh, "--out", folder, "--size", "80", "--draft", "1",
               "--method", method, "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True)
    result = folder / "design.json"
    if not result.exists():
        return None, done.stderr.strip().splitlines()[-1] if done.stderr.strip() else "no result"
    return json.loads(result.read_text()), ""


def draw(binaries, mesh, d, picture, scale=1.0):
    """The mesh coloured by draft in the design's state; `scale`: mm of the design in a unit of the mesh."""
    plane = d["plane"][:3] + [d["plane"][3] / scale]
    order = {"task": "surface", "mesh": str(mesh), "plane": plane, "d1": d["d1"], "d2": d["d2"], "draft": 1,
             "out": str(picture), "width": 360, "height": 300}
    subprocess.run([binaries / "moldwright-render"], input=json.dumps(order), text=True, check=True)


def scale_of(binaries, mesh):
    check = subprocess.run([binaries / "moldwright-cli", "check", mesh, "--json", "-", "--quiet"],
                           capture_output=True, text=True)
    low, high = json.loads(check.stdout)["bbox"]
    return 80 / max(h - l for l, h in zip(low, high))


def verdict(d):
    if d["castable"]:
        return f"yes, {d['worst_draft_deg']:.1f}°"
    return f"no, {d['worst_draft_deg']:.1f}°, {100 * d['violating_area_fraction']:.2f} %"


def row(name, method, d):
    change, strain = d["change"], d["strain"]
    limbs = "; ".join(f"{limb['length_ratio']:.2f}, {limb['volume_ratio']:.2f}" for limb in d["limbs"]) or "–"
    return (f"| {name} | {method} | {verdict(d)} | {100 * change['mean_distance']:.2f} | "
            f"{100 * change['max_distance']:.1f} | {change['volume_ratio']:.3f} | "
            f"{change['filled_volume_fraction']:.3f} | {strain['rms']:.3f} | "
            f"{strain['stretch_p01']:.2f} to {strain['stretch_p99']:.2f} | {strain['roughness_ratio']:.2f} | {limbs} |\n")


def comparison(rows):
    """Where the published method changed less, and whether its result can be cast at all."""
    worse, lines = 0, []
    for name, results in rows:
        ours, paper = results["default"], results["paper"]
        if not ours or not paper:
            continue
        less = [f"{what} {of(paper):.3f} against {of(ours):.3f}" for what, of in CHANGES.items()
                if of(ours) > of(paper) + NOTICEABLE]
        if ours["castable"] < paper["castable"] or (paper["castable"] and less):
            worse += 1
        if less:
            lines.append(f"- {name} ({verdict(paper)}): {', '.join(less)}\n")
    castable = {method: sum(bool(r[method] and r[method]["castable"]) for _, r in rows)
                for method in ("default", "paper")}
    head = (f"\n## Beside the published method\n\nCastable: {castable['default']} of {len(rows)} by the default, "
            f"{castable['paper']} by the published method, which ends where it ends and is not finished. Shapes at which "
            f"the published method is castable and changes less: {worse}. ")
    if not lines:
        return head + "It changes nothing less noticeably.\n"
    return head + ("Where it changes less by a hundredth or more, it does so by leaving undercuts; in brackets how its "
                   "result stands:\n\n") + "".join(lines)


def main():
    binaries, page, pictures = (pathlib.Path(a) for a in sys.argv[1:4])
    pictures.mkdir(parents=True, exist_ok=True)
    lines, gallery, rows = [HEAD, TABLE], [PICTURES], []
    for mesh in (pathlib.Path(m) for m in sys.argv[4:]):
        name, results, cells = mesh.stem.replace("_", " "), {}, []
        # A sample and a model may share a name.
        stem = f"{mesh.stem}_{mesh.suffix[1:]}"
        for method in ("default", "paper"):
            with tempfile.TemporaryDirectory() as temporary:
                folder = pathlib.Path(temporary)
                results[method], why = design(binaries, mesh, method, folder)
                lines.append(row(name, method, results[method]) if results[method]
                             else f"| {name} | {method} | {why} | | | | | | | | |\n")
                print(lines[-1], end="", flush=True)
                if results[method]:
                    if method == "default":
                        draw(binaries, mesh, results[method], pictures / f"{stem}_part.png", scale_of(binaries, mesh))
                        cells.append(f"![]({pictures.name}/{stem}_part.png)")
                    draw(binaries, folder / "cast.ply", results[method], pictures / f"{stem}_{method}.png")
                    cells.append(f"![]({pictures.name}/{stem}_{method}.png)")
        rows.append((name, results))
        gallery.append(f"| {name} | {' | '.join(cells)} |\n")
    page.write_text("".join(lines) + comparison(rows) + "".join(gallery), encoding="utf-8")


main()
