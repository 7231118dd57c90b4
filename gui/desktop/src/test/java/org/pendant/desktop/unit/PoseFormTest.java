package org.pendant.desktop.unit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/** Poses in the forms in which people read them. */
final class PoseFormTest {
  private static final PoseForm RPY =
      new PoseForm(DisplayUnit.MILLIMETRE, DisplayUnit.DEGREE, RotationForm.ROLL_PITCH_YAW);

  @Test
  void aQuarterTurnAboutZIsAQuarterYaw() {
    double[] numbers = RPY.numbers(new Pose(1, 2, 3, 0, 0, Math.PI / 2));
    assertArrayEquals(new double[] {1, 2, 3, 0, 0, Math.PI / 2}, numbers, 1e-15);
    assertEquals(List.of("X", "Y", "Z", "Roll", "Pitch", "Yaw"), RPY.labels());
  }

  @Test
  void turnsAreAboutTheFixedAxesXThenYThenZ() {
    Pose expected =
        Poses.add(
            new Pose(0, 0, 0, 0, 0, 0.3),
            Poses.add(new Pose(0, 0, 0, 0, 0.2, 0), new Pose(0, 0, 0, 0.1, 0, 0)));
    Pose pose = RPY.pose(new double[] {0, 0, 0, 0.1, 0.2, 0.3});
    assertEquals(0, Poses.rotationAngle(expected, pose), 1e-12);
  }

  @Test
  void everyFormGivesThePoseBack() {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 1000; i++) {
      double[] components = random.doubles(6, -1.7, 1.7).toArray();
      Pose pose = Pose.of(components);
      for (RotationForm rotation : RotationForm.values()) {
        PoseForm form = new PoseForm(DisplayUnit.INCH, DisplayUnit.RADIAN, rotation);
        Pose back = form.pose(form.numbers(pose));
        assertEquals(0, Poses.pointDistance(pose, back), 1e-12, () -> form + " of " + pose);
        assertEquals(0, Poses.rotationAngle(pose, back), 1e-7, () -> form + " of " + pose);
      }
    }
  }

  /** A tool that points down, turned by 45 degrees: as much to the one as to the other side. */
  @Test
  void halfATurnHasOneSignWhateverTheNoise() {
    SplittableRandom random = new SplittableRandom(11);
    double part = Math.PI / Math.sqrt(2);
    for (double[] axis :
        List.of(
            new double[] {part, part, 0},
            new double[] {part, -part, 0},
            new double[] {0, Math.PI, 0})) {
      for (int i = 0; i < 1000; i++) {
        double sign = random.nextBoolean() ? 1 : -1;
        double[] noisy = new double[3];
        for (int k = 0; k < 3; k++) {
          noisy[k] = sign * axis[k] + random.nextDouble(-1e-3, 1e-3);
        }
        Pose pose = new Pose(0, 0, 0, noisy[0], noisy[1], noisy[2]);
        for (RotationForm rotation : RotationForm.values()) {
          PoseForm form = new PoseForm(DisplayUnit.MILLIMETRE, DisplayUnit.DEGREE, rotation);
          double[] exact = form.numbers(new Pose(0, 0, 0, axis[0], axis[1], axis[2]));
          double[] shown = form.numbers(pose);
          assertArrayEquals(exact, shown, 0.02, () -> form + " of " + pose);
          assertEquals(0, Poses.rotationAngle(pose, form.pose(shown)), 1e-7, pose::toString);
        }
      }
    }
    PoseForm vector = PoseForm.STANDARD;
    assertEquals("127.28\u00b0", vector.readings(new Pose(0, 0, 0, -part, -part, 0)).get(3));
    assertEquals("-127.28\u00b0", vector.readings(new Pose(0, 0, 0, -part, part, 0)).get(4));
    assertEquals("-90.00\u00b0", vector.readings(new Pose(0, 0, 0, -Math.PI / 2, 0, 0)).get(3));
  }

  @Test
  void aPoseIsReadInTheChosenUnits() {
    Pose pose = new Pose(0.45, -0.3, 0.15, 0, 0, Math.PI / 2);
    assertEquals("450.00, -300.00, 150.00 mm", RPY.place(pose));
    assertEquals(
        List.of("450.00 mm", "-300.00 mm", "150.00 mm", "0.00\u00b0", "0.00\u00b0", "90.00\u00b0"),
        RPY.readings(pose));
    assertEquals(
        "450.00, -300.00, 150.00 mm\nRoll 0.00\u00b0, Pitch 0.00\u00b0, Yaw 90.00\u00b0",
        RPY.words(pose));
  }
}
