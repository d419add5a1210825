"""Who may include and link whom: the layers of docs/architecture.md, in one place for both rules.

planner/core <- planner/<family>;  planner/core <- idl;  core, idl <- simworld (no family);  planner, idl <- agent;
all of these <- groundstation. A family never uses a sibling.
"""

CORE, IDL, SIMWORLD, AGENT, GROUNDSTATION, TESTS = "planner/core", "idl", "simworld", "agent", "groundstation", "tests"

_MAY_USE = {
    CORE: {CORE},
    IDL: {CORE, IDL},
    SIMWORLD: {CORE, IDL, SIMWORLD},
    AGENT: {CORE, IDL, AGENT, "family"},
    GROUNDSTATION: {CORE, IDL, SIMWORLD, AGENT, GROUNDSTATION, "family"},
}

# Libraries of others that belong to one folder: (pattern of the header, pattern of the linked target, folders).
OWNED = (
    (r"fast(dds|rtps)/", r"fastrtps|skein_idl_pubsub", ("idl/bus", "idl/msg")),
    (r"idl/msg/\w+PubSubTypes\.h", r"(?!)", ("idl/bus",)),
    (r"fastcdr/", r"fastcdr", ("idl",)),
    (r"fcl/", r"fcl", ("simworld/collision",)),
    (r"assimp/", r"assimp::assimp", ("simworld/collision",)),
    (r"yaml-cpp/", r"yaml-cpp.*", ("simworld/scenario",)),
    (r"nlohmann/", r"nlohmann_json.*", ("simworld", "agent", "groundstation", "idl/process")),
    (r"CLI/", r"CLI11.*", ("idl/process", "simworld", "agent", "groundstation")),
    (r"spdlog/", r"spdlog.*", ("idl/bus", "idl/process", "simworld", "agent", "groundstation")),
    (r"n?curses", r"PkgConfig::NCURSESW", ("groundstation/monitor",)),
    (r"sleef\.h", r"PkgConfig::SLEEF|sleef", ("planner/core/math",)),
    (r"zstd\.h|zlib\.h", r"PkgConfig::ZSTD|ZLIB::ZLIB", ("groundstation/mcap",)),
    (r"Random123/", r"(?!)", ("planner/core/random",)),
)

# Standard headers that planner/ must do without: no clock, thread, log or global generator there.
NOT_IN_PLANNER = (
    "atomic", "chrono", "condition_variable", "ctime", "future", "iostream", "mutex", "random", "shared_mutex",
    "sys/time.h", "thread", "time.h",
)
# std::complex draws csqrt and cabs from libm.
NOWHERE = ("complex", "complex.h")


def layer(path):
    """The layer of a file or folder: 'planner/core', 'planner/<family>', 'idl', ...; None if it is in none."""
    parts = path.split("/")
    if parts[0] == "planner":
        return "/".join(parts[:2]) if len(parts) > 1 else None
    return parts[0] if parts[0] in (IDL, SIMWORLD, AGENT, GROUNDSTATION, TESTS) else None


def is_family(name):
    return name is not None and name.startswith("planner/") and name != CORE


def may_use(user, used):
    """Whether files or targets of layer `user` may include or link those of layer `used`."""
    if user == TESTS:
        return True
    if used is None or used == TESTS:
        return False
    if is_family(user):
        return used in (CORE, user)
    return used in _MAY_USE[user] or ("family" in _MAY_USE[user] and is_family(used))


def in_folder(path, folders):
    return any(path == folder or path.startswith(folder + "/") for folder in folders)
