"""Mistakes by rule: operators change the bodies of exercises, and the graded tests are asked whether they notice."""
