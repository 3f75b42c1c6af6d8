"""roslab.yaml, every generation of it, as one typed model."""

from roslab.config.model import Base, Config, Custom, Matlab, Source, Volume
from roslab.config.overrides import Override, configure
from roslab.config.reader import read

__all__ = ["Base", "Config", "Custom", "Matlab", "Override", "Source", "Volume", "configure", "read"]
