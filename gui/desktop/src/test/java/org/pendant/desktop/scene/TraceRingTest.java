package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;
import org.pendant.models.pose.Pose;
import org.pendant.recording.lines.FrameMargins;
import org.pendant.recording.lines.Margin;

final class TraceRingTest {
  private static void add(TraceRing ring, double x, double timeS) {
    ring.add(new Pose(x, 0, 0, 0, 0, 0), Pose.ZERO, timeS, 7);
  }

  @Test
  void pointsAreKeptOldestFirst() {
    TraceRing ring = new TraceRing(10);
    add(ring, 0, 0);
    add(ring, 0.1, 1);
    add(ring, 0.3, 2);

    TcpTrace trace = ring.trace();

    assertEquals(3, trace.size());
    assertEquals(0, trace.x(0));
    assertEquals(0.3f, trace.x(2));
    assertEquals(7, trace.line(2));
    assertEquals(0.2, trace.speedMPerS(2), 1e-6);
  }

  @Test
  void theOldestAreForgotten() {
    TraceRing ring = new TraceRing(3);
    for (int i = 0; i < 8; i++) {
      add(ring, 0.01 * i, i);
    }

    TcpTrace trace = ring.trace();

    assertEquals(3, trace.size());
    assertEquals(0.05f, trace.x(0));
    assertEquals(0.07f, trace.x(2));
  }

  @Test
  void speedsAreSharesOfARoundSpeed() {
    TraceRing ring = new TraceRing(10);
    add(ring, 0, 0);
    add(ring, 0.1, 1);
    add(ring, 0.5, 2);

    TcpTrace trace = ring.trace();

    assertEquals(0.4, trace.scaleMPerS(), 1e-6);
    assertEquals(0.25, trace.speedShare(1), 1e-6);
    assertEquals(1, trace.speedShare(2), 1e-6);
    add(ring, 1.06, 3);
    assertEquals(0.8, ring.trace().scaleMPerS(), 1e-6);
    add(ring, 1.96, 4);
    assertEquals(1, ring.trace().scaleMPerS(), 1e-6);
  }

  @Test
  void theOldestFadeBeforeTheyGo() {
    TraceRing ring = new TraceRing(10);
    for (int i = 0; i < 5; i++) {
      add(ring, 0.01 * i, i);
    }
    assertEquals(1, ring.trace().opacity(0));

    for (int i = 5; i < 12; i++) {
      add(ring, 0.01 * i, i);
    }

    TcpTrace trace = ring.trace();
    assertTrue(trace.opacity(0) < 0.5);
    assertTrue(trace.opacity(0) < trace.opacity(1));
    assertEquals(1, trace.opacity(9));
  }

  @Test
  void anArmAtRestAddsNothing() {
    TraceRing ring = new TraceRing(10);
    add(ring, 0, 0);
    TcpTrace before = ring.trace();
    add(ring, 0.0001, 1);

    assertSame(before, ring.trace());
    add(ring, 0.1, 2);
    assertNotSame(before, ring.trace());
  }

  @Test
  void aToolThatIsExchangedWhereTheArmStandsLeavesNoLine() {
    TraceRing ring = new TraceRing(10);
    add(ring, 0, 0);
    ring.add(new Pose(0, 0, 0.1, 0, 0, 0), new Pose(0, 0, 0.1, 0, 0, 0), 1, 7);
    assertFalse(ring.trace().hasLine());

    ring.add(new Pose(0.1, 0, 0.1, 0, 0, 0), new Pose(0, 0, 0.1, 0, 0, 0), 2, 7);
    assertTrue(ring.trace().hasLine());
  }

  @Test
  void anotherToolBeginsAnotherLine() {
    TraceRing ring = new TraceRing(10);
    add(ring, 0, 0);
    add(ring, 0.1, 1);
    ring.add(new Pose(0.1, 0, -0.2, 0, 0, 0), new Pose(0, 0, 0.2, 0, 0, 0), 1.002, 7);

    TcpTrace trace = ring.trace();

    assertTrue(trace.begins(0));
    assertFalse(trace.begins(1));
    assertTrue(trace.begins(2));
    assertEquals(0.1, trace.scaleMPerS(), 1e-6);
  }

