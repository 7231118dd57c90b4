package org.pendant.models.calibration;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.LinkFrame;
import org.pendant.models.arm.LinkFrames;

class CalibrationFileTest {
  /** A UR10e as ROS keeps it. */
  static final String YAML =
      """
      # of one arm
      kinematics:
        shoulder:
          x: 0
          y: 0
          z: 0.1810949508145422   # m
          roll: -0
          pitch: 0
          yaw: 1.04e-07
        upper_arm:
          x: -1.66e-05
          y: 0
          z: 0
          roll: 1.570008587286171
          pitch: 0
          yaw: 1.08e-06
        forearm: {x: -0.6125194958024353, y: 0, z: 0, roll: 3.140726981885666,
                  pitch: 3.139773859813499, yaw: -3.141591402263981}
        wrist_1: {x: -0.5713063516014969, y: 0.0002174, z: 0.1745231697557756, roll: 3.1403, pitch: -3.1407, yaw: -3.1416}
        wrist_2: {x: -2.4e-05, y: -0.1197882240806239, z: 7.4e-05, roll: 1.570175415778306, pitch: 0, yaw: -3.1e-07}
        wrist_3:
          {x: 8.4e-05, y: 0.1156939974082344, z: 1.5e-05, roll: 1.5709, pitch: 3.141592653589793, yaw: 3.1416}
        hash: calib_3437785250745286433
      """;

  static final String CONF =
      """
      [mounting]
      delta_theta = [ 1e-3, 0, 0, 0, 0, -2.5E-7 ]
      delta_a = [2.122e-05, .5, 0, 0, 0, 0] # m
      delta_d = [0, 439.140974079901, -446.0, 6.9, 0, 0]
      delta_alpha = [-0.00065, 0.0013941666682559, 0, 0, 0, 0]
      joint_checksum = [0xadbb5, 0xFFFFFFFF, 4294967295, -1, 17, 0]
      calibration_status = 2 # 0 == notInitialized / 1 == notLinearised / 2 == Linearised
      joint_raw_offset = [1, 2]
      """;

  private static Calibration read(String name, String text) throws CalibrationTrouble {
    return CalibrationFile.read(name, text.getBytes(StandardCharsets.UTF_8));
  }

  private static String trouble(String name, String text) {
    return assertThrows(CalibrationTrouble.class, () -> read(name, text)).getMessage();
  }

  @Test
  void readsTheFramesOfRosAsBlocksAndInBraces() throws CalibrationTrouble {
    Calibration read = read("my_robot_calibration.yaml", YAML);
    List<LinkFrame> frames = ((LinkFrames) read.geometry()).frames();
    assertEquals(new LinkFrame(0, 0, 0.1810949508145422, -0.0, 0, 1.04e-07), frames.get(0));
    assertEquals(new LinkFrame(-1.66e-05, 0, 0, 1.570008587286171, 0, 1.08e-06), frames.get(1));
    assertEquals(-3.141591402263981, frames.get(2).yawRad());
    assertEquals(0.0002174, frames.get(3).yM());
    assertEquals(3.1416, frames.get(5).yawRad());
    assertEquals(Calibration.Status.LINEARISED, read.status());
    assertEquals(read, read("b.YML", YAML.replace("\n", "\r\n")));
  }

  @Test
  void readsTheDeltasOfAController() throws CalibrationTrouble {
    Calibration read = read("calibration.conf", CONF);
    assertEquals(
        new DhDeltas(
            new Joints(1e-3, 0, 0, 0, 0, -2.5e-7),
            new Joints(2.122e-05, 0.5, 0, 0, 0, 0),
            new Joints(0, 439.140974079901, -446, 6.9, 0, 0),
            new Joints(-0.00065, 0.0013941666682559, 0, 0, 0, 0)),
        read.geometry());
    assertEquals(List.of(0xadbb5, -1, -1, -1, 17, 0), read.jointChecksums());
    assertEquals(Calibration.Status.LINEARISED, read.status());
  }

  @Test
  void makesChecksumsWhereThereAreNone() throws CalibrationTrouble {
    String without =
        CONF.replaceAll("joint_checksum.*\n", "").replaceAll("calibration_status.*\n", "");
    Calibration read = read("a.conf", without);
    assertEquals(Calibration.of(read.geometry()), read);
  }

  @Test
  void aControllerWithoutCalibrationHasAnArmLikeItsModel() throws CalibrationTrouble {
    String zeros = "[0, 0, 0, 0, 0, 0]";
    Calibration read =
        read(
            "a.conf",
            "delta_theta = %s\ndelta_a = %s\ndelta_d = %s\ndelta_alpha = %s\n"
                .formatted(zeros, zeros, zeros, zeros));
    assertEquals(Calibration.NONE, read);
  }

