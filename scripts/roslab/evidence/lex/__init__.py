"""Lexers: text split into the words of its language, without interpretation."""
