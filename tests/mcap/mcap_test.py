"""A recording is read by the MCAP project's own library, and every field that it decodes is what was sent.

usage: mcap_test.py --bin FOLDER --source FOLDER --work FOLDER
  The npm packages are installed into the work folder as package-lock.json names them, once, from npm's cache if they
  are there.
"""

import argparse
import filecmp
import json
import os
import shutil
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
TOPICS = {"small.yaml": {"beacon", "mission", "representative", "sense", "tick"},
          "small-transit.yaml": {"beacon", "mission", "obstacle_map", "sense", "tick"}}


def call(*command, cwd=None, out=None):
    done = subprocess.run(command, cwd=cwd, stdout=out or subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)}: exit code {done.returncode}: {done.stdout or ''}{done.stderr}")
    return done.stdout


def install(work):
    """The packages of the lock file, unless they are there already."""
    os.makedirs(work, exist_ok=True)
    names = ("package.json", "package-lock.json", "compare.mjs")
    kept = os.path.join(work, "installed-lock.json")
    for name in names:
        shutil.copy(os.path.join(HERE, name), work)
    if os.path.exists(kept) and filecmp.cmp(kept, os.path.join(HERE, "package-lock.json"), shallow=False):
        return
    call("npm", "ci", "--prefer-offline", "--no-audit", "--no-fund", "--ignore-scripts", cwd=work)
    shutil.copy(os.path.join(HERE, "package-lock.json"), kept)


class ReadByOthers(unittest.TestCase):
    arguments = None

    def setUp(self):
        self.work = os.path.abspath(self.arguments.work)
        self.skein = os.path.join(os.path.abspath(self.arguments.bin), "skein")
        install(self.work)

    def recorded(self, scenario, *more):
        """Records a run. @return the file and Skein's own dump of it"""
        file, dump, out = (os.path.join(self.work, scenario + ending) for ending in (".mcap", ".jsonl", ".out"))
        path = os.path.join(self.arguments.source, "tests", "data", scenario)
        call(self.skein, "run", path, "--in-process", "--record", file, "--out", out, *more)
        with open(dump, "w", encoding="utf-8") as lines:
            call(self.skein, "dump", file, out=lines)
        return file, dump

    def test_every_field_is_what_was_sent(self):
        for scenario, topics in TOPICS.items():
            with self.subTest(scenario):
                file, dump = self.recorded(scenario)
                found = json.loads(call("node", "compare.mjs", file, dump, cwd=self.work))
                self.assertEqual(set(found["topics"]), {"skein/" + topic for topic in topics})
                self.assertGreater(found["messages"], 100)
                self.assertEqual(found["attachments"], ["scenario.yaml", "report.json"])
                self.assertEqual(found["metadata"], ["skein", "skein.scenario", "skein.run", "skein.kept"])

    def test_another_value_is_found(self):
        file, dump = self.recorded("small.yaml")
        with open(dump, encoding="utf-8") as lines:
            samples = [json.loads(line) for line in lines]
        beacon = next(sample for sample in samples if sample["topic"] == "skein/beacon" and sample["sample"]["round"] > 5)
        beacon["sample"]["own"]["position_m"]["x"] += 1e-9
        with open(dump, "w", encoding="utf-8") as lines:
            lines.writelines(json.dumps(sample) + "\n" for sample in samples)
        with self.assertRaisesRegex(AssertionError, r"own\.position_m\.x"):
            call("node", "compare.mjs", file, dump, cwd=self.work)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for option in ("--bin", "--source", "--work"):
        parser.add_argument(option, required=True)
    ReadByOthers.arguments, rest = parser.parse_known_args()
    unittest.main(argv=sys.argv[:1] + rest)
