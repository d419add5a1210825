"""Rule: the link graph, direct and transitive, has only edges that the layers allow.

Reads the file that tests/lint/CMakeLists.txt writes when the build is configured: one line a target,
'name|folder|what it links, by semicolons'.
"""

import re

import layers

_WRAPPED = re.compile(r"\$<(?:LINK_ONLY|BUILD_INTERFACE|INSTALL_INTERFACE):([^<>]+)>")


def read_graph(path):
    """Of each target: its folder and the names it links."""
    graph = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        target, folder, linked = line.split("|")
        graph[target] = (folder, {_WRAPPED.sub(r"\1", name) for name in linked.split(";") if name})
    return graph


def reach(graph, target):
    """Everything that a target links, directly or not, without itself."""
    seen, open_names = set(), [target]
    while open_names:
        for name in graph.get(open_names.pop(), ("", set()))[1]:
            if name not in seen:
                seen.add(name)
                open_names.append(name)
    return seen - {target}


def check(graph):
    findings = []
    if not any(layers.layer(folder) == layers.SIMWORLD for folder, _ in graph.values()):
        findings.append("the link graph has no target in simworld: it was not read")
    for target, (folder, linked) in sorted(graph.items()):
        user = layers.layer(folder)
        if user is None or user == layers.TESTS:
            continue
        for name in sorted(reach(graph, target)):
            used = layers.layer(graph[name][0]) if name in graph else None
            if used is not None and not layers.may_use(user, used):
                how = "links" if name in linked else "links through others"
                findings.append(f"{folder}: {target} {how} {name}: {user} may not link {used}")
        for name in sorted(linked):
            for _, pattern, folders in layers.OWNED:
                if re.fullmatch(pattern, name) and not layers.in_folder(folder, folders):
                    findings.append(f"{folder}: {target} links {name}, which belongs to {', '.join(folders)}")
    return findings
