package org.pendant.motion.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

final class DeviationWatchTest {
  private static final Joints TARGET = new Joints(0.3, -1.4, -1.6, -1.5, 1.5, 0.2);
  private static final Pose TOOL = new Pose(0.02, -0.03, 0.15, 0.4, 0, 0.1);
  private static final double[] REST = new double[6];

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final DeviationWatch watch = new DeviationWatch(arm);
  private final TaskAxes axes = new TaskAxes();
  private final Pose tcp = new ForwardKinematics(arm).tcpPose(TARGET, TOOL);

  /** Gives way along axis {@code compliant} only; all others may be this far aside. */
  private void begin(FrameKind kind, Pose frame, int compliant, double metres, double radians) {
    List<ForceAxis> all = new ArrayList<>();
    for (int i = 0; i < ForceTask.AXES; i++) {
      all.add(new ForceAxis(i == compliant, 0, i < 3 ? metres : radians));
    }
    ForceTask task = new ForceTask(kind, frame, all);
    axes.begin(task);
    watch.setTool(TOOL);
    watch.setTask(task);
  }

  /** The joints with which the TCP is there. */
  private Joints joints(Pose tcpInBase) {
    Pose flange = Poses.trans(tcpInBase, Poses.inverse(TOOL));
    return new InverseKinematics(arm).closest(flange, TARGET).orElseThrow();
  }

  /** The TCP shifted along the axes of the base, and turned about them. */
  private Joints aside(double x, double y, double z, double rx, double ry, double rz) {
    Pose orientation =
        Poses.trans(new Pose(0, 0, 0, rx, ry, rz), new Pose(0, 0, 0, tcp.rx(), tcp.ry(), tcp.rz()));
    return joints(
        new Pose(
            tcp.x() + x,
            tcp.y() + y,
            tcp.z() + z,
            orientation.rx(),
            orientation.ry(),
            orientation.rz()));
  }

  private Optional<TaskDeviation> look(Joints actual) {
    return watch.look(axes, JointNumbers.of(TARGET), JointNumbers.of(actual));
  }

  /** What is found when the arm has been there for 20 ms. */
  private Optional<TaskDeviation> lasting(Joints actual) {
    Optional<TaskDeviation> found = Optional.empty();
    for (int i = 0; i < DeviationWatch.FRAMES; i++) {
      assertTrue(found.isEmpty(), "before 20 ms");
      found = look(actual);
    }
    return found;
  }

  private void finds(int axis, double amount, double limit, Joints actual) {
    TaskDeviation found = lasting(actual).orElseThrow();
    assertEquals(axis, found.axis());
    assertEquals(amount, found.amount(), 1e-9);
    assertEquals(limit, found.limit());
    watch.forget();
  }

  private void findsNothing(Joints actual) {
    assertEquals(Optional.empty(), lasting(actual));
    assertEquals(Optional.empty(), lasting(actual));
  }

  @Test
  void eachAxisHasItsLimitBothWays() {
    begin(FrameKind.FIXED, Pose.ZERO, -1, 0.01, 0.02);
    finds(0, 0.0101, 0.01, aside(0.0101, 0, 0, 0, 0, 0));
    finds(1, 0.0101, 0.01, aside(0, -0.0101, 0, 0, 0, 0));
    finds(2, 0.0101, 0.01, aside(0, 0, 0.0101, 0, 0, 0));
    finds(3, 0.0201, 0.02, aside(0, 0, 0, 0.0201, 0, 0));
    finds(4, 0.0201, 0.02, aside(0, 0, 0, 0, -0.0201, 0));
    finds(5, 0.0201, 0.02, aside(0, 0, 0, 0, 0, 0.0201));
    findsNothing(aside(0.0099, -0.0099, 0.0099, 0, 0, 0));
    findsNothing(aside(0, 0, 0, 0.0114, 0.0114, -0.0114));
  }

  @Test
  void itIsTheAxesOfTheTaskFrameThatCount() {
    begin(FrameKind.FIXED, new Pose(1, 2, 3, 0, 0, Math.PI / 2), 0, 0.01, 0.02);
    // its x, which gives way, is along y of the base
    findsNothing(aside(0, 0.1, 0, 0, 0, 0));
    finds(1, 0.0101, 0.01, aside(0.0101, 0.1, 0, 0, 0, 0));
  }

  @Test
  void theAxesCountAsTheyAreNow() {
    begin(FrameKind.MOTION, Pose.ZERO, 0, 0.01, 0.02);
    Joints alongY = aside(0, 0.05, 0, 0, 0, 0);
    findsNothing(alongY);
    double[] tcp12 = new double[12];
    axes.update(tcp12, new double[] {0, 0.1, 0, 0, 0, 0});
    findsNothing(alongY);
    axes.update(tcp12, new double[] {0.1, 0, 0, 0, 0, 0});
    finds(1, 0.05, 0.01, alongY);
    axes.update(tcp12, REST);
    finds(1, 0.05, 0.01, alongY);
  }

  @Test
  void itMustLastTwentyMilliseconds() {
    begin(FrameKind.FIXED, Pose.ZERO, -1, 0.01, 0.02);
    Joints far = aside(0.02, 0, 0, 0, 0, 0);
    for (int round = 0; round < 3; round++) {
      for (int i = 1; i < DeviationWatch.FRAMES; i++) {
        assertEquals(Optional.empty(), look(far));
      }
      assertEquals(Optional.empty(), look(TARGET));
    }
    assertTrue(lasting(far).isPresent());
  }

  @Test
  void anotherTaskGoesOnCounting() {
    Optional<TaskDeviation> found = Optional.empty();
    for (int i = 0; i < DeviationWatch.FRAMES; i++) {
      begin(FrameKind.FIXED, new Pose(0, 0, 0, 0, 0, 1e-4 * i), -1, 0.01, 0.02);
      found = look(aside(0.02, 0, 0, 0, 0, 0));
    }
    assertEquals(0, found.orElseThrow().axis());
  }

  @Test
  void limitsBelowWhatAnArmLagsBehindCountAsThat() {
    begin(FrameKind.FIXED, Pose.ZERO, -1, 0, 0);
    findsNothing(aside(0.00099, 0, 0, 0, 0, 0));
    findsNothing(aside(0, 0, 0, 0, 0.0049, 0));
    finds(0, 0.00101, 0.001, aside(0.00101, 0, 0, 0, 0, 0));
    finds(4, 0.0051, 0.005, aside(0, 0, 0, 0, 0.0051, 0));
  }

  @Test
  void withoutAnyLimitTheArmMayBeAnywhere() {
    watch.setTool(TOOL);
    ForceTask screwing = ForceTask.screwDriving(10, 0.1);
    axes.begin(screwing);
    watch.setTask(screwing);
    findsNothing(aside(0.2, 0.1, 0, 0, 0, 1));
  }
}
