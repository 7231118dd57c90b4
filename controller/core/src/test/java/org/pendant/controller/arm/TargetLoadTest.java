package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;

/** What a real controller says of its torques, in public recordings, against our model. */
class TargetLoadTest {
  private static final int N = Joints.COUNT;

  /** Postures of a real UR10e at rest without payload, and its target moments and currents. */
  private static final double[][] POSTURES = {
    {-0.2792, -1.9458, -1.6659, -1.5276, 0.9891, 0.3912},
    {0, 67.8158, 37.7559, 2.6838, -0.4485, 0},
    {0, 5.6627, 3.8375, 0.2494, -0.0417, 0},
    {0, -1.5708, 0, -2.5722, 0, 0},
    {0, 2.7700, 2.7703, 2.7702, -0.7553, 0},
    {0, 0.2313, 0.2816, 0.2574, -0.0702, 0},
    {0, -1.5708, -0.2808, -1.5708, 0, 0},
    {0, 11.8151, 11.8150, 0.9117, -0.2486, 0},
    {0, 0.9866, 1.2009, 0.0847, -0.0231, 0},
    {0.1814, -0.2122, 0.3616, -1.6757, 4.9308, -2.5315},
    {0, -122.3794, -42.1474, -3.2470, 0.1941, 0},
    {0, -10.2188, -4.2839, -0.3017, 0.0180, 0},
    {-0.9373, -2.5548, 2.2132, -1.2303, 4.7275, -4.1073},
    {0, 27.9873, -40.3561, -3.2902, 0.0135, 0},
    {0, 2.3370, -4.1018, -0.3057, 0.0013, 0},
    {0.2417, -2.5840, -1.5110, -2.9025, 6.1040, -4.1076},
    {0, 90.3815, 20.7428, -2.0339, 0.5781, 0},
    {0, 7.5470, 2.1083, -0.1890, 0.0537, 0}
  };

  /** A row of a recording by the names of its columns. */
  private record Row(List<String> columns, List<String> cells) {
    Joints joints(String field) {
      double[] values = new double[N];
      for (int i = 0; i < N; i++) {
        values[i] = Double.parseDouble(cells.get(columns.indexOf(field + "_" + i)));
      }
      return Joints.of(values);
    }
  }

  private static Stream<Row> recording(String name) {
    try {
      List<String> lines = Files.readAllLines(Path.of("../../docs/recordings", name));
      List<String> columns = List.of(lines.getFirst().split(","));
      return lines.stream().skip(1).map(line -> new Row(columns, List.of(line.split(","))));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static double rms(double[] squares, int joint, int count) {
    return Math.sqrt(squares[joint] / count);
  }

  private static Joints currentsOf(TargetLoad load) {
    SimulatedSensors sensors = new SimulatedSensors();
    load.publish(sensors);
    return sensors.targetCurrentA();
  }

  @Test
  void restingUr10eNeedsTheRecordedMomentsAndCurrents() {
    ArmDescription arm = ArmLibrary.load("ur10e");
    TargetLoad load = new TargetLoad(arm, new ArmDynamics(arm));
    for (int row = 0; row < POSTURES.length; row += 3) {
      load.of(Rig.hold(Joints.of(POSTURES[row])));
      Joints currentsA = currentsOf(load);
      for (int i = 0; i < N; i++) {
        String where = "posture " + row / 3 + ", joint " + i;
        assertEquals(POSTURES[row + 1][i], load.momentNm[i], 0.004, where);
        assertEquals(POSTURES[row + 2][i], currentsA.get(i), 0.0005, where);
      }
    }
  }

  @Test
  void movingUr3eNeedsTheRecordedMomentsAndCurrents() {
    ArmDescription arm = ArmLibrary.load("ur3e");
    ArmDynamics model = new ArmDynamics(arm);
    model.setPayload(Payload.of(1.07, 0, 0, 0.058));
    TargetLoad load = new TargetLoad(arm, model);
    List<Row> rows =
        Stream.of("ur3e-rad-1.csv", "ur3e-rad-3.csv", "ur3e-rad-5.csv")
            .flatMap(TargetLoadTest::recording)
            .toList();
    double[] moments = new double[N];
    double[] currents = new double[N];
    for (Row row : rows) {
      load.of(
          new ArmCommand.Servo(
              row.joints("target_q"), row.joints("target_qd"), row.joints("target_qdd")));
      Joints currentsA = currentsOf(load);
      for (int i = 0; i < N; i++) {
        moments[i] += Math.pow(load.momentNm[i] - row.joints("target_moment").get(i), 2);
        currents[i] += Math.pow(currentsA.get(i) - row.joints("target_current").get(i), 2);
      }
    }
    for (int i = 0; i < N; i++) {
      double momentNm = rms(moments, i, rows.size());
      double currentA = rms(currents, i, rows.size());
      assertTrue(momentNm < 0.018, "moment of joint " + i + " off by " + momentNm + " Nm rms");
      assertTrue(currentA < 0.008, "current of joint " + i + " off by " + currentA + " A rms");
    }
  }

  @Test
  void atStandstillThereIsNoFrictionInTheCurrent() {
    ArmDescription arm = ArmLibrary.load("ur3e");
    TargetLoad load = new TargetLoad(arm, new ArmDynamics(arm));

    load.of(Rig.hold(Rig.START));

    Joints currentsA = currentsOf(load);
    for (int i = 0; i < N; i++) {
      double constant = arm.actuators().get(i).torqueConstantNmPerA();
      assertEquals(load.momentNm[i] / constant, currentsA.get(i));
    }
  }
}
