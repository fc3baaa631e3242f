"""Exercises: a chapter's data, students' trees, grading and mistakes. Python 3.9 or later, standard library only."""
