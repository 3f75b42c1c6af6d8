"""The command line: arguments, one function a command, one place that catches errors."""
