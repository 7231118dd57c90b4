package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.calibration.CalibrationFile;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;

/** Calibrated arms on the command line. */
@Tag("slow")
class CalibrationTest {
  private static final ArmDescription UR10E = ArmLibrary.load("ur10e");
  private static final String CONF =
      """
      delta_theta = [-2.41e-07, 1.60233952386695, -1.68607190752171, 0.0837331147700119, 0, 0]
      delta_a = [2.122e-05, 0.6320171326277006, 0.002298336388912, -4.614e-05, -6.393e-05, 0]
      delta_d = [-0.000160188285741, 439.140974079901, -446.027059806332, 6.8861868964236, 0, 0]
      delta_alpha = [-0.00065, 0.0013941666682559, 0.00693818880325995, -0.0008116, 0.0004111, 0]
      """;
  private static final String SAY =
      """
      q = [0.3, -1.4, 1.9, -2.1, -1.5, 0.4]
      movej(q, a=40, v=30)
      textmsg(get_forward_kin(q))
      goal = pose_add(get_target_tcp_pose(), p[0, 0.05, 0.02, 0, 0, 0])
      textmsg(point_dist(get_forward_kin(get_inverse_kin(goal)), goal) < 1e-9)
      movel(goal)
      textmsg(point_dist(get_actual_tcp_pose(), goal) < 1e-4)
      """;

  @TempDir private Path folder;
  private final ByteArrayOutputStream output = new ByteArrayOutputStream();
  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  private void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  /** Answers the exit code; words that are files stand in the folder of the test. */
  private int pendant(String... words) {
    output.reset();
    errors.reset();
    List<String> all = new ArrayList<>();
    for (String each : words) {
      all.add(each.contains(".") && !each.startsWith("-") ? folder.resolve(each).toString() : each);
    }
    return new Pendant(new Console(output, errors)).run(all).number();
  }

  private String said() {
    return output.toString(StandardCharsets.UTF_8);
  }

  /** Complaints without the folder of the test. */
  private String complaints() {
    return errors.toString(StandardCharsets.UTF_8).replace(folder + "/", "");
  }

  private static ArmDescription calibrated(String conf) throws CalibrationTrouble {
    return UR10E.withCalibration(CalibrationFile.ofText(conf));
  }

  @Test
  void programsKnowTheArmByItsCalibration() throws IOException, CalibrationTrouble {
    write("say.script", SAY);
    write("calibration.conf", CONF);
    assertEquals(
        0, pendant("run", "--robot", "ur10e", "--calibration", "calibration.conf", "say.script"));
    assertEquals("", complaints());
    List<String> lines = said().lines().toList();
    assertEquals(List.of("True", "True"), lines.subList(1, 3));
    Joints q = new Joints(0.3, -1.4, 1.9, -2.1, -1.5, 0.4);
    Pose expected = new ForwardKinematics(calibrated(CONF)).flangePose(q);
    String[] numbers = lines.getFirst().replaceAll("[p\\[\\]]", "").split(", ", -1);
    for (int i = 0; i < Pose.SIZE; i++) {
      assertEquals(expected.get(i), Double.parseDouble(numbers[i]), 1e-5);
    }
    assertEquals(0, pendant("run", "--robot", "ur10e", "say.script"));
    assertTrue(!said().startsWith(lines.getFirst()), said());
  }

  @Test
  void theKinematicsOfAUrpAreACalibration() throws IOException {
    write("say.script", SAY);
    write("calibration.conf", CONF);
    write(
        "made.urp",
        """
        <URProgram name="made"><kinematics status="LINEARIZED" validChecksum="true">
        <deltaTheta value="-2.41E-7, 1.60233952386695, -1.68607190752171, 0.0837331147700119, 0.0, 0.0"/>
        <a value="2.122E-5, 0.0193171326277006, -0.569251663611088, -4.614E-5, -6.393E-5, 0.0"/>
        <d value="0.180539811714259, 439.140974079901, -446.027059806332, 7.0603368964236, 0.11985, 0.11655"/>
        <alpha value="1.5701463267948966, 0.0013941666682559, 0.00693818880325995, 1.5699847267948966, -1.5703852267948966, 0.0"/>
        <jointChecksum value="1, 2, 3, 4, 5, 6"/></kinematics><children/></URProgram>
        """);
    assertEquals(0, pendant("run", "--robot", "ur10e", "--calibration", "made.urp", "say.script"));
    String ofProgram = said();
    assertEquals("", complaints());
    assertEquals(
        0, pendant("run", "--robot", "ur10e", "--calibration", "calibration.conf", "say.script"));
    assertEquals(said(), ofProgram);
  }

