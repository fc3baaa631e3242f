"""The one exception that commands throw on purpose."""


class CourseError(Exception):
    """Ends a command with exit code 1. Its text is one line: what is wrong, where, and what to do."""

    code = 1  # a derived class may leave with another one
