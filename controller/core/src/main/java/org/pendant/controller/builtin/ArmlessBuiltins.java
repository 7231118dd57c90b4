package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Signature;
import org.pendant.script.function.Builtins;

/** Catalogue of what a controller without an arm knows: all but what is about an arm. */
public final class ArmlessBuiltins {
  /** What is about the controller itself, among what is about its arm. */
  private static final List<String> OF_CONTROLLER = List.of("get_controller_temp", "powerdown");

  private static final List<Consumer<Builtins<ControlBox>>> OF_ARMS =
      List.of(
          MotionBuiltins::declareIn,
          ServoBuiltins::declareIn,
          ProcessMoveBuiltins::declareIn,
          OptimoveBuiltins::declareIn,
          ToolWrenchBuiltins::declareIn,
          MotionSettingBuiltins::declareIn,
          FreedriveBuiltins::declareIn,
          ToolpathBuiltins::declareIn,
          ConveyorBuiltins::declareIn,
          PathOffsetBuiltins::declareIn,
          ForceBuiltins::declareIn,
          ContactBuiltins::declareIn,
          KinematicsBuiltins::declareIn,
          StateBuiltins::declareIn,
          DynamicsBuiltins::declareIn,
          PayloadBuiltins::declareIn,
          MountingBuiltins::declareIn,
          SensorBuiltins::declareIn,
          SafetyBuiltins::declareIn,
          BaseLightBuiltins::declareIn,
          ToolIoBuiltins::declareIn,
          ToolSerialBuiltins::declareIn);

  private ArmlessBuiltins() {}

  /** A new catalogue. */
  public static Builtins<ControlBox> create() {
    Builtins<ControlBox> arms = new Builtins<>();
    OF_ARMS.forEach(topic -> topic.accept(arms));
    Map<String, String> absent = new HashMap<>();
    for (Signature each : arms.all()) {
      String name = each.name();
      if (each.receiver().isEmpty() && !OF_CONTROLLER.contains(name)) {
        absent.put(name, text("needsArm", name));
      }
    }
    return StandardBuiltins.create().without(absent);
  }
}
