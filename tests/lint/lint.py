"""Checks the tree against the rules of the house: lint.py RULE --source DIR [--build DIR]. Prints each finding."""

import argparse
import sys
from pathlib import Path

import includes
import links
import sizes
import symbols
import texts

RULES = {
    "includes": lambda source, build: includes.check(source),
    "links": lambda source, build: links.check(links.read_graph(build / "lint" / "links.txt")),
    "sizes": lambda source, build: sizes.check(source),
    "symbols": symbols.check,
    "words": lambda source, build: texts.check_words(source),
    "folders": lambda source, build: texts.check_folders(source),
    "format": lambda source, build: texts.check_format(source),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rule", choices=RULES)
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--build", type=Path)
    arguments = parser.parse_args()
    findings = RULES[arguments.rule](arguments.source.resolve(), arguments.build)
    for finding in findings:
        print(finding)
    print(f"{arguments.rule}: {len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
