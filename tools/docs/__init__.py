"""The course's site: from Markdown, headers and figures to HTML. Python 3.9 or later, standard library only."""
