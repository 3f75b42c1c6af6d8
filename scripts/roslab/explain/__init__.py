"""A failed build in plain words: from its log to the step, the line, the cause and the repair."""
