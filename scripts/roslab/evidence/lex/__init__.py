"""Lexers: text cut into the words of its language, without meaning."""
