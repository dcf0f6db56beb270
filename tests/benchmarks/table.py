#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Writes the tables of pages anew from the benchmarks' JSON.

    moldwright-benchmarks --benchmark_out=bench.json --benchmark_out_format=json
    tests/benchmarks/table.py README.md docs/performance.md -- bench.json [MORE.json …]

In a page a table stands between <!-- table: NAME --> and <!-- end -->; NAME is paper, stages, whole, molds,
features or drag. Of several runs each benchmark's fastest counts; a page whose benchmarks are missing is left as it is.
"""
import json
import pathlib
import re
import sys

ROWS = ("beam", "fish", "hand", "rabbit")

# [Stein 2019], Table 1, seconds on a 2012 iMac: first directions, first ARAP step, whole optimisation.
PAPER = {
    "beam": ("beam", 464, 0.00926, 0.355, 5.3),
    "fish": ("dragon", 4290, 0.0117, 1.85, 26.2),
    "hand": ("hand", 7234, 0.0189, 41.3, 368),
    "rabbit": ("bunny", 14290, 0.0529, 2.62, 195),
}

# What a row of the table of stages says: words, benchmark, counter, factor.
STAGES = [
    ("tetrahedra", "localGlobalIteration", "tets", 1),
    ("local-global iteration, ms", "localGlobalIteration", "best_ms", 1),
    ("– its bound in memory, ms", "localGlobalIteration", "bound_ms", 1),
    ("– ratio", "localGlobalIteration", "ratio", 1),
    ("– over a plain one (JacobiSVD, Eigen's LDLT, nothing enforced)", "localGlobalBesidePlain", "ratio", 1),
    ("one factorisation, ms", "factorisation", "best_ms", 1),
    ("– over Eigen's LDLT", "factorisation", "ratio", 1),
    ("plastic restart, ms", "plasticRestart", "best_ms", 1),
    ("– over one factorisation by CHOLMOD, METIS, OpenBLAS", "plasticRestart", "ratio", 1),
    ("1000 planes in vector code, ns a face and plane", "thousandPlanes", "ns_per_face", 1),
    ("– over the plain energy", "thousandPlanes", "ratio", 1),
    ("best directions, ms", "firstDirections", "best_ms", 1),
    ("plane search, 6 planes, ms", "planeSearch", "best_ms", 1),
    ("filling all undercuts at the centre, ms", "fillAll", "best_ms", 1),
    ("the same with drafted walls, ms", "fillDrafted", "best_ms", 1),
    ("TetGen of the whole part with worker and check, ms", "tetGen", "best_ms", 1),
    ("suggested pins, ms", "suggestedPins", "best_ms", 1),
    ("exact certificate of the cast, ms", "certificateAndMold", "certificate_ms", 1),
    ("both mold halves, built and proved, ms", "certificateAndMold", "best_ms", 1),
    ("a changed draft in a run stands it still, ms", "changedDraft", "longest_ms", 1),
    ("a changed plane, ms", "changedPlane", "longest_ms", 1),
    ("changed pins, ms", "changedPins", "longest_ms", 1),
]

WHOLE = [
    ("best planes, their topological certificates, parting line, s", "plane_s", 1),
    ("stand-in and TetGen, s", "tetrahedralize_s", 1),
    ("bending, s", "elastoplastic_s", 1),
    ("finish, rounding, proof, measures, s", "postprocess_s", 1),
    ("whole, s", "best_ms", 1e-3),
    ("proved draft, degrees (1 asked for)", "worst_draft_deg", 1),
    ("mean change, % of the diagonal", "mean_change_percent", 1),
]


def figure(value):
    """Two digits that count; whole numbers from a hundred on."""
    if value >= 100:
        return f"{value:,.0f}"
    return f"{value:.2g}" if value < 10 else f"{value:.0f}"


def seconds(value):
    return f"{figure(1e3 * value)} ms" if value < 0.1 else f"{value:.2g} s" if value < 10 else f"{value:.0f} s"


def best(runs):
    """The fastest run of each benchmark and row, or of each benchmark with its arguments."""
    fastest = {}
    for run in runs:
        if run.get("error_occurred") or run.get("run_type") == "aggregate":
            continue
        name = run["name"].split("/")[0]
        arguments = tuple(int(text.split(":")[1]) for text in run["name"].split("/")[1:]
                          if re.fullmatch(r"\w+:\d+", text) and not text.startswith("iterations"))
        key = (name, run["label"]) if len(arguments) == 1 and run.get("label") else (name, *arguments)
        if key not in fastest or run["real_time"] < fastest[key]["real_time"]:
            fastest[key] = run
    return fastest


def paper(fastest):
    yield "| shape | surface vertices | first directions | first elastic step | shape to proved castable |"
    yield "|---|---|---|---|---|"
    for row, (shape, vertices, directions, step, whole) in PAPER.items():
        ours = [fastest[name, row] for name in ("firstDirections", "firstStep", "wholeDesign")]
        cells = [seconds(run["best_ms"] / 1e3) for run in ours]
        if not ours[2]["castable"]:
            cells[2] += " (not castable)"
        yield f"| {row} | {ours[0]['vertices']:.0f} | {' | '.join(cells)} |"
        theirs = " | ".join(seconds(value) for value in (directions, step, whole))
        yield f"| *paper: {shape}* | *{vertices}* | {theirs} |"


def by_row(fastest, lines):
    """One column for each row of the paper's table, one line for each (words, benchmark, counter, factor)."""
    counts = [fastest["localGlobalIteration", row]["vertices"] for row in ROWS]
    yield "| | " + " | ".join(f"{row} {count:,.0f}" for row, count in zip(ROWS, counts)) + " |"
    yield "|---" * (len(ROWS) + 1) + "|"
    for words, benchmark, counter, factor in lines:
        values = [fastest[benchmark, row].get(counter) for row in ROWS]
        yield f"| {words} | " + " | ".join("–" if v is None else figure(v * factor) for v in values) + " |"


