# Doxygen gives a page to a file, and lists its functions, only if the file itself has a docstring.
1s|^|/** @file */ |
