#!/usr/bin/env python3
"""Fig. 5 of papers/004 again: 3, 5, 7 and 9 UAVs across the power station, in cells of 2, 4 and 6 m, by each planner.

fig5.py --bin build/release/bin/skein [--seeds 10] [--seed 0] [--planner peach3d,peach3d-paper,peach] [--set KEY=VALUE]
        [--listed]
The seed draws losses, starts west of the wall and a common goal east of it, from cells that a path joins; with --listed
losses alone, and starts and goal are the scenario's. Prints a table by planner and cell: arrivals; and over the flights
in which all planners arrive, the median distance flown, its ratio to the shortest path with full knowledge, and
collisions. Nothing here judges the figures.
"""

import argparse
import json
import statistics
import subprocess
import sys
from pathlib import Path

SCENARIO = Path(__file__).resolve().parents[3] / "deploy/scenarios/transit-power-station.yaml"
DRAW = ["draw.from=connected", "draw.own_goals=0",
        "draw.starts={x_min_m: 0, y_min_m: 0, z_min_m: 0, x_max_m: 240, y_max_m: 500, z_max_m: 100}",
        "draw.goals={x_min_m: 270, y_min_m: 0, z_min_m: 0, x_max_m: 500, y_max_m: 500, z_max_m: 100}"]


def sweep(arguments, planner, cell, agents):
    """Per run, per vehicle: (arrived, metres flown, shortest path in metres); and collisions of all runs."""
    command = [arguments.bin, "sweep", str(SCENARIO), "--json", "--runs", str(arguments.seeds), "--seed",
               str(arguments.seed), "--set", f"planner.name={planner}", "--set", f"planner.cell_m={cell}", "--set",
               f"vehicles.agents={agents}"]
    for item in ([] if arguments.listed else DRAW) + arguments.set:
        command += ["--set", item]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    if ended.returncode != 0:
        sys.exit(f"{' '.join(command)}: {ended.stderr.strip()}")
    row = json.loads(ended.stdout)["rows"][0]
    flights, collisions = {}, 0
    for run in row["per_run"]:
        figures = run["figures"]
        collisions += figures["collisions"]
        for k in range(1, agents + 1):
            name = f"vehicles.{k}."
            flights[run["seed"], agents, k] = (name + "arrival_step" in figures, figures[name + "path_length_m"],
                                               figures.get(name + "shortest_path_m"))
    return flights, collisions


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--bin", required=True, help="the program skein")
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--planner", default="peach3d,peach3d-paper,peach")
    parser.add_argument("--set", action="append", default=["radio.loss=0.1"])
    parser.add_argument("--listed", action="store_true", help="starts and goal as in the scenario, not drawn")
    arguments = parser.parse_args()
    planners = arguments.planner.split(",")
    print("| cell (m) | planner | arrived | median, all arrive (m) | over the shortest | median of its arrivals (m) | "
          "collisions |\n| --- | --- | --- | --- | --- | --- | --- |", flush=True)
    pooled = {planner: [] for planner in planners}
    for cell in (2, 4, 6):
        flown, hits = {}, {}
        for planner in planners:
            flown[planner], hits[planner] = {}, 0
            for agents in (3, 5, 7, 9):
                flights, collisions = sweep(arguments, planner, cell, agents)
                flown[planner] |= flights
                hits[planner] += collisions
        common = [key for key in flown[planners[0]] if all(flown[planner][key][0] for planner in planners)]
        for planner in planners:
            flights = flown[planner]
            arrived = [metres for there, metres, _ in flights.values() if there]
            together = [flights[key][1] for key in common]
            ratios = [flights[key][1] / flights[key][2] for key in common]
            pooled[planner] += together
            median = f"{statistics.median(together):.0f} of {len(common)} | {statistics.median(ratios):.2f}" \
                if common else "- | -"
            print(f"| {cell} | {planner} | {len(arrived)} of {len(flights)} | {median} | "
                  f"{statistics.median(arrived):.0f} | {hits[planner]} |", flush=True)
    for planner in planners:
        print(f"| all | {planner} | | {statistics.median(pooled[planner]):.0f} of {len(pooled[planner])} | | | |")


if __name__ == "__main__":
    main()
