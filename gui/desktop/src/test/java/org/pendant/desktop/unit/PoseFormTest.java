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
