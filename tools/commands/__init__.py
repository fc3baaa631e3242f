"""The commands of the course script, one a module."""
