package org.pendant.controller.layout;

import java.util.Optional;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneTool;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.json.FilePosition;
import org.pendant.models.pose.Pose;

/**
 * Arm of a cell, with a controller of its own.
 *
 * @param name what signals, messages and files call it
 * @param robot id of the arm; empty for the one that is standard, or that a command line names
 * @param baseInCell where its base stands
 * @param startRad where its joints are at first; empty for where arms stand otherwise
 * @param program what it runs; empty where nothing says so
 * @param installation what it is set up as
 * @param address where its ports are, a loopback address
 * @param load what truly hangs on its flange; empty for that of the scene
 * @param tool what is on its flange; empty for that of the scene
 * @param place where the file has it
 */
public record ArmEntry(
    String name,
    Optional<String> robot,
    Pose baseInCell,
    Optional<Joints> startRad,
    Optional<NamedFile> program,
    Optional<NamedFile> installation,
    Optional<String> address,
    Optional<Payload> load,
    Optional<SceneTool> tool,
    FilePosition place) {
  /**
   * The only arm of a cell whose file says nothing of it.
   *
   * @param place of what is wrong with it
   */
  public static ArmEntry only(FilePosition place) {
    return new ArmEntry(
        CellLayout.ONLY_ARM,
        Optional.empty(),
        Pose.ZERO,
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        place);
  }

  /**
   * A scene with the tool and the load of this arm.
   *
   * @throws IllegalArgumentException if it has a load, and its tool weighs something besides
   */
  public Scene equipped(Scene scene) {
    if (tool.isEmpty()) {
      return load.isPresent() ? scene.withLoad(load) : scene;
    }
    Scene own =
        scene
            .withLoad(Optional.empty())
            .withToolPoints(tool.get().points())
            .withToolBodies(tool.get().bodies());
    return load.isEmpty() && own.mounted().isPresent()
        ? own
        : own.withLoad(load.isPresent() ? load : scene.load());
  }
}
