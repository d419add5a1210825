#!/usr/bin/env python3
"""What shared maps are worth: nine UAVs across the power station with and without them, seed by seed.

sharing.py --bin build/release/bin/skein [--runs 100] [--seed 0] [--set KEY=VALUE]
The radio is that of papers/004 (250 kbit/s, 90 m, a map every 2 s) and loses 10 %. The seed draws losses, starts west of
the wall and a common goal east of it. Prints the swarm's total distance both ways, the mean of the differences with its
95 % interval, the bytes sent beside those of the paper's whole matrix (2 bits a cell, every 2 s, from every UAV), and how
full the fullest slot was. Nothing here judges the figures.
"""

import argparse
import json
import math
import statistics
import subprocess
import sys

from fig5 import DRAW, SCENARIO

HEADER_BITS = 192


def sweep(arguments, share):
    command = [arguments.bin, "sweep", str(SCENARIO), "--json", "--runs", str(arguments.runs), "--seed",
               str(arguments.seed), "--set", "radio.loss=0.1", "--set", f"planner.share_maps={share}"]
    for item in DRAW + arguments.set:
        command += ["--set", item]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        sys.exit(f"{' '.join(command)}: {ended.stderr.strip()}")
    return {run["seed"]: run["figures"] for run in json.loads(ended.stdout)["rows"][0]["per_run"]}


def full_matrix_bytes(figures, cells, agents=9, period_s=2):
    """What the paper's exchange of whole matrices takes in a run of that many steps of 1 s."""
    return agents * math.ceil(figures["steps"] / period_s) * (2 * cells + HEADER_BITS) / 8


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--bin", required=True, help="the program skein")
    parser.add_argument("--runs", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--set", action="append", default=[])
    arguments = parser.parse_args()
    shared, alone = sweep(arguments, 1), sweep(arguments, 0)
    saved = [alone[seed]["total_path_m"] - shared[seed]["total_path_m"] for seed in shared]
    mean = statistics.mean(saved)
    half = 1.96 * statistics.stdev(saved) / math.sqrt(len(saved))
    cell_m = next((float(item.split("=")[1]) for item in arguments.set if item.startswith("planner.cell_m=")), 4.0)
    cells = math.floor(500 / cell_m) ** 2
    bytes_share = [(runs["radio.sent_bytes"] + HEADER_BITS / 8 * runs["radio.sent_samples"]) / full_matrix_bytes(runs, cells)
                   for runs in shared.values()]
    print(f"runs: {len(shared)}; arrived {sum(r['arrived'] for r in shared.values()):.0f} with maps, "
          f"{sum(r['arrived'] for r in alone.values()):.0f} without; collisions "
          f"{sum(r['collisions'] for r in [*shared.values(), *alone.values()]):.0f}")
    for name, runs in (("with shared maps", shared), ("without", alone)):
        print(f"{name}: total distance {statistics.mean(r['total_path_m'] for r in runs.values()):.0f} m")
    print(f"saved: {mean:.0f} m, 95 % interval [{mean - half:.0f}, {mean + half:.0f}]")
    print(f"bytes, of the whole matrix's: mean {statistics.mean(bytes_share):.3f}, most {max(bytes_share):.3f}")
    print(f"fullest slot: {max(r['radio.peak_slot_bits'] for r in shared.values()):.0f} of "
          f"{next(iter(shared.values()))['radio.slot_bits']:.0f} bits; samples over budget: "
          f"{sum(r['radio.over_budget'] for r in shared.values()):.0f}")


if __name__ == "__main__":
    main()
