package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Recordings of controllers that are listened to. */
final class ReceivedRecordingTest {
  private static final ArmDescription UR3E = ArmLibrary.load("ur3e");
  private static final List<String> COLUMNS =
      List.of(
          "timestamp",
          "actual_q_0",
          "actual_q_1",
          "actual_q_2",
          "actual_q_3",
          "actual_q_4",
          "actual_q_5",
          "robot_mode",
          "actual_TCP_pose_0",
          "runtime_state",
          "script_control_line");

  @TempDir private Path folder;

  private static double[] row(double timeS, double q0) {
    return new double[] {timeS, q0, -1, 1, 0, 0.5, 0.25, 7, 0.3, 2, 12};
  }

  private Recording recording(double[]... rows) throws IOException {
    Path file = folder.resolve("some.rec");
    try (ReceivedRecording out =
        new ReceivedRecording(Files.newOutputStream(file), UR3E, COLUMNS)) {
      for (double[] each : rows) {
        out.write(each);
      }
    }
    return RecordingFile.open(file).recording();
  }

  private static List<double[]> rows(Recording recording) {
    List<double[]> rows = new ArrayList<>();
    recording.receivedRows(
        row -> {
          double[] numbers = new double[row.names().size()];
          for (int i = 0; i < numbers.length; i++) {
            numbers[i] = row.value(i);
          }
          rows.add(numbers);
        });
    return rows;
  }

  @Test
  void whatWasSentIsThereToTheBit() throws IOException {
    Recording recording = recording(row(100, 0.1), row(100.008, 0.2), row(100.016, 0.2));

    assertTrue(recording.received());
    assertEquals(UR3E, recording.arm());
    assertEquals(COLUMNS, recording.receivedColumns());
    List<double[]> rows = rows(recording);
    assertEquals(3, rows.size());
    assertArrayEquals(row(100.008, 0.2), rows.get(1));
    assertArrayEquals(row(100.016, 0.2), rows.get(2));
    assertEquals(100, recording.firstS());
    assertEquals(100.016, recording.lastS());
  }

  @Test
  void snapshotsHaveWhatIsToldAndNothingElse() throws IOException {
    ControllerState state = recording(row(100, 0.1), row(100.008, 0.2)).at(100.004);

    assertEquals(new Joints(0.1, -1, 1, 0, 0.5, 0.25), state.arm().actualPositionRad());
    assertEquals(RobotMode.RUNNING, state.safety().robotMode());
    assertEquals(12, state.program().line());
    assertTrue(Double.isNaN(state.arm().targetPositionRad().get(0)), "target_q was not sent");
    assertTrue(Double.isNaN(state.readings().currentA().get(0)), "currents were not sent");
    assertEquals(Pose.ZERO, state.arm().tool().inFlange());
  }

  @Test
  void everyQuantityCanBeAskedFor() throws IOException {
    Recording recording = recording(row(100, 0.1), row(100.008, 0.2));

    for (StateQuantity each : StateQuantities.all()) {
      assertEquals(each.size(), each.numbers(recording.atFrame(50_002)).length);
    }
    assertEquals(List.of(), recording.marks());
  }

  @Test
  void rowsWhoseTimeDoesNotGoOnAreLeftOut() throws IOException {
    try (ReceivedRecording out =
        new ReceivedRecording(Files.newOutputStream(folder.resolve("some.rec")), UR3E, COLUMNS)) {
      assertTrue(out.write(row(100, 0.1)));
      assertFalse(out.write(row(100, 0.2)));
      assertFalse(out.write(row(99, 0.2)));
      assertFalse(out.write(row(Double.NaN, 0.2)));
      assertTrue(out.write(row(100.002, 0.3)));
    }
    assertEquals(2, rows(RecordingFile.open(folder.resolve("some.rec")).recording()).size());
  }

  @Test
  void aStretchOfItIsOneAsWell() throws IOException {
    Recording recording = recording(row(100, 0.1), row(100.008, 0.2), row(100.016, 0.3));
    Path part = folder.resolve("part.rec");

    RecordingExport.toRec(recording, 100.008, 100.016, part);
    Recording again = RecordingFile.open(part).recording();
    assertTrue(again.received());
    assertEquals(2, rows(again).size());
  }

  @Test
  void withoutATimeThereIsNone() {
    assertThrows(
        IllegalArgumentException.class,
        () ->
            new ReceivedRecording(
                Files.newOutputStream(folder.resolve("some.rec")), UR3E, List.of("actual_q_0")));
  }
}
