"""The one reader of a checkout: its files, and its commit by git."""
