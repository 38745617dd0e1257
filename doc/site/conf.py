"""Settings of the documentation site (target docs): every Markdown page of the repository, read by
MyST as GitHub reads it, in Sphinx with the theme furo. The addresses of pages are those of the files
(doc/choosing.md: doc/choosing.html), and the anchors of headings are GitHub's, so that a link that
works in the repository works here. Doxygen writes the classes beside it, into api/.
"""

import os
import sys

sys.path.insert(0, os.path.dirname(__file__))

project = "dynamY"
version = release = os.environ.get("DYNAMY_VERSION", "")
project_copyright = "the authors of dynamY"
language = "en"

extensions = ["myst_parser", "sphinx_copybutton", "bibliography", "pages", "formulas", "gallery", "theme"]
root_doc = "README"
source_suffix = {".md": "markdown"}
include_patterns = [
    "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "doc/*.md", "doc/site/README.md", "doc/references.bib", "doc/tutorial/*.md",
    "doc/reference/*.md", "doc/theory/*.md", "framework/dynamy/README.md", "framework/dynamy/**/README.md",
    "elements/dynamy_elements/README.md", "elements/dynamy_elements/**/README.md", "app/*.md", "app/fmu/*.md", "app/import/*.md",
    "app/python/examples/*.md",
]

myst_all_links_external = True  # pages.py turns names of files into addresses, check_links.py follows them
myst_enable_extensions = []
suppress_warnings = ["myst.header"]
highlight_language = "text"  # blocks that are set in are equations: pages.py

html_theme = "furo"
html_title = f"dynamY {version}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_js_files = ["gallery.js"]
html_copy_source = False
html_show_sphinx = False
html_use_index = False
html_sidebars = {"**": [
    "sidebar/brand.html", "sidebar/search.html", "sidebar/scroll-start.html", "sidebar/navigation.html",
    "classes.html", "sidebar/scroll-end.html",
]}
templates_path = ["templates"]
copybutton_selector = "div[class*=highlight-]:not(.highlight-none) pre"
