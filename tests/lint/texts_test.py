"""The rules 'words', 'folders' and 'format' find what is planted."""

from pathlib import Path

import planted
import texts


class Words(planted.PlantedTree):
    def test_words_are_found_everywhere(self):
        for word in ("TO" + "DO", "FIX" + "ME", "DISABL" + "ED_Case", "GTEST_" + "SKIP()"):
            for name in ("agent/a.cpp", "tests/a_test.cpp", "deploy/x.sh", "docs/x.md", "idl/msg/a.idl"):
                with self.subTest(word=word, name=name):
                    path = self.plant(name, f"fine\n// {word} later\n")
                    self.assert_only(texts.check_words(self.root), f"{name}:2:")
                    path.unlink()

    def test_sleeps_are_found_in_tests_only(self):
        for line in ("std::this_thread::sleep" + "_for(1s);", "usleep" + "(10);", "time.sl" + "eep(1)", "sleep" + " 3"):
            with self.subTest(line=line):
                self.plant("tests/agent/a_test.cpp", f"  {line}\n")
                self.assert_only(texts.check_words(self.root), "tests/agent/a_test.cpp:1:")
        self.plant("tests/agent/a_test.cpp", "int asleep = 3;\n")
        self.plant("agent/a.cpp", "std::this_thread::sleep" + "_for(1s);\n")
        self.assertEqual(texts.check_words(self.root), [])


class Folders(planted.PlantedTree):
    def test_an_undeclared_folder_is_found(self):
        self.plant(".gitignore", "/build/\n")
        for name in ("agent/a", "tests/a", "docs/a", ".ci/run", ".git/a", "build/a", "README.md"):
            self.plant(name)
        self.assertEqual(texts.check_folders(self.root), [])
        self.plant("utils/a")
        self.assert_only(texts.check_folders(self.root), "utils: the top level has no such folder")


class Format(planted.PlantedTree):
    def test_another_layout_is_found(self):
        style = Path(__file__).resolve().parents[2] / ".clang-format"
        self.plant(".clang-format", style.read_text(encoding="utf-8"))
        self.plant("agent/a.cpp", "int f() { return 1; }\n")
        self.plant("agent/b.cpp", "int g();\n")
        found = texts.check_format(self.root)
        self.assertTrue(found and all("agent/a.cpp:1:" in line for line in found), found)
        self.plant("agent/a.cpp", "int f();\n")
        self.assertEqual(texts.check_format(self.root), [])

    def test_no_file_at_all_is_found(self):
        self.assert_only(texts.check_format(self.root), "no source file")
