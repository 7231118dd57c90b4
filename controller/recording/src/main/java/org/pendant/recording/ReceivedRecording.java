package org.pendant.recording;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.time.FrameTime;
import org.pendant.script.variables.TracedVariables;

/**
 * Received recording: writes what a controller, of Pendant or of a real robot, sends by RTDE as a
 * {@code .rec} file. Each column is kept as it was sent, in the way of traced variables; beside
 * that the snapshots have what they can take from the columns. Numbers of a snapshot that no column
 * tells are NaN, and other parts of it are those of a controller that is switched off and has done
 * nothing. One thread uses it.
 */
public final class ReceivedRecording implements Closeable {
  /** The column with the time, s since the controller was switched on. */
  public static final String TIME = "timestamp";

  private static final int NOT_KEPT = -1;

  private final OutputStream out;
  private final int timeColumn;
  private final int[] places;
  private final ReceivedParts parts;
  private final Snapshots snapshots;
  private final double[] numbers = new double[NumberGroup.NUMBERS];
  private TracedVariables traced;
  private Optional<RecordingWriter> writer = Optional.empty();
  private long lastFrame = Long.MIN_VALUE;

  /**
   * A recording that begins with its first row.
   *
   * @param out gets the file, and is closed with the recording
   * @param arm that the controller has, which RTDE does not tell
   * @param columns names of the numbers of a row, as tables of RTDE call them, such as {@code
   *     actual_q_0}; {@link #TIME} is among them
   */
  public ReceivedRecording(OutputStream out, ArmDescription arm, List<String> columns) {
    this.out = out;
    timeColumn = columns.indexOf(TIME);
    if (timeColumn < 0) {
      throw new IllegalArgumentException("there is no column " + TIME + " among " + columns);
    }
    Map<String, Integer> kept = keptColumns();
    places = columns.stream().mapToInt(name -> kept.getOrDefault(name, NOT_KEPT)).toArray();
    ControllerState nothing =
        new Controller(
                ControllerOptions.headless()
                    .withRobot(arm)
                    .withCalibration(arm.calibration())
                    .withPower(false))
            .state();
    parts = new ReceivedParts(nothing, columns);
    snapshots = new Snapshots(arm, new ForwardKinematics(arm));
    traced = TracedVariables.of(columns, new double[columns.size()]);
    Arrays.fill(numbers, Double.NaN);
  }

  /** Where the numbers of RTDE's columns are kept that a snapshot has as they are. */
  private static Map<String, Integer> keptColumns() {
    Map<String, Integer> places = new HashMap<>();
    for (StateQuantity quantity : StateQuantities.all()) {
      for (int i = 0; i < quantity.size(); i++) {
        Optional<Column.Reading.Kept> kept = NumberGroup.keeping(quantity, i);
        if (kept.isPresent()) {
          int place = NumberGroup.placeOf(kept.get());
          columns(quantity, i).forEach(name -> places.put(name, place));
        }
      }
    }
    return places;
  }

  /** What RTDE's tables call a component of a quantity. */
  private static List<String> columns(StateQuantity quantity, int component) {
    if (quantity.fieldEach()) {
      return List.of(quantity.rtdeNames().get(component));
    }
    return quantity.rtdeNames().stream()
        .map(name -> quantity.size() == 1 ? name : name + "_" + component)
        .toList();
  }

  /**
   * Takes the next row.
   *
   * @param row a number for each column
   * @return false if its time is not after that of the row before, in whole frames, or is none: it
   *     is left out
   */
  public boolean write(double... row) throws IOException {
    double frame = Math.rint(row[timeColumn] * FrameTime.FRAMES_PER_SECOND);
    if (!(Math.abs(frame) < 1L << 52) || frame <= lastFrame) {
      return false;
    }
    lastFrame = (long) frame;
    for (int i = 0; i < row.length; i++) {
      if (places[i] != NOT_KEPT) {
        numbers[places[i]] = row[i];
      }
    }
    traced = traced.withValues(row);
    ControllerState state = snapshot();
    if (writer.isPresent()) {
      writer.get().write(state);
    } else {
      writer = Optional.of(new RecordingWriter(out, state, 0, true));
    }
    return true;
  }

  private ControllerState snapshot() {
    Segment one =
        Segment.full(
            lastFrame,
            new int[] {0},
            new int[] {NumberGroup.ALL},
            new int[] {SnapshotPart.ALL},
            numbers.clone(),
            parts.of(traced));
    return snapshots.of(new SegmentCursor(one, 1).to(0), lastFrame);
  }

  /** Writes what is left; without a single row nothing was written. */
  @Override
  public void close() throws IOException {
    if (writer.isPresent()) {
      writer.get().close();
    } else {
      out.close();
    }
  }
}
