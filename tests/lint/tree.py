"""The source tree as the lint rules see it: our folders, our files, their text without comments and literals."""

import re
from pathlib import Path

FOLDERS = ("agent", "deploy", "docs", "groundstation", "idl", "planner", "simworld", "tests")
CODE_FOLDERS = ("agent", "groundstation", "idl", "planner", "simworld")
SOURCE_SUFFIXES = (".cpp", ".hpp", ".idl")

_COMMENT_OR_LITERAL = re.compile(
    r'//(?:\\\n|[^\n])*'
    r'|/\*.*?\*/'
    r'|R"(?P<mark>[^()\s\\]{0,16})\(.*?\)(?P=mark)"'
    r'|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-zA-Z])'(?:\\.|[^'\\\n])+'",
    re.DOTALL,
)


def files(root, folders=FOLDERS, suffixes=None):
    """All files below the folders, in order, as paths; those with one of the suffixes if any are given."""
    found = []
    for folder in folders:
        for path in sorted((Path(root) / folder).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts and (suffixes is None or path.suffix in suffixes):
                found.append(path)
    return found


def name(root, path):
    """The path from the root, with forward slashes."""
    return Path(path).relative_to(root).as_posix()


def read(path):
    return Path(path).read_text(encoding="utf-8", errors="replace")


def strip(text):
    """C++ text with comments and literals blanked, line by line as it was."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0))

    return _COMMENT_OR_LITERAL.sub(blank, text)
