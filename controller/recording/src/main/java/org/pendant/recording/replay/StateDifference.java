package org.pendant.recording.replay;

import static org.pendant.recording.replay.ReplayTexts.text;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.recording.Recording;
import org.pendant.script.variables.VariableSample;

/** State difference: tells whether two runs are the same one, by snapshots of the same frame. */
public final class StateDifference {
  private StateDifference() {}

  /**
   * The first difference between a snapshot and the same one of a rerun: of the joints bit for bit,
   * but for the noise of an arm that rests, of the program and its variables, of the signals. Empty
   * if there is none.
   */
  public static Optional<String> between(ControllerState was, ControllerState is) {
    if (was.frame() != is.frame()) {
      return Optional.of(text("frameDiffers", is.frame(), was.frame()));
    }
    return joints(was, is)
        .or(() -> other(text("lineOfProgram"), was.program().line(), is.program().line()))
        .or(() -> other(text("program"), was.program().name(), is.program().name()))
        .or(() -> other(text("program"), was.program().state(), is.program().state()))
        .or(() -> other(text("safetyMode"), was.safety().safetyMode(), is.safety().safetyMode()))
        .or(() -> other(text("digitalSignals"), was.io(), is.io()))
        .or(() -> changed(text("otherSignals"), was.signals(), is.signals()))
        .or(() -> bodies(was, is))
        .or(() -> other(text("encoders"), was.encoders(), is.encoders()))
        .or(() -> variables(was.variables().globals(), is.variables().globals()));
  }

  /** Where bodies are stands in a recording once in some frames. */
  private static Optional<String> bodies(ControllerState was, ControllerState is) {
    return was.frame() % Recording.BODIES_FRAMES == 0
        ? changed(text("placesOfObjects"), was.moved(), is.moved())
        : Optional.empty();
  }

  private static Optional<String> joints(ControllerState stateWas, ControllerState stateIs) {
    ArmState was = stateWas.arm();
    ArmState is = stateIs.arm();
    return joints("targetPositionIsWas", was.targetPositionRad(), is.targetPositionRad())
        .or(() -> joints("targetSpeedIsWas", was.targetSpeedRadPerS(), is.targetSpeedRadPerS()))
        // a recording leaves out most noise of an arm that rests
        .or(() -> stateWas.armRests() && stateIs.armRests() ? Optional.empty() : measured(was, is));
  }

  private static Optional<String> measured(ArmState was, ArmState is) {
    return joints("positionIsWas", was.actualPositionRad(), is.actualPositionRad())
        .or(() -> joints("speedIsWas", was.actualSpeedRadPerS(), is.actualSpeedRadPerS()));
  }

  private static Optional<String> joints(String key, Joints was, Joints is) {
    for (int i = 0; i < Joints.COUNT; i++) {
      long before = Double.doubleToRawLongBits(was.get(i));
      if (before != Double.doubleToRawLongBits(is.get(i))) {
        return Optional.of(text(key, i, is.get(i), was.get(i)));
      }
    }
    return Optional.empty();
  }

  private static Optional<String> variables(List<VariableSample> was, List<VariableSample> is) {
    if (was.size() != is.size()) {
      return Optional.of(text("variableCount", is.size(), was.size()));
    }
    for (int i = 0; i < was.size(); i++) {
      VariableSample before = was.get(i);
      VariableSample now = is.get(i);
      Optional<String> difference =
          other(text("variable", i), before.name(), now.name())
              .or(() -> other(text("lengthOf", now.name()), before.length(), now.length()))
              .or(() -> changed(text("variable", now.name()), before.value(), now.value()));
      if (difference.isPresent()) {
        return difference;
      }
    }
    return Optional.empty();
  }

  private static Optional<String> other(String what, Object was, Object is) {
    return Objects.equals(was, is) ? Optional.empty() : Optional.of(text("isWas", what, is, was));
  }

  /** As {@link #other}, for what is too long to be said. */
  private static Optional<String> changed(String what, Object was, Object is) {
    return Objects.equals(was, is) ? Optional.empty() : Optional.of(text("otherValue", what));
  }
}
