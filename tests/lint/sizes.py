"""Rule: no source file over 300 lines, no function over 60."""

import re

import tree

MAX_FILE_LINES = 300
MAX_FUNCTION_LINES = 60

_SCOPE = re.compile(r"(?:inline\s+|typedef\s+|export\s+)*(?:namespace|class|struct|union|enum|extern|module)\b")
_TEMPLATE = re.compile(r"template\s*<[^{};]*?>(?=\s*(?:template|requires|class|struct|union|using|\w|\[))", re.DOTALL)


def check(root):
    findings = []
    for path in tree.files(root, suffixes=tree.SOURCE_SUFFIXES):
        name = tree.name(root, path)
        text = tree.read(path)
        lines = text.count("\n") + (not text.endswith("\n") and text != "")
        if lines > MAX_FILE_LINES:
            findings.append(f"{name}:1: {lines} lines; allowed: {MAX_FILE_LINES}")
        if path.suffix != ".idl":
            for first, length in functions(text):
                if length > MAX_FUNCTION_LINES:
                    findings.append(f"{name}:{first}: a function of {length} lines; allowed: {MAX_FUNCTION_LINES}")
    return findings


def functions(text):
    """First line and number of lines, signature to closing brace, of every function that stands in no other."""
    code = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: re.sub(r"[^\n]", " ", m.group(0)), tree.strip(text),
                  flags=re.MULTILINE)
    found, kinds, header = [], [], 0
    for place, char in enumerate(code):
        if char not in "{};":
            continue
        inside_body = "body" in kinds
        if char == "{":
            kind = "body" if inside_body else _kind(code[header:place])
            kinds.append(kind)
            if kind == "body" and not inside_body:
                start = header + len(code[header:place]) - len(code[header:place].lstrip())
        elif char == "}" and kinds:
            if kinds.pop() == "body" and "body" not in kinds:
                first = code.count("\n", 0, start) + 1
                found.append((first, code.count("\n", 0, place) + 2 - first))
        if "body" not in kinds:
            header = place + 1
    return found


def _kind(header):
    """What a brace opens after this text: 'scope', 'body' of a function, or 'other' (an initialiser)."""
    header = _TEMPLATE.sub("", header).strip()
    header = re.sub(r"^(?:public|private|protected)\s*:", "", header).strip()
    if _SCOPE.match(header):
        return "scope"
    outside = re.sub(r"operator\s*[^\s(]+|operator\s*\(\s*\)", "operator_", header)
    while (shorter := re.sub(r"\([^()]*\)", " ", outside)) != outside:
        outside = shorter
    return "body" if "(" in header and "=" not in outside else "other"
