"""The command line: its arguments, a function for each command, and one place that catches errors."""