def stages(fastest):
    return by_row(fastest, STAGES)


def whole(fastest):
    return by_row(fastest, [(words, "wholeDesign", counter, factor) for words, counter, factor in WHOLE])


def arguments_of(fastest, name):
    return sorted((key[1:], run) for key, run in fastest.items() if key[0] == name)


def molds(fastest):
    yield "| faces a cavity | cavities | ours, ms | CGAL's corefinement, ms | times faster |"
    yield "|---|---|---|---|---|"
    for (faces, side), run in arguments_of(fastest, "moldHalves"):
        peer = [run.get("corefinement_ms"), run.get("times_faster")]
        cells = ["not run: minutes" if value is None else figure(value) for value in peer]
        yield f"| {faces:,} | {side * side} | {figure(run['best_ms'])} | {' | '.join(cells)} |"


def features(fastest):
    yield "| faces | cavities | built and proved, ms | over the search for self-intersections alone | written, ms |"
    yield "|---|---|---|---|---|"
    for _, run in arguments_of(fastest, "moldWithEverything"):
        yield (f"| {run['faces']:,.0f} | {run['cavities']:.0f} | {figure(run['best_ms'])} | "
               f"{figure(run['over_check'])} | {figure(run['written_ms'])} |")


def drag(fastest):
    yield "| faces a cavity | cavities | dragged | best, ms | worst, ms | updates a second, at least | made ready, ms |"
    yield "|---|---|---|---|---|---|---|"
    for (_, _, key), run in arguments_of(fastest, "liveDrag"):
        yield (f"| {run['faces']:,.0f} | {run['cavities']:.0f} | {'key' if key else 'spout'} | {figure(run['best_ms'])} | "
               f"{figure(run['worst_ms'])} | {figure(run['updates_per_s'])} | {figure(run['prepared_ms'])} |")


TABLES = {make.__name__: make for make in (paper, stages, whole, molds, features, drag)}


def renewed(page, fastest):
    """The page with the tables between its marks made anew."""
    def table(mark):
        return mark.group(1) + "".join(line + "\n" for line in TABLES[mark.group(2)](fastest)) + mark.group(3)

    return re.sub(r"(<!-- table: (\w+) -->\n).*?(<!-- end -->)", table, page, flags=re.DOTALL)


def main():
    if "--" not in sys.argv:
        sys.exit(__doc__)
    split = sys.argv.index("--")
    runs = []
    for name in sys.argv[split + 1:]:
        with open(name, encoding="utf-8") as file:
            runs += json.load(file)["benchmarks"]
    fastest = best(runs)
    for page in map(pathlib.Path, sys.argv[1:split]):
        try:
            page.write_text(renewed(page.read_text(encoding="utf-8"), fastest), encoding="utf-8")
        except KeyError as missing:
            print(f"{page} is left as it is: no result of {missing}", file=sys.stderr)


if __name__ == "__main__":
    main()
