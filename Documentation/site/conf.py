# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx configuration of the web site; make_site.py copies it beside the pages that it collects."""

import os

project = "Littoral"
author = "Littoral contributors"
copyright = "Littoral contributors, BSD-3-Clause"  # noqa: A001, Sphinx's name
version = release = os.environ.get("LITTORAL_VERSION", "")

extensions = ["myst_parser", "breathe"]
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
breathe_projects = {"littoral": os.environ.get("LITTORAL_XML", "xml")}
breathe_default_project = "littoral"
breathe_show_include = False
breathe_order_parameters_first = True
cpp_index_common_prefix = ["littoral::"]
highlight_language = "none"
nitpicky = False

html_theme = "furo"
html_title = f"Littoral {version}".strip()
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_show_sourcelink = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1f5f8f", "color-brand-content": "#1f5f8f"},
    "dark_css_variables": {"color-brand-primary": "#7fb7dd", "color-brand-content": "#7fb7dd"},
}
