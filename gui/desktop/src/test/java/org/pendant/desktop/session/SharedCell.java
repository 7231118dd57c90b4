package org.pendant.desktop.session;

import java.util.List;
import org.pendant.controller.ControllerOptions;

/** A cell of two arms and a script, for tests. */
public final class SharedCell {
  /** Two arms a metre apart that face one another, and what one says to the other. */
  public static final String SCENE =
      """
      {
        "objects": [{"type": "box", "name": "table", "pose": [0.4, 0, -0.1, 0, 0, 0], "size": [0.3, 0.3, 0.1]}],
        "arms": [
          {"name": "left", "robot": "ur5e", "program": "left.script", "address": "127.0.0.2"},
          {"name": "right", "robot": "ur3e", "base": [1, 0, 0, 0, 0, 3.141592653589793], "address": "127.0.0.3"}
        ],
        "script": "cell.script",
        "wires": [["left.digital_out[0]", "right.digital_in[0]"]]
      }
      """;

  private SharedCell() {}

  /** How it is switched on. */
  public static CellSetup setup() throws Exception {
    return setup(SCENE);
  }

  /** As {@link #setup()}, of a scene that is {@link #SCENE} with other numbers. */
  public static CellSetup setup(String scene) throws Exception {
    return new CellSetup(
        SceneFile.of("two.scene.json", scene).plan(),
        List.of(
            ControllerOptions.headless(),
            ControllerOptions.headless().withRobot("ur3e"),
            ControllerOptions.headless()));
  }
}
