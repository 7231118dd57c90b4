package org.pendant.recording;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.script.variables.VariablePath;

/**
 * CSV recorder: writes snapshots as comma-separated values: a header, then one row a frame with
 * time (s), target and actual joint positions (rad) and speeds (rad/s), target and actual pose of
 * the TCP in the base frame (m, rotation vector in rad), the program's line, and the variables that
 * were asked for. Numbers have full double precision and a point, whatever the country; a variable
 * without a number leaves its field empty. What it flushes is whole rows, the header at once.
 */
public final class Recorder implements Closeable {
  private static final int BUFFER_CHARS = 1 << 16;
  private static final List<StateQuantity> QUANTITIES =
      Stream.of("target_q", "target_qd", "actual_q", "actual_qd", "target_tcp", "actual_tcp")
          .map(StateQuantities::of)
          .toList();

  private final Writer out;
  private final List<String> variables;
  private final StringBuilder row = new StringBuilder(1024);
  private ArmStateText armText = ArmStateText.NONE;
  private int unflushed;

  /** The text of joints and poses, kept because an arm at rest repeats it in every row. */
  private record ArmStateText(
      Joints target,
      Joints targetSpeed,
      Joints actual,
      Joints actualSpeed,
      Pose toolInFlange,
      String text) {
    static final ArmStateText NONE =
        new ArmStateText(Joints.ZERO, Joints.ZERO, Joints.ZERO, Joints.ZERO, Pose.ZERO, "");

    boolean fits(ArmState state) {
      return !text.isEmpty()
          && target.equals(state.targetPositionRad())
          && targetSpeed.equals(state.targetSpeedRadPerS())
          && actual.equals(state.actualPositionRad())
          && actualSpeed.equals(state.actualSpeedRadPerS())
          && toolInFlange.equals(state.tool().inFlange());
    }
  }

  /** Records to {@code out}, which is closed with the recorder, and writes the header. */
  public Recorder(Writer out) throws IOException {
    this(out, List.of());
  }

  /**
   * As {@link #Recorder(Writer)}, with a column for each of {@code variables}, called {@code var:}
   * and its path. The controller has to trace them.
   */
  public Recorder(Writer out, List<VariablePath> variables) throws IOException {
    this.out = out;
    this.variables = variables.stream().map(VariablePath::text).toList();
    StringBuilder header = new StringBuilder("time_s");
    for (StateQuantity each : QUANTITIES) {
      for (int i = 0; i < each.size(); i++) {
        header.append(',').append(each.name()).append('_').append(i);
      }
    }
    header.append(",line");
    this.variables.forEach(name -> header.append(",var:").append(name));
    out.append(header).append('\n');
    out.flush();
  }

  /** As {@link #Recorder(Writer, List)}, to a file that is closed with the recorder. */
  public static Recorder to(OutputStream file, List<VariablePath> variables) throws IOException {
    return new Recorder(
        new BufferedWriter(new OutputStreamWriter(file, StandardCharsets.US_ASCII), BUFFER_CHARS),
        variables);
  }

  /** Appends the row of one frame. */
  public void write(ControllerState state) throws IOException {
    if (!armText.fits(state.arm())) {
      armText = text(state);
    }
    row.setLength(0);
    row.append(state.timeS()).append(armText.text());
    row.append(',').append(state.program().line());
    for (String name : variables) {
      double value = state.traced().value(name);
      row.append(',');
      if (!Double.isNaN(value)) {
        row.append(value);
      }
    }
    out.append(row.append('\n'));
    unflushed += row.length();
    if (unflushed >= BUFFER_CHARS) {
      unflushed = 0;
      out.flush();
    }
  }

  private ArmStateText text(ControllerState state) {
    row.setLength(0);
    for (StateQuantity each : QUANTITIES) {
      for (double number : each.numbers(state)) {
        row.append(',').append(number);
      }
    }
    ArmState arm = state.arm();
    return new ArmStateText(
        arm.targetPositionRad(),
        arm.targetSpeedRadPerS(),
        arm.actualPositionRad(),
        arm.actualSpeedRadPerS(),
        arm.tool().inFlange(),
        row.toString());
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
