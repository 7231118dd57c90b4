package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.controller.machine.ProgramState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/** Programs whose moves blend, from outside. */
final class BlendedProgramTest {
  private static final String CHAIN =
      """
      def chain():
        movej([0.2, -1.5, -1.6, -1.6, 1.6, 0], a=2, v=1.2, r=0.03)
        movel(p[0.45, -0.05, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.3, r=0.02)
        textmsg("half way")
        movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.3, r=0.04)
        movej([0.3, -1.4, -1.7, -1.6, 1.5, 0.2], a=2, v=1.2, r=0.02)
        movej([-0.3, -1.4, -1.7, -1.6, 1.5, 0.2], a=2, v=1.2)
        textmsg("there")
      end
      """;

  /** How far a point may be from the broken line through the points of a run without a pause. */
  private static final double CHORD_RAD = 4e-5;

  private static List<Joints> targets(RunningProgram running) {
    List<Joints> targets = new ArrayList<>();
    while (running.programState() != ProgramState.STOPPED) {
      running.advance(1);
      targets.add(running.state().arm().targetPositionRad());
    }
    return targets;
  }

  @Test
  void arrivesWithoutStoppingOnTheWay() {
    RunningProgram running = new RunningProgram();
    running.start(CHAIN);
    int atRest = 0;
    while (running.programState() == ProgramState.RUNNING) {
      running.advance(1);
      boolean rests = running.state().arm().targetSpeedRadPerS().equals(Joints.ZERO);
      atRest += rests ? 1 : 0;
    }
    assertEquals(List.of("half way", "there"), running.said());
    assertTrue(atRest < 5, atRest + " frames at rest");
    assertTrue(running.reported().isEmpty(), running.reported().toString());
  }

  @Test
  void keepsItsSpeedThroughShallowCornersThatTheProgramLeadsTo() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def arc():
          movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
          i = 1
          while i < 30:
            y = -0.15 + i * 0.01
            movel(p[0.45 + 0.5 * (0.0225 - y * y), y, 0.45, 2.2214, -2.2214, 0], r=0.002)
            textmsg(i)
            i = i + 1
          end
          movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0])
        end
        """);
    while (running.said().size() < 5) {
      running.advance(1);
    }
    double slowest = 1;
    while (running.said().size() < 25) {
      Pose before = running.state().arm().targetTcpInBase();
      running.advance(1);
      double moved = Poses.pointDistance(before, running.state().arm().targetTcpInBase());
      slowest = Math.min(slowest, moved / 0.002);
    }
    assertTrue(slowest > 0.2, "slowest " + slowest);
  }

  @Test
  void aPauseInAnyFrameChangesNoPointOfThePath() {
    RunningProgram plain = new RunningProgram();
    plain.start(CHAIN);
    List<Joints> path = targets(plain);
    SplittableRandom random = new SplittableRandom(3);
    for (int each = 0; each < 120; each++) {
      int at = each < 60 ? spread(path, each) : random.nextInt(5, path.size() - 5);
      RunningProgram paused = new RunningProgram();
      paused.start(CHAIN);
      paused.advance(at);
      paused.ask(new Command.PauseProgram());
      paused.advance(random.nextInt(1, 400));
      paused.ask(new Command.ResumeProgram());
      List<Joints> points = targets(paused);
      int near = nearest(points.getFirst(), path, 0, path.size());
      for (Joints point : points) {
        near = nearest(point, path, near, near + 10);
        double aside = aside(point, path, near);
        assertTrue(aside < CHORD_RAD, "paused in frame " + at + ": " + aside + " rad aside");
      }
      assertEquals(path.getLast(), points.getLast());
      assertFalse(paused.said().isEmpty());
    }
  }

  /** Frames all over the run, a few at a time beside each other. */
  private static int spread(List<Joints> path, int each) {
    return Math.min(path.size() - 5, 10 + each * (path.size() / 61));
  }

  /** The point of a part of the path that is next to another one. */
  private static int nearest(Joints point, List<Joints> path, int from, int to) {
    int best = from;
    for (int k = from; k < Math.min(path.size(), to); k++) {
      if (path.get(k).squaredDistance(point) < path.get(best).squaredDistance(point)) {
        best = k;
      }
    }
    return best;
  }

  private static double aside(Joints point, List<Joints> path, int near) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int k = Math.max(0, near - 1); k < Math.min(path.size() - 1, near + 1); k++) {
      nearest = Math.min(nearest, distance(point, path.get(k), path.get(k + 1)));
    }
    return nearest;
  }

  private static double distance(Joints point, Joints from, Joints to) {
    double along = 0;
    double square = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      double step = to.get(i) - from.get(i);
      along += step * (point.get(i) - from.get(i));
      square += step * step;
    }
    double part = square == 0 ? 0 : Math.max(0, Math.min(1, along / square));
    double sum = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      double off = from.get(i) + part * (to.get(i) - from.get(i)) - point.get(i);
      sum += off * off;
    }
    return Math.sqrt(sum);
  }
}
