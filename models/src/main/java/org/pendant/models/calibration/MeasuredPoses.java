package org.pendant.models.calibration;

import static org.pendant.models.calibration.CalibrationTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.pendant.models.arm.Joints;
import org.pendant.models.json.FilePosition;
import org.pendant.models.kinematics.MeasuredPose;
import org.pendant.models.pose.Pose;

/**
 * Measured poses in a table of comma-separated values: a line of names, {@code q_0} to {@code q_5}
 * (rad), {@code x}, {@code y}, {@code z} (m), {@code rx}, {@code ry} and {@code rz} (rad) among
 * them in any order, then a pose a line.
 */
public final class MeasuredPoses {
  private static final List<String> NAMES =
      List.of("q_0", "q_1", "q_2", "q_3", "q_4", "q_5", "x", "y", "z", "rx", "ry", "rz");

  private static final int MAX_POSES = 10_000;

  private final String file;
  private final int[] columns = new int[NAMES.size()];
  private final List<MeasuredPose> poses = new ArrayList<>();

  private MeasuredPoses(String file) {
    this.file = file;
  }

  /**
   * Reads a table.
   *
   * @param file its name, for messages
   * @throws CalibrationTrouble if it is none
   */
  public static List<MeasuredPose> read(String file, byte[] bytes) throws CalibrationTrouble {
    MeasuredPoses reader = new MeasuredPoses(file);
    int number = 0;
    for (String line : new String(bytes, StandardCharsets.UTF_8).split("\n", -1)) {
      number++;
      if (number == 1) {
        reader.names(line);
      } else if (!line.isBlank()) {
        reader.pose(number, line.split(",", -1));
      }
    }
    return reader.poses;
  }

  private void names(String line) throws CalibrationTrouble {
    List<String> found = Arrays.stream(line.split(",", -1)).map(String::strip).toList();
    for (int i = 0; i < columns.length; i++) {
      columns[i] = found.indexOf(NAMES.get(i));
      if (columns[i] < 0) {
        throw CalibrationTrouble.at(
            new FilePosition(file, 1, 1),
            text("columnMissing", NAMES.get(i), String.join(",", NAMES)));
      }
    }
  }

  private void pose(int line, String[] cells) throws CalibrationTrouble {
    double[] values = new double[columns.length];
    for (int i = 0; i < columns.length; i++) {
      String cell = columns[i] < cells.length ? cells[columns[i]].strip() : "";
      String name = NAMES.get(i);
      int column = 1;
      for (int before = 0; before < Math.min(columns[i], cells.length); before++) {
        column += cells[before].length() + 1;
      }
      FilePosition place = new FilePosition(file, line, column);
      values[i] =
          CalibrationNumbers.number(cell)
              .orElseThrow(
                  () ->
                      CalibrationTrouble.at(
                          place, text("noNumber", name, cell.isEmpty() ? text("nothing") : cell)));
    }
    if (poses.size() == MAX_POSES) {
      throw CalibrationTrouble.at(new FilePosition(file, line, 1), text("tooManyPoses", MAX_POSES));
    }
    poses.add(
        new MeasuredPose(
            Joints.of(Arrays.copyOf(values, Joints.COUNT)),
            Pose.of(Arrays.copyOfRange(values, Joints.COUNT, values.length))));
  }
}
