package org.pendant.recording.replay;

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
      return Optional.of("the frame is " + is.frame() + ", was " + was.frame());
    }
    return joints(was, is)
        .or(() -> other("the line of the program", was.program().line(), is.program().line()))
        .or(() -> other("the program", was.program().name(), is.program().name()))
        .or(() -> other("the program", was.program().state(), is.program().state()))
        .or(() -> other("the safety mode", was.safety().safetyMode(), is.safety().safetyMode()))
        .or(() -> other("the digital signals", was.io(), is.io()))
        .or(() -> changed("other signals", was.signals(), is.signals()))
        .or(() -> bodies(was, is))
        .or(() -> other("the encoders", was.encoders(), is.encoders()))
        .or(() -> variables(was.variables().globals(), is.variables().globals()));
  }

  /** Where bodies are stands in a recording once in some frames. */
  private static Optional<String> bodies(ControllerState was, ControllerState is) {
    return was.frame() % Recording.BODIES_FRAMES == 0
        ? changed("where objects of the scene are", was.moved(), is.moved())
        : Optional.empty();
  }

  private static Optional<String> joints(ControllerState stateWas, ControllerState stateIs) {
    ArmState was = stateWas.arm();
    ArmState is = stateIs.arm();
    return joints("target position", was.targetPositionRad(), is.targetPositionRad())
        .or(() -> joints("target speed", was.targetSpeedRadPerS(), is.targetSpeedRadPerS()))
        // a recording leaves out most noise of an arm that rests
        .or(() -> stateWas.armRests() && stateIs.armRests() ? Optional.empty() : measured(was, is));
  }

  private static Optional<String> measured(ArmState was, ArmState is) {
    return joints("position", was.actualPositionRad(), is.actualPositionRad())
        .or(() -> joints("speed", was.actualSpeedRadPerS(), is.actualSpeedRadPerS()));
  }

  private static Optional<String> joints(String what, Joints was, Joints is) {
    for (int i = 0; i < Joints.COUNT; i++) {
      long before = Double.doubleToRawLongBits(was.get(i));
      if (before != Double.doubleToRawLongBits(is.get(i))) {
        return Optional.of(
            "the " + what + " of joint " + i + " is " + is.get(i) + ", was " + was.get(i));
      }
    }
    return Optional.empty();
  }

  private static Optional<String> variables(List<VariableSample> was, List<VariableSample> is) {
    if (was.size() != is.size()) {
      return Optional.of("there are " + is.size() + " variables, were " + was.size());
    }
    for (int i = 0; i < was.size(); i++) {
      VariableSample before = was.get(i);
      VariableSample now = is.get(i);
      Optional<String> difference =
          other("variable " + i, before.name(), now.name())
              .or(() -> other("the length of " + now.name(), before.length(), now.length()))
              .or(() -> changed("variable " + now.name(), before.value(), now.value()));
      if (difference.isPresent()) {
        return difference;
      }
    }
    return Optional.empty();
  }

  private static Optional<String> other(String what, Object was, Object is) {
    return Objects.equals(was, is)
        ? Optional.empty()
        : Optional.of(what + " is " + is + ", was " + was);
  }

  /** As {@link #other}, for what is too long to be said. */
  private static Optional<String> changed(String what, Object was, Object is) {
    return Objects.equals(was, is) ? Optional.empty() : Optional.of(what + " has another value");
  }
}
