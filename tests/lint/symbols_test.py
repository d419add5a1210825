"""The rule 'symbols' finds an object of ours that takes sin from libm, and looks at no generated one."""

import subprocess
import unittest

import planted
import symbols


class Symbols(planted.PlantedTree):
    def compile(self, folder, name, expression, with_source=True):
        source = self.plant(f"source/{folder}/{name}", f"#include <cmath>\ndouble f(double x) {{ return {expression}; }}\n")
        target = self.root / "build" / folder / "CMakeFiles" / "t.dir"
        target.mkdir(parents=True, exist_ok=True)
        subprocess.run(["g++", "-c", str(source), "-o", str(target / (name + ".o"))], check=True)
        if not with_source:
            source.unlink()

    def findings(self):
        return symbols.check(self.root / "source", self.root / "build")

    def test_the_five_exact_functions_pass(self):
        self.compile("planner/core/a", "a.cpp", "std::sqrt(x) + std::floor(x) + std::ceil(x) + std::trunc(x) + std::fabs(x)")
        self.assertEqual(self.findings(), [])

    def test_sin_is_found(self):
        self.compile("planner/core/a", "a.cpp", "std::sin(x)")
        self.assert_only(self.findings(), "planner/core/a/", "a.cpp.o: uses sin of libm")

    def test_every_layer_is_looked_at(self):
        for folder in ("planner", "idl", "simworld", "agent", "groundstation"):
            self.compile(folder, "a.cpp", "std::pow(x, x)")
        self.assertEqual(len(self.findings()), 5)

    def test_generated_code_is_left_out(self):
        self.compile("idl/msg", "tick.cxx", "std::exp(x)", with_source=False)
        self.compile("idl/bus", "a.cpp", "x")
        self.assertEqual(self.findings(), [])

    def test_a_build_without_objects_is_found(self):
        (self.root / "build").mkdir()
        self.assert_only(self.findings(), "nothing was checked")


if __name__ == "__main__":
    unittest.main()
