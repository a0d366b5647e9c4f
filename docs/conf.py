"""Sphinx: the site. `make docs` builds it into build/site; pages under docs/made are written before, and
computed again if the package or the scripts of the site have changed.
"""

import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "site"))

from kinetruss import __version__  # noqa: E402

project = "kinetruss"
author = "kinetruss contributors"
copyright = "kinetruss contributors, BSD-3-Clause"
version = release = __version__

extensions = ["myst_nb", "sphinx_design", "made", "mathml"]
exclude_patterns = ["site", "made/static", "made/models"]
default_role = "code"
myst_enable_extensions = ["deflist", "dollarmath", "colon_fence", "attrs_inline"]
myst_heading_anchors = 3

nb_execution_mode = "auto"
nb_execution_timeout = 600
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_merge_streams = True

html_math_renderer = "mathml"
html_theme = "furo"
html_title = f"kinetruss {version}"
html_static_path = ["site/static", "made/static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
pygments_style = "friendly"
pygments_dark_style = "monokai"
