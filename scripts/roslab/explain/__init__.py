"""Explains a failed build from its log: the step, the line, the cause and the repair."""
