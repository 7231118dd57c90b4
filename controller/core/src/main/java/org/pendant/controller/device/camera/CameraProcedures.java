package org.pendant.controller.device.camera;

import static org.pendant.controller.device.camera.CameraTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.Value;

/** Camera procedures: what programs call of a camera; poses and names are of the last picture. */
public final class CameraProcedures {
  private static final String WRONG = "rpc-arguments";

  private final PartCamera camera;
  private List<SeenPart> picture = List.of();

  /** Those of a camera that has taken no picture. */
  public CameraProcedures(PartCamera camera) {
    this.camera = camera;
  }

  /**
   * Answers a call; empty where it has no such procedure.
   *
   * @throws ScriptError where it is called wrongly
   */
  public Optional<Value> call(String method, List<Value> arguments) throws ScriptError {
    return switch (method) {
      case "look" -> {
        picture = camera.look(name(arguments));
        yield Optional.of(Value.of(picture.size()));
      }
      case "get_pose" -> Optional.of(new PoseValue(part(method, arguments).pose()));
      case "get_name" -> Optional.of(Value.of(part(method, arguments).name()));
      default -> Optional.empty();
    };
  }

  private static String name(List<Value> arguments) throws ScriptError {
    if (arguments.isEmpty()) {
      return "";
    }
    if (arguments.size() == 1 && arguments.getFirst() instanceof StringValue name) {
      return name.bytes();
    }
    throw new ScriptError(WRONG, text("takesName"));
  }

  private SeenPart part(String method, List<Value> arguments) throws ScriptError {
    if (arguments.size() != 1 || !(arguments.getFirst() instanceof IntValue index)) {
      throw new ScriptError(WRONG, text("takesNumber", method));
    }
    if (index.value() < 0 || index.value() >= picture.size()) {
      throw new ScriptError(
          WRONG,
          picture.isEmpty()
              ? text("noPart", index.value(), method)
              : text("partRange", index.value(), picture.size() - 1, method));
    }
    return picture.get(index.value());
  }
}