  @Test
  void theKinematicsOfAnInstallationOfPolyScopeAreACalibration() throws IOException {
    write("say.script", SAY);
    write("calibration.conf", CONF);
    Files.createDirectory(folder.resolve("cells"));
    write(
        "cells/default.installation",
        """
        <Installation><kinematics status="LINEARIZED" validChecksum="true">
        <deltaTheta value="-2.41E-7, 1.60233952386695, -1.68607190752171, 0.0837331147700119, 0.0, 0.0"/>
        <a value="2.122E-5, 0.0193171326277006, -0.569251663611088, -4.614E-5, -6.393E-5, 0.0"/>
        <d value="0.180539811714259, 439.140974079901, -446.027059806332, 7.0603368964236, 0.11985, 0.11655"/>
        <alpha value="1.5701463267948966, 0.0013941666682559, 0.00693818880325995, 1.5699847267948966, -1.5703852267948966, 0.0"/>
        <jointChecksum value="1, 2, 3, 4, 5, 6"/></kinematics></Installation>
        """);
    assertEquals(
        0, pendant("run", "--robot", "ur10e", "--calibration", "calibration.conf", "say.script"));
    String expected = said();
    assertEquals(
        0,
        pendant(
            "run",
            "--robot",
            "ur10e",
            "--installation",
            "cells/default.installation",
            "say.script"));
    assertEquals("", complaints());
    assertEquals(expected, said());
    assertEquals(
        0,
        pendant(
            "run",
            "--robot",
            "ur10e",
            "--calibration",
            "cells/default.installation",
            "say.script"));
    assertEquals(expected, said());
    assertEquals(0, pendant("convert", "cells/default.installation", "cells/cell.pinst"));
    assertEquals(
        0, pendant("run", "--robot", "ur10e", "--installation", "cells/cell.pinst", "say.script"));
    assertEquals(expected, said());
  }

  @Test
  void anInstallationOfPolyScopeWithoutKinematicsIsNoCalibration() throws IOException {
    write("say.script", SAY);
    write("bare.installation", "<Installation/>");
    assertEquals(0, pendant("run", "--installation", "bare.installation", "say.script"));
    assertEquals(2, pendant("run", "--calibration", "bare.installation", "say.script"));
    assertTrue(complaints().contains("bare.installation: describes no arm"), complaints());
  }

  @Test
  void aCalibrationThatIsNoneOfTheArmIsRefused() throws IOException {
    write("say.script", SAY);
    write("arm.conf", CONF.replace("439.14", "439.2"));
    assertEquals(2, pendant("run", "--robot", "ur10e", "--calibration", "arm.conf", "say.script"));
    assertTrue(
        complaints().contains("arm.conf puts the flange up to ")
            && complaints()
                .contains(" from where a UR10e has it, must be at most 20 mm; its frame"),
        complaints());
    write("arm.yaml", "kinematics: [1]\n");
    assertEquals(2, pendant("run", "--calibration", "arm.yaml", "say.script"));
    assertTrue(
        complaints().contains("arm.yaml:1:13: found '[', expected a number, a word or a mapping"),
        complaints());
    assertEquals(2, pendant("run", "--calibration", "arm.txt", "say.script"));
    assertTrue(
        complaints().contains("arm.txt, must end in .yaml, .yml, .conf, .urp or .installation"),
        complaints());
    write("none.urp", "<URProgram name=\"none\"><children/></URProgram>");
    assertEquals(2, pendant("run", "--calibration", "none.urp", "say.script"));
    assertTrue(complaints().contains("none.urp: describes no arm"), complaints());
    assertEquals(2, pendant("run", "--calibration", "missing.conf", "say.script"));
    assertTrue(complaints().contains("missing.conf: there is no such file"), complaints());
  }

