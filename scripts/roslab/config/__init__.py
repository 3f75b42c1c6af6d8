"""Reading roslab.yaml, in all its formats, into one typed model."""

from roslab.config.given import Override, configure, read
from roslab.config.model import Base, Config, Custom, Matlab, Source, Volume

__all__ = ["Base", "Config", "Custom", "Matlab", "Override", "Source", "Volume", "configure", "read"]
