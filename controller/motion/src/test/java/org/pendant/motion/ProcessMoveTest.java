package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.time.FrameTime;

final class ProcessMoveTest {
  private static final double FRAME_S = FrameTime.FRAME_S;

  private final MoveChain chain = new MoveChain();

  private Move to(double x, double y, double v, double r) {
    return chain.movep(chain.shifted(x, y, 0), 1.2, v, r);
  }

  /** Speed of the TCP in each frame, m/s. */
  private double speed(MoveChain.Trace trace, int k) {
    return Poses.pointDistance(chain.tcp(trace.q().get(k - 1)), chain.tcp(trace.q().get(k)))
        / FRAME_S;
  }

  @Test
  void keepsItsSpeedRoundCornersThatItKnows() throws PlanningException {
    MoveChain.Trace trace =
        chain.run(
            List.of(
                to(0.15, 0, 0.2, 0.04),
                to(0.15, 0.15, 0.2, 0.04),
                to(0, 0.15, 0.2, 0.04),
                to(0, -0.1, 0.2, 0)));
    int rampFrames = (int) Math.ceil(0.2 / 1.2 / FRAME_S) + 2;
    for (int k = rampFrames; k < trace.q().size() - rampFrames; k++) {
      assertEquals(0.2, speed(trace, k), 2e-4, "frame " + k);
    }
  }

  @Test
  void roundsACornerOnTheCircleThatTouchesBothLines() throws PlanningException {
    MoveChain.Trace trace = chain.run(List.of(to(0.15, 0, 0.2, 0.04), to(0.15, 0.15, 0.2, 0)));
    Pose centre = chain.shifted(0.11, 0.04, 0);
    int onTheCircle = 0;
    for (int k = 0; k < trace.q().size(); k++) {
      Pose now = chain.tcp(trace.q().get(k));
      double x = now.x() - centre.x();
      double y = now.y() - centre.y();
      if (x > 1e-6 && y < -1e-6) {
        assertEquals(0.04, Math.hypot(x, y), 1e-9, "frame " + k);
        onTheCircle++;
      }
    }
    assertTrue(onTheCircle > 100, onTheCircle + " frames");
  }

  @Test
  void slowsDownBeforeACircleThatIsTooSmallForItsSpeed() throws PlanningException {
    MoveChain.Trace trace = chain.run(List.of(to(0.15, 0, 0.5, 0.01), to(0.15, 0.15, 0.5, 0)));
    double most = Math.sqrt(1.2 * 0.01);
    Pose corner = chain.shifted(0.15, 0, 0);
    double fastest = 0;
    for (int k = 1; k < trace.q().size(); k++) {
      if (Poses.pointDistance(chain.tcp(trace.q().get(k)), corner) < 0.0095) {
        fastest = Math.max(fastest, speed(trace, k));
      }
    }
    assertEquals(most, fastest, 2e-3);
  }

  @Test
  void leadsOntoACircleThatTouchesTheLineWithoutLeavingEither() throws PlanningException {
    Pose middle = chain.shifted(0.15 + 0.08, 0.08, 0);
    MoveChain.Trace trace =
        chain.run(
            List.of(
                to(0.15, 0, 0.2, 0.02),
                chain.movec(middle, chain.shifted(0.15, 0.16, 0), 1.2, 0.2, 0.02, false),
                to(0, 0.16, 0.2, 0)));
    Pose centre = chain.shifted(0.15, 0.08, 0);
    int rampFrames = (int) Math.ceil(0.2 / 1.2 / FRAME_S) + 2;
    for (int k = 1; k < trace.q().size(); k++) {
      Pose now = chain.tcp(trace.q().get(k));
      double beside =
          now.x() > centre.x()
              ? Math.abs(Poses.pointDistance(centre, now) - 0.08)
              : Math.abs(Math.abs(now.y() - centre.y()) - 0.08);
      assertEquals(0, beside, 1e-9, "frame " + k);
      if (k > rampFrames && k < trace.q().size() - rampFrames) {
        assertEquals(0.2, speed(trace, k), 2e-4, "frame " + k);
      }
    }
  }

  @Test
  void keepsTheSpeedOfACircleThatItsAccelerationAllows() throws PlanningException {
    MoveChain.Trace trace =
        chain.run(
            List.of(
                chain.movec(
                    chain.shifted(0.03, 0.03, 0), chain.shifted(0, 0.06, 0), 1.2, 1, 0, false)));
    double fastest = 0;
    for (int k = 1; k < trace.q().size(); k++) {
      fastest = Math.max(fastest, speed(trace, k));
    }
    assertTrue(fastest <= Math.sqrt(1.2 * 0.03), "fastest " + fastest);
    assertEquals(Math.sqrt(1.2 * 0.03), fastest, 1e-3);
  }

  @Test
  void comesToRestBeforeAMoveOfAnotherKind() throws PlanningException {
    Move away = chain.movel(chain.shifted(0.15, 0.1, 0), 1.2, 0.2, 0, 0);
    MoveChain.Trace trace = chain.run(List.of(to(0.15, 0, 0.2, 0.04), away));
    double nearest =
        trace.q().stream()
            .mapToDouble(q -> Poses.pointDistance(chain.tcp(q), chain.shifted(0.15, 0, 0)))
            .min()
            .orElseThrow();
    assertEquals(0, nearest, 1e-9);
    double end = Poses.pointDistance(chain.tcp(trace.q().getLast()), chain.shifted(0.15, 0.1, 0));
    assertEquals(0, end, 1e-9);
  }

  @Test
  void stopsWhereItTurnsBack() throws PlanningException {
    MoveChain.Trace trace = chain.run(List.of(to(0.15, 0, 0.2, 0.04), to(0, 0, 0.2, 0)));
    chain.assertSmooth(trace, 60, "reversal");
    assertEquals(0, trace.q().getLast().maxAbsDifference(MoveChain.READY), 1e-9);
  }

  @Test
  void makesSpheresThatOverlapSmallerRatherThanLeavingAMoveOut() throws PlanningException {
    MoveChain.Trace trace =
        chain.run(List.of(to(0.1, 0, 0.1, 0.05), to(0.1, 0.06, 0.1, 0.05), to(0.2, 0.06, 0.1, 0)));
    double nearest =
        trace.q().stream()
            .mapToDouble(q -> Poses.pointDistance(chain.tcp(q), chain.shifted(0.1, 0.06, 0)))
            .min()
            .orElseThrow();
    // the circle of radius 0.03 passes its corner at 0.03 (sqrt 2 - 1)
    assertEquals(0.03 * (Math.sqrt(2) - 1), nearest, 1e-4);
  }
}
