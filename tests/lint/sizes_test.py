"""The rule 'sizes' finds long files and functions, and counts no class, namespace or table as a function."""

import planted
import sizes

LONG = "  ++x;\n" * 60


class Sizes(planted.PlantedTree):
    def findings(self, text, name="agent/runtime/x.cpp"):
        self.plant(name, text)
        return sizes.check(self.root)

    def test_a_file_of_301_lines_is_found_and_one_of_300_is_not(self):
        self.assertEqual(self.findings("//\n" * 300), [])
        self.assert_only(self.findings("//\n" * 301), "agent/runtime/x.cpp:1: 301 lines")
        self.assert_only(self.findings("//\n" * 300 + "//"), "301 lines")

    def test_idl_and_header_files_count(self):
        self.assert_only(self.findings("//\n" * 301, "idl/msg/x.idl"), "x.idl")
        self.plant("idl/msg/x.idl")
        self.assert_only(self.findings("//\n" * 301, "tests/x.hpp"), "tests/x.hpp")

    def test_a_function_of_61_lines_is_found_and_one_of_60_is_not(self):
        self.assertEqual(self.findings("void f() {\n" + "  ++x;\n" * 58 + "}\n"), [])
        self.assert_only(self.findings("int a;\n\nvoid f() {\n" + "  ++x;\n" * 59 + "}\n"), "x.cpp:3: a function of 61")

    def test_every_form_of_function_is_found(self):
        for head in ("void f() {", "static auto A::f(int a = 3) const noexcept -> std::vector<int> {",
                     "bool operator==(const A& a, const A& b) {", "void operator()(int a) {", "A::A(int a) : b_(a) {",
                     "A::A(int a)\n    : b_{a}, c_(2) {", "template <typename T = int>\nT f(T a) {", "TEST(A, B) {",
                     "namespace n {\nclass A : public B {\n public:\n  void f() override {",
                     "struct A {\n  explicit A(int a) {", "template <typename T>\nrequires(C<T>) void f(T a) {"):
            with self.subTest(head=head):
                self.assert_only(self.findings(head + "\n" + LONG + "}\n" * head.count("{")), "a function of")

    def test_a_long_lambda_counts_to_its_function(self):
        self.assert_only(self.findings("void f() {\n  g([&](int a) {\n" + LONG + "  });\n}\n"), "a function of 64 lines")

    def test_other_braces_are_no_functions(self):
        for text in ("namespace a {\n" + "int f();\n" * 70 + "}\n", "class A : public B {\n" + " int f();\n" * 70 + "};\n",
                     "const int kTable[] = {\n" + "  1,\n" * 70 + "};\n", "enum class A : int {\n" + " a,\n" * 70 + "};\n",
                     "#define M(a) \\\n  void f() {\n" + "int f() { return 1; }\n" * 70):
            with self.subTest(text=text[:20]):
                self.assertEqual(self.findings(text), [])

    def test_braces_in_comments_and_literals_do_not_count(self):
        noise = "// {\n/* { */ const char* a = \"{\"; char b = '{'; int c = 1'000; const char* d = R\"x({\")x\";\n"
        self.assertEqual(sizes.functions(noise + "void f() {\n  g(\"}\");\n}\n"), [(3, 3)])
