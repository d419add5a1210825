"""Rule: every #include is an edge that the layers allow, by full path from the root."""

import re

import layers
import tree

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"(?P<ours>[^"]+)"|<(?P<theirs>[^>]+)>)', re.MULTILINE)


def check(root):
    findings = []
    for path in tree.files(root, tree.CODE_FOLDERS + ("tests",), (".cpp", ".hpp")):
        name = tree.name(root, path)
        text = tree.read(path)
        for match in _INCLUDE.finditer(text):
            header = match["ours"] or match["theirs"]
            fault = _ours(root, name, header) if match["ours"] else _theirs(name, header)
            if fault:
                findings.append(f"{name}:{text.count(chr(10), 0, match.start()) + 1}: {fault}")
    return findings


def _ours(root, user, header):
    generated = header.startswith("idl/msg/")
    if not generated and not (root / header).is_file():
        return f'"{header}" is no path from the root'
    used = layers.layer(header)
    if not layers.may_use(layers.layer(user), used):
        return f'"{header}": {layers.layer(user)} may not include {used}'
    return _owned(user, header)


def _theirs(user, header):
    layer = layers.layer(user)
    if layer == layers.TESTS:
        return None
    if header in layers.NOWHERE:
        return f"<{header}> is used nowhere (write complex arithmetic out)"
    if user.startswith("planner/") and header in layers.NOT_IN_PLANNER:
        return f"<{header}>: no clock, thread, log or global generator in planner"
    return _owned(user, header)


def _owned(user, header):
    if layers.layer(user) == layers.TESTS:
        return None
    for pattern, _, folders in layers.OWNED:
        if re.match(pattern, header) and not layers.in_folder(user, folders):
            return f"<{header}> belongs to {', '.join(folders)}"
    return None
