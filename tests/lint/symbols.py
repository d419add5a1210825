"""Rule: our objects take nothing from libm but sqrt, floor, ceil, trunc and fabs.

The C library chooses FMA variants of sin, exp and their kin at run time, so that results would differ from machine to
machine; planner/core/math wraps functions that do not.
"""

import re
import subprocess
from pathlib import Path

import tree

ALLOWED = {"sqrt", "floor", "ceil", "trunc", "fabs"}


def libm_symbols(compiler="g++"):
    """The names that libm exports."""
    library = _run([compiler, "-print-file-name=libm.so.6"]).strip()
    return {line.split()[-1].split("@")[0] for line in _run(["nm", "-D", "--defined-only", library]).splitlines()}


def our_objects(root, build):
    """Objects of the build whose source is in one of our folders; generated code has none there."""
    objects = []
    for folder in tree.CODE_FOLDERS:
        for path in sorted((Path(build) / folder).rglob("*.o")):
            inside = re.fullmatch(r"(.*?)/?CMakeFiles/[^/]+\.dir/(.*)\.o", path.relative_to(build).as_posix())
            if inside and (Path(root) / inside[1] / inside[2]).is_file():
                objects.append(path)
    return objects


def check(root, build):
    objects = our_objects(root, build)
    if not objects:
        return [f"no object of ours below {build}: nothing was checked"]
    refused = libm_symbols() - ALLOWED
    if "sin" not in refused:
        return ["libm's symbols could not be read"]
    findings = []
    for path in objects:
        used = {line.split()[-1].split("@")[0] for line in _run(["nm", "-u", str(path)]).splitlines()}
        for name in sorted(used & refused):
            findings.append(f"{path.relative_to(build).as_posix()}: uses {name} of libm; use planner/core/math")
    return findings


def _run(command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout
