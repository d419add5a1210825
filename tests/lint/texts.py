"""Rules about texts: no forbidden word, no undeclared top-level folder, clang-format's layout."""

import re
import shutil
import subprocess
from pathlib import Path

import tree

# Each in two parts, so that this file does not contain what it looks for.
_ANYWHERE = re.compile("|".join(a + b for a, b in (("TO", "DO"), ("FIX", "ME"), ("DISABL", "ED_"), ("GTEST_", "SKIP"))))
_IN_TESTS = re.compile("|".join((
    "sleep" + "_for", "sleep" + "_until", r"\bu?sleep" + r"\(", "nano" + "sleep", r"time\.sl" + "eep",
    r"^\s*sleep" + r" [0-9]")))
_TEXT_SUFFIXES = (".cpp", ".hpp", ".idl", ".py", ".sh", ".cmake", ".txt", ".yaml", ".md")
# The build, and what runs and editors leave behind, is in .gitignore; these are not.
_ALWAYS_IGNORED = {".git"}


def check_words(root):
    findings = []
    for path in tree.files(root, suffixes=_TEXT_SUFFIXES):
        name = tree.name(root, path)
        for number, line in enumerate(tree.read(path).splitlines(), 1):
            match = _ANYWHERE.search(line) or (name.startswith("tests/") and _IN_TESTS.search(line))
            if match:
                findings.append(f"{name}:{number}: '{match.group(0).strip()}' is not allowed")
    return findings


def check_folders(root):
    """Every folder at the top is declared, ignored, or .ci."""
    root = Path(root)
    ignore = root / ".gitignore"
    ignored = {line.strip().strip("/") for line in tree.read(ignore).splitlines()} if ignore.is_file() else set()
    allowed = set(tree.FOLDERS) | {".ci"} | ignored | _ALWAYS_IGNORED
    return [f"{path.name}: the top level has no such folder; allowed: {', '.join(tree.FOLDERS)}"
            for path in sorted(root.iterdir()) if path.is_dir() and path.name not in allowed]


def check_format(root):
    tool = shutil.which("clang-format-14") or shutil.which("clang-format")
    if tool is None:
        return ["clang-format-14 is not installed"]
    version = subprocess.run([tool, "--version"], check=True, capture_output=True, text=True).stdout
    if " 14." not in version:
        return [f"{tool} is not version 14, whose layout is ours: {version.strip()}"]
    paths = [str(path) for path in tree.files(root, suffixes=(".cpp", ".hpp"))]
    if not paths:
        return ["no source file was found"]
    style = "--style=file:" + str(Path(root) / ".clang-format")
    result = subprocess.run([tool, "--dry-run", "-Werror", style, *paths], capture_output=True, text=True, check=False)
    return [line for line in result.stderr.splitlines() if ": error: " in line]
