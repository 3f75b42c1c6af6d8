"""Draw a red ball and tell whether it is seen."""

import mujoco

MODEL = """
<mujoco>
  <worldbody>
    <light pos="0 0 3"/>
    <geom type="sphere" size="1" rgba="1 0 0 1"/>
  </worldbody>
</mujoco>
"""

if __name__ == "__main__":
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with mujoco.Renderer(model, 120, 160) as renderer:
        renderer.update_scene(data)
        red, green, _ = renderer.render().max(axis=(0, 1))
    print("a red ball is seen" if red > 2 * green else "nothing is seen")
