package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.world.Scene;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.json.Range;

/**
 * Tool weight check: compares what is declared with what the bodies of the tool weigh, and warns
 * where that is wrong. More mass may be a part that no object stands for, and is not told.
 */
final class ToolWeightCheck {
  /** Share of the mass that is passed over. */
  private static final double MASS_SHARE = 0.05;

  private static final double COG_M = 0.01;
  private static final double MM = 1000;

  private final Optional<Payload> tool;
  private final Consumer<String> warn;
  private Optional<Payload> told = Optional.empty();

  /** Of a scene whose load, where it is given as a whole, may be wrong on purpose. */
  ToolWeightCheck(Scene scene, Consumer<String> warn) {
    tool = scene.load().isPresent() ? Optional.empty() : scene.mounted();
    this.warn = warn;
  }

  /** Something has been declared while nothing is gripped; the same one is told once. */
  void declared(Payload payload) {
    if (tool.isPresent() && !told.equals(Optional.of(payload)) && wrong(payload, tool.get())) {
      told = Optional.of(payload);
      warn.accept(text("otherPayload", words(payload), words(tool.get())));
    }
  }

  private static boolean wrong(Payload payload, Payload tool) {
    if (payload.massKg() < (1 - MASS_SHARE) * tool.massKg()) {
      return true;
    }
    double away =
        Math.hypot(
            Math.hypot(payload.cogXM() - tool.cogXM(), payload.cogYM() - tool.cogYM()),
            payload.cogZM() - tool.cogZM());
    return payload.massKg() <= (1 + MASS_SHARE) * tool.massKg() && away > COG_M;
  }

  private static String words(Payload payload) {
    return text(
        "payload",
        Range.number(Math.rint(1000 * payload.massKg()) / 1000),
        mm(payload.cogXM()),
        mm(payload.cogYM()),
        mm(payload.cogZM()));
  }

  private static String mm(double lengthM) {
    return Range.number(Math.rint(10 * MM * lengthM) / 10);
  }
}
