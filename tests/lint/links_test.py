"""The rule 'links' finds forbidden edges of the link graph, direct and through others."""

import links
import planted

GOOD = """skein_warnings||
skein_core_a|planner/core/a|skein_warnings;Eigen3::Eigen
skein_rendezvous|planner/rendezvous|skein_core_a
skein_transit|planner/transit|skein_core_a
skein_idl_dds|idl/bus|skein_core_a;fastrtps
skein_world|simworld/world|skein_core_a;skein_idl_dds;$<LINK_ONLY:skein_warnings>
skein_collision|simworld/collision|fcl
skein-simworld|simworld|skein_world
skein-agent|agent|skein_rendezvous;skein_idl_dds
skein|groundstation|skein-agent;skein_world
some_test|tests/agent|skein-agent;skein_world
"""


class Links(planted.PlantedTree):
    def findings(self, old="", new=""):
        self.assertIn(old, GOOD)
        return links.check(links.read_graph(self.plant("links.txt", GOOD.replace(old, new) if old else GOOD)))

    def test_allowed_graph_passes(self):
        self.assertEqual(self.findings(), [])

    def test_a_world_that_links_a_family_is_found(self):
        self.assert_only(self.findings("simworld|skein_world\n", "simworld|skein_world;$<LINK_ONLY:skein_rendezvous>\n"),
                         "skein-simworld links skein_rendezvous", "simworld may not link planner/rendezvous")

    def test_a_family_reached_through_others_is_found(self):
        findings = self.findings("idl/bus|skein_core_a", "idl/bus|skein_core_a;skein_rendezvous")
        self.assertTrue(any("skein-simworld links through others skein_rendezvous" in line for line in findings))
        self.assertTrue(any("skein_idl_dds links skein_rendezvous" in line for line in findings))

    def test_a_sibling_family_is_found(self):
        self.assert_only(self.findings("planner/transit|skein_core_a", "planner/transit|skein_core_a;skein_rendezvous"),
                         "planner/transit may not link planner/rendezvous")

    def test_a_core_that_links_upwards_is_found(self):
        self.assertTrue(self.findings("a|skein_warnings;Eigen3::Eigen", "a|skein_idl_dds"))

    def test_libraries_stay_in_their_folder(self):
        for old, new, name in (("simworld/world|", "simworld/world|fcl;", "fcl"),
                               ("agent|skein_rendezvous;", "agent|skein_rendezvous;fastrtps;", "fastrtps"),
                               ("planner/core/a|", "planner/core/a|yaml-cpp;", "yaml-cpp")):
            with self.subTest(name=name):
                self.assert_only(self.findings(old, new), f"links {name}, which belongs to")

    def test_an_empty_graph_is_found(self):
        self.assert_only(links.check({}), "was not read")
