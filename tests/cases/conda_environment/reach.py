import numpy as np
import roboticstoolbox as rtb

robot = rtb.models.DH.Planar2()
print("tip at", np.round(robot.fkine([0.3, 0.4]).t, 3))
