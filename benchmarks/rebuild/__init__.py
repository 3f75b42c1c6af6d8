"""The same repository built several ways, again after each kind of change: time, steps, bytes to push, size."""
