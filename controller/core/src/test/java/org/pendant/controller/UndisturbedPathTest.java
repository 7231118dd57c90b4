package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.ProgramState;

/**
 * Whatever holds a program up or slows it down changes no point of the path of its arm. {@code
 * -Dtest.cases=5} or more for a thorough run.
 */
@Tag("slow")
final class UndisturbedPathTest {
  private static final String CHAIN =
      """
      def chain():
        motion_version_set(%d)
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

  /** Frames of the 5 s that a protective stop lasts at least. */
  private static final int UNLOCK_FRAMES = 2500;

  private static final int CASES = 12 * Integer.getInteger("test.cases", 1);

  /** What happens on the way. */
  enum Disturbance {
    PAUSE,
    SLIDER,
    SAFEGUARD_STOP,
    PROTECTIVE_STOP;

    void happen(RunningProgram running, SplittableRandom random, List<Joints> points) {
      switch (this) {
        case PAUSE -> {
          running.ask(new ProgramCommand.PauseProgram());
          follow(running, random.nextInt(1, 400), points);
          running.ask(new ProgramCommand.ResumeProgram());
        }
        case SLIDER -> {
          running.done(new BoxCommand.SetSpeedFraction(random.nextDouble(0, 1)));
          follow(running, random.nextInt(1, 300), points);
          running.done(new BoxCommand.SetSpeedFraction(random.nextDouble(0.1, 1)));
        }
        case SAFEGUARD_STOP -> {
          running.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
          follow(running, random.nextInt(1, 400), points);
          running.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false));
        }
        case PROTECTIVE_STOP -> {
          String stop = "sec stop():\n  protective_stop()\nend\n";
          running.done(new ProgramCommand.RunSecondary(running.program(stop)));
          follow(running, UNLOCK_FRAMES, points);
          assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
          running.done(new SafetyCommand.UnlockProtectiveStop(false));
          running.done(new ProgramCommand.ResumeProgram());
        }
      }
    }
  }

  private static void follow(RunningProgram running, int frames, List<Joints> targets) {
    for (int i = 0; i < frames; i++) {
      running.advance(1);
      targets.add(running.state().arm().targetPositionRad());
    }
  }

  private static List<Joints> targets(RunningProgram running) {
    List<Joints> targets = new ArrayList<>();
    followToEnd(running, targets);
    return targets;
  }

  private static void followToEnd(RunningProgram running, List<Joints> targets) {
    while (running.programState() != ProgramState.STOPPED) {
      follow(running, 1, targets);
      assertTrue(targets.size() < 100_000, "endless");
    }
  }

  private static RunningProgram started(int version) {
    RunningProgram running = new RunningProgram();
    running.start(CHAIN.formatted(version));
    return running;
  }

  @ParameterizedTest
  @CsvSource({
    "PAUSE, 1", "PAUSE, 2", "SLIDER, 1", "SLIDER, 2",
    "SAFEGUARD_STOP, 1", "SAFEGUARD_STOP, 2", "PROTECTIVE_STOP, 1", "PROTECTIVE_STOP, 2"
  })
  void noPointOfThePathIsAnother(Disturbance disturbance, int version) {
    List<Joints> path = targets(started(version));
    SplittableRandom random = new SplittableRandom(3);
    for (int each = 0; each < CASES; each++) {
      boolean spread = each < CASES / 2;
      int at = spread ? spread(path, each) : random.nextInt(5, path.size() - 5);
      RunningProgram disturbed = started(version);
      disturbed.advance(at);
      List<Joints> points = new ArrayList<>();
      disturbance.happen(disturbed, random, points);
      followToEnd(disturbed, points);
      String input = disturbance + " in frame " + at + ", version " + version;
      assertFollows(path, points, input);
      assertFalse(disturbed.said().isEmpty(), input);
    }
  }

  /** Frames all over the run. */
  private static int spread(List<Joints> path, int each) {
    return Math.min(path.size() - 5, 10 + each * (path.size() / (CASES / 2 + 1)));
  }

  private static void assertFollows(List<Joints> path, List<Joints> points, String input) {
    int near = nearest(points.getFirst(), path, 0, path.size());
    for (Joints point : points) {
      near = nearest(point, path, near, near + 10);
      double aside = aside(point, path, near);
      assertTrue(aside < CHORD_RAD, input + ": " + aside + " rad aside");
    }
    assertEquals(path.getLast(), points.getLast(), input);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void halfAndAQuarterOfTheSpeedTakeTwoAndFourTimesAsLong(int version) {
    List<Joints> path = targets(started(version));
    for (int slower = 2; slower <= 4; slower *= 2) {
      RunningProgram slowed = new RunningProgram();
      slowed.done(new BoxCommand.SetSpeedFraction(1.0 / slower));
      slowed.start(CHAIN.formatted(version));
      List<Joints> points = targets(slowed);
      assertFollows(path, points, "1 / " + slower);
      // each of the four moves is handed over, or ends, in a whole frame
      assertEquals(slower * path.size(), points.size(), 6.0 * slower);
    }
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
