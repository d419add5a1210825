#!/usr/bin/env python3
"""Planning rounds a second of skein run beside those of plain Fast DDS, in one run.

compare.py --bin build/release/bin --bare build/release/tests/bare_fabric [--agents 3 6 12 25] [--seconds 3]
[--repeat 5] [--domain 19]. For each N the two take turns; the table has the medians and their ratio. The scenario is a
ring of N vehicles whose flight ends after one step; discovery, memory and bytes are of the last run of skein.
Exit code 1 if a run gives no figures. Nothing here judges them: figures depend on the machine.
"""

import argparse
import json
import math
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path


def ring(n, start_m=20000.0, slot_m=2000.0):
    """N vehicles on a ring, slots opposite, headings 1 rad off the centre."""
    lines = ["name: ring", "kind: rendezvous", "seed: 1", "length_unit_m: 1000", "step_s: 0.5", "arrival_radius_m: 50",
             "vehicles:", "  type: constant_speed", "  speed_mps: 50", "  max_curvature_per_m: 0.002", "  radius_m: 2",
             "  safety_radius_m: 50", "  on_agent_loss: remove", "  starts:"]
    at = [2.0 * math.pi * k / n for k in range(n)]
    for k in range(n):
        heading = math.remainder(at[k] + math.pi + 1.0, 2.0 * math.pi)
        lines.append(f"    - {{id: {k + 1}, x_m: {start_m * math.cos(at[k]):.3f}, y_m: {start_m * math.sin(at[k]):.3f},"
                     f" heading_rad: {heading:.6f}}}")
    lines += ["formation:", "  x_m: 0", "  y_m: 0", "  heading_rad: 0", "  slots:"]
    for k in range(n):
        lines.append(f"    - {{id: {k + 1}, x_m: {-slot_m * math.cos(at[k]):.3f}, y_m: {-slot_m * math.sin(at[k]):.3f}}}")
    return "\n".join(lines + ["planner:", "  name: dcpso", "  particles: 20", ""])


def figures(command):
    """The JSON object that the command prints, whatever its exit code: a flight of one step is no success."""
    ended = subprocess.run(command, capture_output=True, text=True, timeout=300)
    try:
        return json.loads(ended.stdout)
    except json.JSONDecodeError:
        sys.exit(f"{' '.join(command)}: {ended.stderr.strip() or 'no figures'}")


def compare(arguments, n, folder):
    scenario = Path(folder) / f"ring-{n}.yaml"
    scenario.write_text(ring(n), encoding="utf-8")
    generations = 50
    skein, bare = [], []
    for _ in range(arguments.repeat):
        report = figures([f"{arguments.bin}/skein", "run", str(scenario), "--json", "--out", f"{folder}/{n}",
                          "--domain", str(arguments.domain), "--set", f"planner.generations={generations}",
                          "--set", "world.max_steps=1"])
        if report.get("rounds_per_s") is None:
            sys.exit(f"N = {n}: {report.get('reason')}")
        plain = figures([arguments.bare, str(n), str(arguments.seconds), str(arguments.domain)])
        skein.append(report["rounds_per_s"])
        bare.append(plain["rounds_per_s"])
        generations = max(50, min(10000, int(report["rounds_per_s"] * arguments.seconds)))
    # the first round of skein was short, to find out how many generations fill the time
    skein = skein[1:] or skein
    bare = bare[1:] or bare
    ratios = [a / b for a, b in zip(skein, bare)]
    sent = sum(topic["bytes"] for topic in report["topics"].values()) / max(1, report["rounds"])
    print(f"| {n} | {statistics.median(skein):.0f} | {statistics.median(bare):.0f} | {statistics.median(ratios):.2f} "
          f"({min(ratios):.2f} to {max(ratios):.2f}) | {report['discovery_s']:.2f} | {report['pss_mb_per_agent']:.1f} "
          f"| {sent:.0f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--bin", required=True, help="folder of skein")
    parser.add_argument("--bare", required=True, help="the program bare_fabric")
    parser.add_argument("--agents", type=int, nargs="+", default=[3, 6, 12, 25])
    parser.add_argument("--seconds", type=float, default=3.0)
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--domain", type=int, default=19)
    arguments = parser.parse_args()
    print("| N | Skein, rounds/s | bare Fast DDS | ratio | discovery (s) | PSS/agent (MB) | bytes/round |")
    print("| --- | --- | --- | --- | --- | --- | --- |", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for n in arguments.agents:
            compare(arguments, n, folder)


if __name__ == "__main__":
    main()
