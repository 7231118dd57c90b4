package org.pendant.recording;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.controller.state.RuntimeState;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.vm.ProgramState;

/** Parts of snapshots that are made from what a controller sends. */
final class ReceivedParts {
  private static final int BITS_A_BANK = 8;
  private static final int BANK = 0xFF;
  private static final int TOOL_BITS = 3;

  private final Object[] nothing = new Object[SnapshotPart.COUNT];
  private final SafetyStatus off;
  private final List<String> columns;

  /**
   * Parts for these columns.
   *
   * @param nothing has the parts that no column tells
   */
  ReceivedParts(ControllerState nothing, List<String> columns) {
    this.columns = columns;
    for (int i = 0; i < SnapshotPart.COUNT; i++) {
      this.nothing[i] = SnapshotPart.of(i).in(nothing);
    }
    int news = SnapshotPart.NEWS.index();
    this.nothing[news] = ((FrameDelta) this.nothing[news]).old();
    off = nothing.safety();
  }

  /** All parts of a row, each at its index. */
  Object[] of(TracedVariables row) {
    Object[] parts = nothing.clone();
    parts[SnapshotPart.TRACED.index()] = row;
    parts[SnapshotPart.SAFETY.index()] = safety(row);
    numbers(row, "tcp_offset", Pose.SIZE)
        .ifPresent(
            offset -> parts[SnapshotPart.TOOL.index()] = new ToolCentre(Pose.of(offset), ""));
    payload(row).ifPresent(payload -> parts[SnapshotPart.PAYLOAD.index()] = payload);
    whole(row, "runtime_state")
        .flatMap(ReceivedParts::runtime)
        .ifPresent(
            runtime ->
                parts[SnapshotPart.PROGRAM.index()] =
                    new ProgramStatus(
                        state(runtime),
                        runtime,
                        "",
                        whole(row, "script_control_line").orElse(0),
                        Optional.empty()));
    parts[SnapshotPart.IO.index()] = levels(row);
    return parts;
  }

  private SafetyStatus safety(TracedVariables row) {
    Optional<RobotMode> robotMode =
        whole(row, "robot_mode")
            .flatMap(
                code ->
                    Arrays.stream(RobotMode.values()).filter(m -> m.code() == code).findFirst());
    Optional<SafetyMode> safetyMode =
        whole(row, "safety_mode")
            .flatMap(
                code ->
                    Arrays.stream(SafetyMode.values()).filter(m -> m.code() == code).findFirst());
    return new SafetyStatus(
        robotMode.orElse(off.robotMode()),
        safetyMode.orElse(off.safetyMode()),
        Optional.empty(),
        Optional.empty(),
        safetyMode.filter(SafetyMode.REDUCED::equals).isPresent(),
        off.baseLight(),
        false,
        off.checksum());
  }

  private Optional<Payload> payload(TracedVariables row) {
    OptionalDouble mass = number(row, "payload");
    Optional<double[]> cog = numbers(row, "payload_cog", 3);
    if (mass.isEmpty() || mass.getAsDouble() < 0 || cog.isEmpty()) {
      return Optional.empty();
    }
    double[] inertia = numbers(row, "payload_inertia", 6).orElseGet(() -> new double[6]);
    return Optional.of(
        new Payload(
            mass.getAsDouble(),
            cog.get()[0],
            cog.get()[1],
            cog.get()[2],
            inertia[0],
            inertia[1],
            inertia[2],
            inertia[3],
            inertia[4],
            inertia[5]));
  }

  private static Optional<RuntimeState> runtime(int code) {
    return Arrays.stream(RuntimeState.values()).filter(each -> each.code() == code).findFirst();
  }

  private static ProgramState state(RuntimeState runtime) {
    return switch (runtime) {
      case STOPPING, STOPPED -> ProgramState.STOPPED;
      case PLAYING, RESUMING -> ProgramState.RUNNING;
      case PAUSING, PAUSED -> ProgramState.PAUSED;
    };
  }

  /**
   * RTDE has the standard signals from bit 0 on, then eight configurable ones and two of the tool.
   */
  private DigitalLevels levels(TracedVariables row) {
    int in = whole(row, "actual_digital_input_bits").orElse(0);
    int out = whole(row, "actual_digital_output_bits").orElse(0);
    return new DigitalLevels(
        in & BANK,
        out & BANK,
        in >> BITS_A_BANK & BANK,
        out >> BITS_A_BANK & BANK,
        in >> (2 * BITS_A_BANK) & TOOL_BITS,
        out >> (2 * BITS_A_BANK) & TOOL_BITS,
        0);
  }

  private OptionalDouble number(TracedVariables row, String name) {
    double value = columns.contains(name) ? row.value(name) : Double.NaN;
    return Double.isFinite(value) ? OptionalDouble.of(value) : OptionalDouble.empty();
  }

  private Optional<Integer> whole(TracedVariables row, String name) {
    OptionalDouble number = number(row, name);
    return number.isPresent() ? Optional.of((int) (long) number.getAsDouble()) : Optional.empty();
  }

  /** Several numbers; empty unless all are there. */
  private Optional<double[]> numbers(TracedVariables row, String name, int count) {
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      OptionalDouble number = number(row, name + "_" + i);
      if (number.isEmpty()) {
        return Optional.empty();
      }
      numbers[i] = number.getAsDouble();
    }
    return Optional.of(numbers);
  }
}
