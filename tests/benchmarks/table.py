#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Turns the benchmarks' JSON into the table of README.md.

    moldwright-benchmarks --benchmark_out=bench.json --benchmark_out_format=json
    tests/benchmarks/table.py bench.json [MORE.json …]

Of several runs each benchmark's fastest counts.
"""
import json
import sys

# [Stein 2019], Table 1, seconds on a 2012 iMac: first directions, first ARAP step, whole optimisation.
PAPER = {
    "beam": ("beam", 464, 0.00926, 0.355, 5.3),
    "fish": ("dragon", 4290, 0.0117, 1.85, 26.2),
    "hand": ("hand", 7234, 0.0189, 41.3, 368),
    "rabbit": ("bunny", 14290, 0.0529, 2.62, 195),
}


def seconds(value):
    return f"{value:.2g} s" if value < 10 else f"{value:.0f} s"


def best(runs):
    """The fastest run of each benchmark and row."""
    fastest = {}
    for run in runs:
        if "label" not in run or "best_ms" not in run:
            continue  # an error, an aggregate, or not of a row
        key = (run["name"].split("/")[0], run["label"])
        if key not in fastest or run["best_ms"] < fastest[key]["best_ms"]:
            fastest[key] = run
    return fastest


def table(fastest):
    yield "| shape | surface vertices | first directions | first elastic step | shape to proved castable |"
    yield "|---|---|---|---|---|"
    for row, (paper_shape, vertices, directions, step, whole) in PAPER.items():
        ours = [fastest.get((name, row)) for name in ("firstDirections", "firstStep", "wholeDesign")]
        if None in ours:
            continue
        cells = [seconds(run["best_ms"] / 1e3) for run in ours]
        if not ours[2]["castable"]:
            cells[2] += " (not castable)"
        yield f"| {row} | {ours[0]['vertices']:.0f} | {' | '.join(cells)} |"
        paper = " | ".join(seconds(value) for value in (directions, step, whole))
        yield f"| *paper: {paper_shape}* | *{vertices}* | {paper} |"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    runs = []
    for name in sys.argv[1:]:
        with open(name, encoding="utf-8") as file:
            runs += json.load(file)["benchmarks"]
    print("\n".join(table(best(runs))))


if __name__ == "__main__":
    main()