  @Test
  void cornersAndCurvesAreDrawnAsTheyWereWithFewPointsOnStraightLines() {
    TraceRing ring = new TraceRing(1000);
    List<Pose> places = new ArrayList<>();
    for (int i = 0; i <= 500; i++) {
      places.add(new Pose(0.002 * i, 0, 0, 0, 0, 0));
    }
    // a quarter of a circle of 20 mm, at 1 m/s, then up at a sharp corner
    for (int i = 1; i <= 16; i++) {
      double angle = 0.1 * i;
      places.add(new Pose(1 + 0.02 * Math.sin(angle), 0.02 - 0.02 * Math.cos(angle), 0, 0, 0, 0));
    }
    Pose end = places.getLast();
    for (int i = 1; i <= 100; i++) {
      places.add(new Pose(end.x(), end.y(), 0.002 * i, 0, 0, 0));
    }
    for (int i = 0; i < places.size(); i++) {
      ring.add(places.get(i), Pose.ZERO, i * 0.002, 7);
    }

    TcpTrace trace = ring.trace();

    for (Pose each : places) {
      assertTrue(distanceM(each, trace) < 3e-4, () -> each + " is left out");
    }
    assertTrue(trace.size() < 45, "points of 1.2 s: " + trace.size());
    assertEquals(0.2, trace.z(trace.size() - 1), 1e-6, "it ends at the tool");
  }

  /** How far a place is from the lines of a trace, m. */
  private static double distanceM(Pose place, TcpTrace trace) {
    double nearestM = Double.MAX_VALUE;
    for (int i = 1; i < trace.size(); i++) {
      Vector3d from = new Vector3d(trace.x(i - 1), trace.y(i - 1), trace.z(i - 1));
      Vector3d way = new Vector3d(trace.x(i), trace.y(i), trace.z(i)).sub(from);
      Vector3d at = new Vector3d(place.x(), place.y(), place.z()).sub(from);
      double share = Math.clamp(at.dot(way) / way.lengthSquared(), 0, 1);
      nearestM = Math.min(nearestM, at.sub(way.mul(share)).length());
    }
    return nearestM;
  }

  @Test
  void aLineOfTheProgramBeginsWhereTheOneBeforeEnds() {
    TraceRing ring = new TraceRing(100);
    for (int i = 0; i <= 20; i++) {
      ring.add(new Pose(0.001 * i, 0, 0, 0, 0, 0), Pose.ZERO, 0.002 * i, i <= 10 ? 4 : 5);
    }

    TcpTrace trace = ring.trace();

    List<Float> ends = new ArrayList<>();
    for (int i = 1; i < trace.size(); i++) {
      if (trace.line(i - 1) == 4 && trace.line(i) == 5) {
        ends.add(trace.x(i - 1));
      }
    }
    assertEquals(List.of(0.01f), ends);
  }

  @Test
  void whatIsNotKnownIsLeftOutAndNothingIsDrawnAcrossIt() {
    TraceRing ring = new TraceRing(100);
    add(ring, 0, 0);
    add(ring, Double.NaN, 0.002);
    add(ring, 0.001, 0.004);
    ring.interrupt();
    add(ring, 0.3, 9);

    TcpTrace trace = ring.trace();

    assertEquals(3, trace.size());
    assertFalse(trace.begins(1));
    assertTrue(trace.begins(2));
  }

  @Test
  void clearingForgetsEverything() {
    TraceRing ring = new TraceRing(10);
    add(ring, 0, 0);
    ring.clear();

    assertEquals(0, ring.trace().size());
  }

  @Test
  void aRingOfOnePointIsRefused() {
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> new TraceRing(1));

    assertEquals("trace: capacity is 1, must be at least 2", refused.getMessage());
  }

  @Test
  void aMarginColoursTheWayByHowMuchOfItWasUsed() {
    ControllerOptions options = ControllerOptions.headless().withArm(ArmChoice.IDEAL);
    Controller controller = new Controller(options);
    TraceRing ring = new TraceRing(2000);
    FrameMargins margins = new FrameMargins(controller.state().arm(), options.safety());
    TestController.start(
        controller, "movej([2, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=10, v=2.8)");
    for (int i = 0; i < 400; i++) {
      controller.advance();
      margins.look(controller.state());
      ring.add(controller.state(), margins);
    }

    assertEquals(Optional.empty(), ring.trace().colouring());
    ring.colourBy(Optional.of(Margin.JOINT_SPEED));
    TcpTrace trace = ring.trace();
    float most = 0;
    for (int i = 0; i < trace.size(); i++) {
      most = Math.max(most, trace.used(i));
    }
    double share = 2.8 / Math.PI;
    assertEquals((share - 0.5) / 0.5, most, 1e-3, "half of the speed is ample room");
    assertEquals(0, trace.used(0), "it begins at rest");
  }
}
