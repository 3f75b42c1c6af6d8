"""What readers call some of what they find, by which it is known later, without importing a reader."""

LATEX = "latex"
"""The role of what the programs need whose plots have their text set by LaTeX."""
CONTAINER = "Docker container image"
"""The title below which a command in a container is kept: what a page starts without one comes before it."""
GIT_LFS = "git-lfs"
"""The package that a page names which says how large files are fetched."""
