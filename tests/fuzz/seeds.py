"""The first inputs of the fuzz targets.

usage: seeds.py FOLDER JOURNAL     JOURNAL: of a world, with the rounds of a run
       FOLDER gets wire_fuzz, scenario_fuzz and round_record_fuzz, with files to mutate
"""

import shutil
import struct
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GOLDEN = ("mission", "tick", "sense", "beacon", "representative", "obstacle_map", "command", "inject")  # as wire_fuzz numbers the topics
ROUND = 2  # kind of a record, simworld/checkpoint/checkpoint.cpp
HEAD = struct.Struct("<4sIQQQ")  # of a record, simworld/checkpoint/journal.cpp: mark, kind, length, two sums


def rounds(journal):
    """The contents of the records of rounds."""
    place = 0
    while place < len(journal):
        _, kind, length, _, _ = HEAD.unpack_from(journal, place)
        place += HEAD.size + length
        if kind == ROUND:
            yield journal[place - length:place]


def main():
    folder, journal = Path(sys.argv[1]), Path(sys.argv[2]).read_bytes()
    for target in ("wire_fuzz", "scenario_fuzz", "round_record_fuzz"):
        (folder / target).mkdir()
    for topic, name in enumerate(GOLDEN):
        sample = bytes.fromhex((ROOT / f"tests/idl/convert/golden/{name}.hex").read_text(encoding="ascii"))
        (folder / "wire_fuzz" / name).write_bytes(bytes([topic]) + sample)
    for pattern in ("deploy/scenarios/*.yaml", "tests/data/*.yaml", "tests/data/broken/*.yaml"):
        for scenario in ROOT.glob(pattern):
            shutil.copy(scenario, folder / "scenario_fuzz")
    for number, content in enumerate(list(rounds(journal))[::100]):
        (folder / "round_record_fuzz" / str(number)).write_bytes(content)


if __name__ == "__main__":
    main()
