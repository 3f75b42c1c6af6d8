"""Reading roslab.yaml, in all its formats, into one typed model."""

from roslab.config.model import Base, Config, Custom, Matlab, Source, Volume
from roslab.config.overrides import Override, configure
from roslab.config.reader import read

__all__ = ["Base", "Config", "Custom", "Matlab", "Override", "Source", "Volume", "configure", "read"]
