"""Parts of the documentation site: site_test.py SOURCE_DIR"""

import importlib.util
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(sys.argv[1])
sys.dont_write_bytecode = True
sys.path.insert(0, str(SOURCE / "doc/site"))

import check_links  # noqa: E402
import headers  # noqa: E402

HAS_DOCUTILS = importlib.util.find_spec("docutils") is not None


def site(**pages):
    folder = tempfile.TemporaryDirectory()
    for name, text in pages.items():
        Path(folder.name, f"{name}.html").write_text(text, encoding="utf-8")
    return folder


class Links(unittest.TestCase):
    def test_finds_a_missing_page_picture_and_anchor(self):
        with site(a='<a href="b.html#here">x</a><a href="c.html">x</a><img src="d.png"><a href="b.html#there">x</a>',
                  b='<p id="here">x</p>') as folder:
            self.assertEqual(sorted(check_links.broken(folder)),
                             [("a.html", "b.html#there"), ("a.html", "c.html"), ("a.html", "d.png")])

    def test_leaves_other_sites_alone(self):
        with site(a='<a href="https://example.org/nothing">x</a><a href="#top">x</a><p id="top">x</p>') as folder:
            self.assertEqual(list(check_links.broken(folder)), [])


class Headers(unittest.TestCase):
    def test_every_line_of_every_header_keeps_its_number(self):
        files = [*SOURCE.glob("framework/dynamy/**/*.hpp"), *SOURCE.glob("elements/dynamy_elements/**/*.hpp")]
        self.assertGreater(len(files), 100)
        for file in files:
            text = file.read_text(encoding="utf-8")
            self.assertEqual(headers.told(text, "x.hpp").count("\n"), text.count("\n"), file)

    def test_the_head_describes_the_class_that_it_names(self):
        text = "/// Second: what it is.\n#pragma once\n\nstruct First {\n};\n\nclass Second {\n};\n"
        self.assertIn("/// \\copydoc x.hpp\nclass Second", headers.told(text, "x.hpp"))

    def test_a_comment_of_the_class_itself_stays(self):
        text = "// A file.\n#pragma once\n\n/// Its own.\nclass Only {\n};\n"
        self.assertNotIn("copydoc", headers.told(text, "x.hpp"))

    def test_an_element_in_a_comment_is_no_tag(self):
        self.assertEqual(headers.escaped("/// a <Box> and `<Box>`"), "/// a \\<Box> and `<Box>`")


@unittest.skipUnless(HAS_DOCUTILS, "no docutils")
class Formulas(unittest.TestCase):
    def setUp(self):
        import formulas
        self.formulas = formulas

    def test_sets_indices_and_exponents(self):
        made = [(type(node).__name__, node.astext()) for node in self.formulas.pieces("μλ_N, γ_N^E and s^(2/3)")]
        marks = [node for node in made if node[0] != "Text"]
        self.assertEqual(marks, [("subscript", "N"), ("subscript", "N"), ("superscript", "E"), ("superscript", "2/3")])

    def test_leaves_names_of_programs_alone(self):
        self.assertIsNone(self.formulas.pieces("dynamy_add_plugin, r_OS_I, front_wheel"))

    def test_gives_the_saved_width_back_at_the_next_gap(self):
        line = self.formulas.line_of_block("prox_C(z)  here")
        # "_C" has two columns, the index takes 0.75 of one.
        self.assertEqual(line, 'prox<sub>C</sub>(z)  <span style="display:inline-block;width:1.25ch"></span>here')


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
