"""What the tools need to know of C++ as text."""

import re

# A quote behind a letter or digit starts no text: it parts the digits of a number.
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])*\'', re.DOTALL)
RAW_TEXT = re.compile(r'\bu?8?R"')


def without_comments(source):
    """A source without its comments, blank lines and indentation. One with raw strings stays as it is."""
    if RAW_TEXT.search(source):
        return source
    code = COMMENT_OR_TEXT.sub(lambda match: " " if match[0].startswith("/") else match[0], source)
    return "".join(line.strip() + "\n" for line in code.splitlines() if line.strip())
