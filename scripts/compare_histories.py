#!/usr/bin/env python3
"""How far the histories of runs are from those of a reference run.

usage: compare_histories.py REFERENCE.csv OTHER.csv ...   (histories.csv of runs of one case)

Displacements relative to the ground at the times all runs share; differences as shares of the reference's largest
change since the start of the motion.
"""
import csv
import math
import sys


def load(path):
    """Rows by time in whole microseconds; of several rows with one time (static steps) the last counts."""
    with open(path, encoding="utf-8") as file:
        return {round(float(row["time [s]"]) * 1e6): row for row in csv.DictReader(file)}


def relative(rows, times, column):
    ground = f"ground {column.split()[-2]} [m]"
    return [float(rows[t][column]) - float(rows[t].get(ground) or 0) for t in times]


def main(paths):
    if len(paths) < 2:
        sys.exit(__doc__)
    runs = [load(path) for path in paths]
    times = sorted(set.intersection(*(set(run) for run in runs)))
    columns = [name for name in runs[0][times[0]] if name.endswith("[m]") and not name.startswith("ground")]
    for column in columns:
        reference = relative(runs[0], times, column)
        peak = max(abs(x - reference[0]) for x in reference)
        print(f"{column}: largest change {1e3 * peak:.3f} mm, lowest {1e3 * min(reference):.3f} mm")
        for path, run in zip(paths[1:], runs[1:]):
            values = relative(run, times, column)
            gaps = [abs(a - b) for a, b in zip(values, reference)]
            rms = math.sqrt(sum(g * g for g in gaps) / len(gaps))
            share = peak or 1
            print(f"  {path}: worst {max(gaps) / share:.3f}, rms {rms / share:.3f}, lowest {1e3 * min(values):.3f} mm")


if __name__ == "__main__":
    main(sys.argv[1:])
