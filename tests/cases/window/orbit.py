"""Draws an orbit in a window."""

import math

import matplotlib.pyplot as plt

turns = [math.tau * step / 90 for step in range(91)]
plt.plot([math.cos(turn) for turn in turns], [0.6 * math.sin(turn) for turn in turns])
plt.title("an orbit")
plt.show()
