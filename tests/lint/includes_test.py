"""The rule 'includes' finds every kind of forbidden edge, and leaves allowed ones alone."""

import unittest

import includes
import planted


class Includes(planted.PlantedTree):
    def setUp(self):
        super().setUp()
        for name in ("planner/core/a/a.hpp", "planner/rendezvous/r.hpp", "planner/transit/t.hpp", "idl/bus/port.hpp",
                     "simworld/world/w.hpp", "agent/runtime/g.hpp", "groundstation/cli/c.hpp", "tests/t.hpp"):
            self.plant(name, "#pragma once\n")

    def findings(self, user, include):
        self.plant(user, f"// one line above\n#include {include}\n")
        return includes.check(self.root)

    def test_allowed_edges_pass(self):
        for user, header in (("planner/core/b/b.cpp", "planner/core/a/a.hpp"),
                             ("planner/rendezvous/x.cpp", "planner/core/a/a.hpp"),
                             ("planner/rendezvous/ph/x.cpp", "planner/rendezvous/r.hpp"),
                             ("idl/convert/x.cpp", "planner/core/a/a.hpp"),
                             ("simworld/world/x.cpp", "idl/bus/port.hpp"),
                             ("agent/runtime/x.cpp", "planner/rendezvous/r.hpp"),
                             ("groundstation/cli/x.cpp", "simworld/world/w.hpp"),
                             ("groundstation/cli/y.cpp", "planner/transit/t.hpp"),
                             ("tests/agent/x_test.cpp", "agent/runtime/g.hpp"),
                             ("idl/convert/y.cpp", "idl/msg/tick.h")):
            with self.subTest(user=user, header=header):
                self.assertEqual(self.findings(user, f'"{header}"'), [])

    def test_forbidden_layers_are_found(self):
        for user, header in (("planner/core/b/b.cpp", "planner/rendezvous/r.hpp"),
                             ("planner/core/b/b.cpp", "idl/bus/port.hpp"),
                             ("planner/rendezvous/x.cpp", "planner/transit/t.hpp"),
                             ("planner/rendezvous/x.cpp", "idl/bus/port.hpp"),
                             ("idl/bus/x.cpp", "planner/rendezvous/r.hpp"),
                             ("idl/bus/x.cpp", "agent/runtime/g.hpp"),
                             ("simworld/main.cpp", "planner/rendezvous/r.hpp"),
                             ("simworld/main.cpp", "agent/runtime/g.hpp"),
                             ("agent/main.cpp", "simworld/world/w.hpp"),
                             ("agent/main.cpp", "groundstation/cli/c.hpp"),
                             ("agent/main.cpp", "tests/t.hpp")):
            with self.subTest(user=user, header=header):
                self.assert_only(self.findings(user, f'"{header}"'), f"{user}:2:", header, "may not include")
                (self.root / user).unlink()

    def test_libraries_stay_in_their_folder(self):
        for user, header in (("simworld/world/x.cpp", "fcl/fcl.h"), ("planner/core/b/b.hpp", "fcl/fcl.h"),
                             ("agent/runtime/x.cpp", "fastdds/dds/domain/DomainParticipant.hpp"),
                             ("idl/convert/x.cpp", "fastrtps/types.h"), ("simworld/world/x.hpp", "fastcdr/Cdr.h"),
                             ("groundstation/cli/x.cpp", "yaml-cpp/yaml.h"), ("planner/core/b/b.cpp", "CLI/CLI.hpp"),
                             ("planner/core/b/b.cpp", "spdlog/spdlog.h"), ("planner/rendezvous/x.cpp", "sleef.h"),
                             ("planner/rendezvous/x.cpp", "Random123/philox.h")):
            with self.subTest(user=user, header=header):
                self.assert_only(self.findings(user, f"<{header}>"), f"{user}:2:", header, "belongs to")
                (self.root / user).unlink()

    def test_clocks_threads_and_complex_are_found_in_planner(self):
        for header in ("chrono", "thread", "random", "iostream", "complex"):
            with self.subTest(header=header):
                self.assert_only(self.findings("planner/core/b/b.cpp", f"<{header}>"), f"<{header}>")
        self.assert_only(self.findings("planner/core/b/b.cpp", "<vector>\n#  include <mutex>"), ":3:", "<mutex>")

    def test_generated_dds_headers_are_for_the_bus_alone(self):
        self.assertEqual(self.findings("idl/bus/x.cpp", '"idl/msg/tickPubSubTypes.h"'), [])
        self.assert_only(self.findings("idl/convert/x.cpp", '"idl/msg/tickPubSubTypes.h"'), "belongs to idl/bus")

    def test_a_path_not_from_the_root_is_found(self):
        self.assert_only(self.findings("agent/runtime/x.cpp", '"g.hpp"'), "no path from the root")


if __name__ == "__main__":
    unittest.main()