  @Test
  void whatIsWrittenReadsTheSameAgain() throws CalibrationTrouble {
    for (Calibration each : List.of(read("a.conf", CONF), read("a.yaml", YAML))) {
      assertEquals(each, CalibrationFile.ofText(CalibrationFile.text(each)));
    }
  }

  @Test
  void refusesWhatItDoesNotKnow() {
    assertEquals("a.txt: must end in .yaml, .yml or .conf", trouble("a.txt", YAML));
    assertEquals(
        "a.yaml: has more than 262144 bytes, no calibration is that large",
        trouble("a.yaml", " ".repeat(CalibrationFile.MAX_BYTES + 1)));
  }

  /** What is changed in {@link #YAML}, to what, and what is said about it. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      ignoreLeadingAndTrailingWhitespace = false,
      value = {
        "kinematics:|joints:|2:1: found joints, expected kinematics",
        "forearm:|elbow:|17:3: found elbow, expected shoulder, upper_arm, forearm, wrist_1,"
            + " wrist_2, wrist_3, hash",
        "yaw: 1.04e-07|jaw: 0|9:5: found jaw, expected x, y, z, roll, pitch, yaw",
        "yaw: 1.04e-07|# nothing|4:5: yaw is missing",
        "yaw: 1.04e-07|yaw: fast|9:10: yaw: found fast, expected a number",
        "yaw: 1.04e-07|yaw: 1e999|9:10: yaw: found 1e999, expected a number",
        "yaw: 1.04e-07|yaw:|9:9: yaw: found nothing, expected a number",
        "yaw: 1.04e-07|yaw: [0]|9:10: found '[', expected a number, a word or a mapping",
        "yaw: 1.04e-07|yaw: *other|9:10: found '*', expected a number, a word or a mapping",
        "yaw: 1.04e-07|yaw: 1 2|9:12: found '2', expected the end of the line",
        "yaw: 1.04e-07|yaw 0|9:9: found '0', expected : after yaw",
        "yaw: 1.04e-07|yaw:0|9:9: found '0', expected a space after the colon of yaw",
        "yaw: 1.04e-07|x: 0|9:5: found x a second time, expected it once",
        "  upper_arm|   upper_arm|10:4: found 'u', expected a key as far in as the others",
        "roll: -0|roll: 0.5|4:5: shoulder: roll is 0.5 rad, must be 0: the first joint turns about"
            + " the z axis of the base",
        "yaw: 3.1416}|yaw: 3.1416|23:3: found 'h', expected , or }",
        "yaw: 3.1416}|yaw: 3.1416; }|22:104: found ';', expected , or }",
      })
  void saysWhereYamlIsNoCalibration(String text, String changed, String message) {
    String wrong = YAML.replace(text, changed);
    assertEquals("my.yaml:" + message, trouble("my.yaml", wrong));
  }

  @Test
  void yamlWithoutAnEndOrWithTooMuchInsideIsRefused() {
    assertEquals(
        "a.yaml:1:10: found the end of the file, expected }", trouble("a.yaml", "a: {b: 1,"));
    assertEquals(
        "a.yaml:1:1: found the end of the file, expected a key as far in as the others",
        trouble("a.yaml", ""));
    assertEquals(
        "a.yaml:1:32: found '{', expected at most 8 mappings in one another",
        trouble("a.yaml", "a: " + "{a: ".repeat(100)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      ignoreLeadingAndTrailingWhitespace = false,
      value = {
        "delta_a = |delta_b = |a.conf: delta_a is missing, expected delta_a = [six numbers]",
        "[2.122e-05, .5, 0, 0, 0, 0]|[1, 2]|a.conf:3:11: delta_a: found 2 numbers, expected 6",
        "[2.122e-05, .5, 0, 0, 0, 0]|0|a.conf:3:11: delta_a: found 0, expected [six numbers]",
        "[2.122e-05, .5,|[2.122e-05, half,|a.conf:3:23: delta_a: found half, expected a number",
        "0xadbb5|0x1adbb5ffff|a.conf:6:19: joint_checksum: found 0x1adbb5ffff, expected a number of"
            + " 32 bits",
        "calibration_status = 2|calibration_status = 7|a.conf:7:22: calibration_status: found 7,"
            + " expected 0, 1 or 2",
        "joint_raw_offset = [1, 2]|delta_a = [0]|a.conf:8:11: found delta_a a second time, expected"
            + " it once",
      })
  void saysWhereAConfIsNoCalibration(String text, String changed, String message) {
    assertEquals(message, trouble("a.conf", CONF.replace(text, changed)));
  }
}