  @Test
  void anInstallationNamesTheCalibrationThatStandsBesideIt() throws IOException {
    write("say.script", SAY);
    Files.createDirectory(folder.resolve("cells"));
    write("cells/calibration.conf", CONF);
    write(
        "cells/cell.pinst",
        "pendant installation 1\nrobot id=\"ur10e\" calibration=\"calibration.conf\"\n");
    assertEquals(0, pendant("run", "--installation", "cells/cell.pinst", "say.script"));
    String ofInstallation = said();
    assertEquals(
        0,
        pendant(
            "run", "--robot", "ur10e", "--calibration", "cells/calibration.conf", "say.script"));
    assertEquals(said(), ofInstallation);
    Files.delete(folder.resolve("cells/calibration.conf"));
    assertEquals(2, pendant("run", "--installation", "cells/cell.pinst", "say.script"));
    assertTrue(
        complaints().contains("cells/calibration.conf: there is no such file"), complaints());
  }

  private static String poses(int count) throws CalibrationTrouble {
    ForwardKinematics forward = new ForwardKinematics(calibrated(CONF));
    Random random = new Random(1);
    StringBuilder table = new StringBuilder("n,q_0,q_1,q_2,q_3,q_4,q_5,x,y,z,rx,ry,rz\n");
    for (int n = 0; n < count; n++) {
      double[] q = new double[Joints.COUNT];
      table.append(n);
      for (int i = 0; i < q.length; i++) {
        q[i] = 4 * random.nextDouble() - 2;
        table.append(',').append(q[i]);
      }
      Pose pose = forward.flangePose(Joints.of(q));
      for (int i = 0; i < Pose.SIZE; i++) {
        table.append(',').append(pose.get(i));
      }
      table.append('\n');
    }
    return table.toString();
  }

  @Test
  void measuredPosesGiveACalibrationThatProgramsRunWith() throws IOException, CalibrationTrouble {
    write("say.script", SAY);
    write("truth.conf", CONF);
    write("poses.csv", poses(30));
    assertEquals(0, pendant("calibrate", "--robot", "ur10e", "--out", "found.conf", "poses.csv"));
    assertEquals("", complaints());
    List<String> lines = said().lines().toList();
    assertTrue(lines.get(0).startsWith("UR10e, 30 poses, condition number "), said());
    assertTrue(lines.get(1).startsWith("residuals before: mean "), said());
    assertEquals(
        "residuals after: mean 0.0000 mm, max 0.0000 mm, mean 0.0000 mrad, max 0.0000 mrad",
        lines.get(2));
    assertEquals(
        0, pendant("run", "--robot", "ur10e", "--calibration", "truth.conf", "say.script"));
    String truth = said();
    assertEquals(
        0, pendant("run", "--robot", "ur10e", "--calibration", "found.conf", "say.script"));
    assertEquals(truth, said());
    assertEquals(0, pendant("calibrate", "--robot", "ur10e", "poses.csv"));
    assertEquals(Files.readString(folder.resolve("found.conf")), said());
  }

  @Test
  void calibrateRefusesWhatTellsNothing() throws IOException, CalibrationTrouble {
    write("few.csv", poses(7));
    assertEquals(2, pendant("calibrate", "--robot", "ur10e", "few.csv"));
    assertTrue(complaints().contains("few.csv has 7 poses, must be at least 8"), complaints());
    write("poses.csv", poses(12));
    assertEquals(2, pendant("calibrate", "--robot", "ur3e", "poses.csv"));
    assertTrue(
        complaints().contains("the calibration from poses.csv puts the flange up to"),
        complaints());
    write("odd.csv", poses(12).replaceFirst("\n3,", "\n3,fast,"));
    assertEquals(2, pendant("calibrate", "--robot", "ur10e", "odd.csv"));
    assertTrue(
        complaints().contains("odd.csv:5:3: q_0: found fast, expected a number"), complaints());
    write("bare.csv", "x,y,z\n1,2,3\n");
    assertEquals(2, pendant("calibrate", "bare.csv"));
    assertTrue(complaints().contains("bare.csv:1:1: the column q_0 is missing"), complaints());
    assertEquals(2, pendant("calibrate", "--robot", "ur10e", "--out", "poses.csv", "poses.csv"));
    assertTrue(complaints().contains("is the file of poses"), complaints());
    write("there.conf", "");
    assertEquals(2, pendant("calibrate", "--robot", "ur10e", "--out", "there.conf", "poses.csv"));
    assertTrue(complaints().contains("exists already, --force replaces it"), complaints());
  }
}
