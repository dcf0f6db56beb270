#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Writes docs/choices.md and its pictures: what the designer's choices make of the bundled samples.

    tests/benchmarks/choices.py build/release/bin resources/samples docs/choices.md docs/choices
"""
import json
import pathlib
import subprocess
import sys
import tempfile

DRAFT = 1
HEAD = """# What the designer's choices do

Made by `tests/benchmarks/choices.py` from the bundled samples, as they are in the files, draft 1°. Coloured by draft: red is
undercut, yellow below the draft asked for, blue above it. **mean**: distance between the surfaces after the best rigid fit,
% of the diagonal; **strain**: rms of the principal stretches of the surface less 1; **filled**: % of the part's volume.

"""


class Studio:
    """Designs samples and draws what comes of it."""

    def __init__(self, binaries, samples, pictures):
        self.binaries, self.samples, self.pictures = binaries, samples, pictures
        self.scratch = tempfile.TemporaryDirectory()
        self.count = 0

    def sample(self, name):
        return self.samples / f"{name}.ply"

    def file(self, content):
        self.count += 1
        path = pathlib.Path(self.scratch.name) / f"{self.count}.json"
        path.write_text(json.dumps(content))
        return path

    def ask(self, *words):
        done = subprocess.run([self.binaries / "moldwright-cli", *map(str, words), "--json", "-", "--quiet"],
                              capture_output=True, text=True)
        return json.loads(done.stdout)

    def through_middle(self, name, normal):
        low, high = self.ask("check", self.sample(name))["bbox"]
        return [*normal, sum(n * (l + h) / 2 for n, l, h in zip(normal, low, high))]

    def suggested(self, name, count=40):
        return self.ask("pins", self.sample(name), "--count", count)["pins"]

    def design(self, name, *options):
        """The folder of results and what design.json says."""
        self.count += 1
        folder = pathlib.Path(self.scratch.name) / f"design-{self.count}"
        subprocess.run([self.binaries / "moldwright-cli", "design", self.sample(name), "--out", folder, "--quiet",
                        "--draft", str(DRAFT), *map(str, options)], check=False, capture_output=True)
        result = json.loads((folder / "design.json").read_text())
        print(name, *options[:1], result["castable"], flush=True)
        return folder, result

    def draw(self, mesh, picture, state=None, **look):
        order = {"task": "surface", "mesh": str(mesh), "out": str(self.pictures / f"{picture}.png"),
                 "width": 360, "height": 330, **look}
        if state:
            order |= {"plane": state["plane"], "d1": state["d1"], "d2": state["d2"], "draft": DRAFT}
        subprocess.run([self.binaries / "moldwright-render"], input=json.dumps(order), text=True, check=True)
        return f"![]({self.pictures.name}/{picture}.png)"


def table(heads, cells):
    return "".join(f"| {' | '.join(row)} |\n" for row in [heads, ["---"] * len(heads), *cells]) + "\n"


def numbers(d):
    castable = f"castable, {d['worst_draft_deg']:.1f}°" if d["castable"] else "not castable"
    change = d["change"]
    return (f"{castable}; mean {100 * change['mean_distance']:.2f}, strain {d['strain']['rms']:.3f}, "
            f"filled {100 * change['filled_volume_fraction']:.1f}")


def run_in_frames(studio):
    """[Stein 2019], Figure 7."""
    folder, _ = studio.design("rabbit", "--frames")
    frames = json.loads((folder / "frames" / "frames.json").read_text())["frames"]
    shown = [frames[round(i * (len(frames) - 1) / 4)] for i in range(5)]
    pictures = [studio.draw(folder / "frames" / frame["file"], f"frame-{i + 1}", frame)
                for i, frame in enumerate(shown)]
    words = [f"step {frame['step']}, {frame['stage']}: {100 * frame['violating_area_fraction']:.1f} % below the draft"
             for frame in shown]
    return "## A run\n\nThe rabbit on its way (`--frames`).\n\n" + table(pictures, [words])


def suggested_points(studio):
    """[Stein 2019], Figure 11."""
    names = ["rabbit", "goat", "hand", "goat_head"]
    pictures = [studio.draw(studio.sample(name), f"points-{name}", see_through=True,
                            suggested=[pin["point"] for pin in studio.suggested(name)]) for name in names]
    return ("## Points worth pinning\n\nForty points that `pins` suggests: ends of limbs, where limbs meet, and points along "
            "the body.\n\n" + table(pictures, [[name.replace("_", " ") for name in names]]))


def compare(studio, title, text, name, cases, see=None):
    """`cases`: label, options, pins. One column a case: the part as it is pinned, the cast, the numbers."""
    heads, parts, casts, figures = [], [], [], []
    for i, (label, options, pins) in enumerate(cases):
        if pins:
            options = [*options, "--pins", studio.file({"pins": [{"point": p} for p in pins]})]
        folder, d = studio.design(name, *options)
        look = {"from": see} if see else {}
        stem = f"{name}-{title.split()[0].lower()}-{i + 1}"
        heads.append(label)
        parts.append(studio.draw(studio.sample(name), f"{stem}-part", d, pins=pins, see_through=bool(pins), **look))
        casts.append(studio.draw(folder / "cast.ply", f"{stem}-cast", d, **look))
        figures.append(numbers(d))
    return f"## {title}\n\n{text}\n\n" + table(heads, [parts, casts, figures])


def upper_tips(studio, name, height):
    return [pin["point"] for pin in studio.suggested(name, 20) if pin["kind"] == "tip" and pin["point"][2] > height]


def painted_eye(studio):
    """[Stein 2019], Figure 12."""
    rows = []
    for weight in (1, 16):
        region = {"name": "eye", "centre": [10.5, -20, 46.99], "radius": 3.5, "weight": weight}
        folder, d = studio.design("goat_head", "--weights", studio.file({"regions": [region]}))
        eye = d["regions"][0]
        rows.append([f"weight {weight}", studio.draw(folder / "cast.ply", f"eye-{weight}", d),
                     f"{eye['strain_rms']:.3f}", f"{eye['max_distance']:.2f} mm", numbers(d)])
    return ("## An eye worth keeping\n\nThe front of the goat head's eye, plain and painted four times.\n\n" +
            table(["", "cast", "strain of the eye", "its largest change", "the whole"], rows))


def smoothed(studio):
    """[Stein 2019], Figure 9."""
    heads, casts, figures = [], [], []
    for gamma in (0, 0.1, 0.5):
        folder, d = studio.design("bent_beam", "--method", "paper", "--smoothing", gamma)
        heads.append(f"γ = {gamma}")
        casts.append(studio.draw(folder / "cast.ply", f"smoothing-{gamma}", d))
        figures.append(f"{100 * d['violating_area_fraction']:.2f} % below the draft, roughness {d['strain']['roughness_ratio']:.2f}")
    return ("## Neighbours that turn alike\n\nThe published method (`--method paper --smoothing γ`) on the bent beam; roughness is the "
            "rms angle between neighbouring faces over that of the part. The default has a membrane and a finish instead.\n\n" +
            table(heads, [casts, figures]))


def main():
    binaries, samples, page, pictures = (pathlib.Path(a) for a in sys.argv[1:5])
    pictures.mkdir(parents=True, exist_ok=True)
    studio = Studio(binaries, samples, pictures)
    across = lambda name, normal: ["--plane", *studio.through_middle(name, normal)]
    sections = [
        run_in_frames(studio),
        compare(studio, "Pins that keep ears upright", "The rabbit at one plane between its ears: left to bending, and with "
                "the ends of both ears pinned.", "rabbit",
                [("without pins", across("rabbit", [1, 0, 0]), []),
                 ("both ears pinned", across("rabbit", [1, 0, 0]), upper_tips(studio, "rabbit", 70))]),
        smoothed(studio),
        suggested_points(studio),
        painted_eye(studio),
        compare(studio, "Two planes of the hand", "Along the palm, and across it.", "hand",
                [("along the palm", across("hand", [0, 1, 0]), []), ("across the palm", across("hand", [1, 0, 0]), [])]),
        compare(studio, "Two cuts of the fish", "One through its back, one that lies.", "fish",
                [("upright", across("fish", [1, 0, 0]), []), ("lying", across("fish", [0, 0, 1]), [])]),
        compare(studio, "Two cuts of the rabbit", "From the side, and from the front with both ears pinned.", "rabbit",
                [("from the side", across("rabbit", [1, 0, 0]), []),
                 ("from the front", across("rabbit", [0, 1, 0]), upper_tips(studio, "rabbit", 70))]),
    ]
    page.write_text(HEAD + "".join(sections), encoding="utf-8")


main()
