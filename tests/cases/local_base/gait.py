import numpy as np

legs = np.arange(4)
print("phases", np.mod(legs * 0.25, 1.0).tolist())
