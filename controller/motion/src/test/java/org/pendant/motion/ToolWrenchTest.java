package org.pendant.motion;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;

/** Limits of what the payload does to the tool hold from the first frame of a chain to the last. */
@Tag("slow")
final class ToolWrenchTest {
  private static final Payload LOAD = Payload.of(3, 0.02, 0, 0.1);
  private static final Pose FRAME = new Pose(0, 0, 0.1, 0, 0, 0.7);
  private static final List<Double> LIMITS = List.of(3.0, 3.0, 4.0, 0.4, 0.4, 1.0);
  private static final int MOVES = 6;

  /** Accelerations are differences of speeds here, in which those of two points mix. */
  private static final double ROUNDING = 1.02;

  private final MoveChain chain = new MoveChain();
  private final ArmDynamics dynamics = new ArmDynamics(chain.arm);
  private final InverseKinematics inverse = new InverseKinematics(chain.arm);
  private final ToolWrenchLimit limit = new ToolWrenchLimit(FRAME, LIMITS);

  /** What is done to a chain in some frame. */
  private interface Interference {
    void at(int frame, MotionControl control);
  }

  private List<Move> moves(SplittableRandom random) {
    List<Move> moves = new ArrayList<>();
    Joints at = MoveChain.READY;
    for (int i = 0; i < MOVES; i++) {
      double r = i == MOVES - 1 ? 0 : random.nextDouble(0.005, 0.05);
      Pose goal =
          chain.shifted(
              random.nextDouble(-0.15, 0.15),
              random.nextDouble(-0.15, 0.15),
              random.nextDouble(-0.15, 0.15));
      at = inverse.closest(InverseKinematics.flangeOf(goal, MoveChain.TCP), at).orElseThrow();
      double a = random.nextDouble(1, 6);
      double v = random.nextDouble(0.1, 0.6);
      moves.add(move(random.nextInt(4), at, goal, new MoveLimits(a, v, 0), r));
    }
    return moves;
  }

  private Move move(int kind, Joints q, Pose goal, MoveLimits limits, double r) {
    return switch (kind) {
      case 0 -> chain.optimovej(q, 1, 1, r);
      case 1 ->
          new Move(
              from ->
                  Routes.joints(
                      chain.arm, from, q, goal, MoveChain.TCP, chain.headroom.asAsked(limits)),
              limits,
              r,
              0);
      case 2 -> chain.movep(goal, limits.acceleration(), limits.speed(), r);
      default ->
          new Move(
              from ->
                  Routes.line(
                      chain.arm,
                      from,
                      chain.tcp(from),
                      goal,
                      MoveChain.TCP,
                      chain.headroom.asAsked(limits)),
              limits,
              r,
              0.08);
    };
  }

  /** The largest share of any limit that is used in any frame. */
  private double largestShare(List<Move> moves, Interference interference)
      throws PlanningException {
    chain.headroom.setPayload(LOAD);
    chain.headroom.setToolWrenchLimit(Optional.of(limit));
    dynamics.setGravity(0, 0, 0);
    MotionControl control = new MotionControl(chain.arm, MoveChain.READY);
    control.limitRamps(chain.headroom::reachableScaling);
    double share = 0;
    int frame = 0;
    for (int m = 0; m < moves.size(); m++) {
      Optional<MotionTicket> started = control.start(moves.get(m));
      if (started.isEmpty()) {
        continue;
      }
      MotionTicket ticket = started.get();
      if (ticket.wantsOutlook()) {
        ticket.outlook(moves.subList(m + 1, moves.size()));
      }
      boolean last = m == moves.size() - 1;
      while (last ? control.moving() : !ticket.finished()) {
        interference.at(frame++, control);
        Joints before = control.speedRadPerS();
        Joints q = control.positionRad();
        control.step();
        assertTrue(ticket.failure().isEmpty(), () -> ticket.failure().toString());
        share = Math.max(share, share(q, before, control));
        assertTrue(frame < 100_000, "endless");
      }
    }
    return share;
  }

  private double share(Joints q, Joints before, MotionControl control) {
    double[] qdd = new double[Joints.COUNT];
    double[] qd = new double[Joints.COUNT];
    double[] middle = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      qdd[i] = (control.speedRadPerS().get(i) - before.get(i)) / FrameTime.FRAME_S;
      qd[i] = 0.5 * (control.speedRadPerS().get(i) + before.get(i));
      middle[i] = 0.5 * (q.get(i) + control.positionRad().get(i));
    }
    double[] wrench = new double[Pose.SIZE];
    dynamics.inverse(middle, qd, qdd, new double[Joints.COUNT]);
    dynamics.flangeMotion().loadOf(LOAD, wrench);
    limit.carry(wrench);
    double share = 0;
    for (int i = 0; i < Pose.SIZE; i++) {
      share = Math.max(share, Math.abs(wrench[i]) / LIMITS.get(i));
    }
    return share;
  }

  @Test
  void holdInBlends() throws PlanningException {
    for (long seed = 0; seed < 100; seed++) {
      List<Move> moves = moves(new SplittableRandom(seed));
      double share = largestShare(moves, (frame, control) -> {});
      assertTrue(share <= ROUNDING, "seed " + seed + ": " + share);
      assertTrue(share > 0.3, "seed " + seed + ": " + share);
    }
  }

  @Test
  void holdInPausesStopsAndChangesOfTheSlider() throws PlanningException {
    for (long seed = 0; seed < 100; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      List<Move> moves = moves(random);
      int period = random.nextInt(150, 400);
      int kind = random.nextInt(3);
      double share =
          largestShare(
              moves,
              (frame, control) -> {
                int at = frame % period;
                if (kind == 0 && (at == period / 2 || at == period - 1)) {
                  control.setSpeedFraction(at == period - 1 ? 1 : 0.2);
                } else if (kind == 1 && at == period / 2) {
                  control.pause();
                } else if (kind == 2 && at == period / 2) {
                  control.halt(15);
                } else if (kind > 0 && at == period - 1) {
                  control.resume();
                }
              });
      assertTrue(share <= ROUNDING, "seed " + seed + ", kind " + kind + ": " + share);
    }
  }

  @Test
  void holdWhileAProgramStarts() throws PlanningException {
    for (long seed = 0; seed < 100; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      List<Move> moves = moves(random);
      int startsAt = random.nextInt(2) * random.nextInt(60);
      double share =
          largestShare(
              moves,
              (frame, control) -> {
                control.setStartRamp(true);
                if (frame == 0) {
                  control.programStarted();
                } else if (frame == startsAt) {
                  control.setSpeedFraction(0.5);
                }
              });
      assertTrue(share <= ROUNDING, "seed " + seed + ": " + share);
    }
  }

  @Test
  void giveWayWhereAStopWouldLastMuchLongerThanASecond() throws PlanningException {
    chain.headroom.setPayload(LOAD);
    chain.headroom.setToolWrenchLimit(
        Optional.of(new ToolWrenchLimit(FRAME, List.of(1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3))));
    MotionControl control = new MotionControl(chain.arm, MoveChain.READY);
    control.limitRamps(chain.headroom::reachableScaling);
    control.start(chain.movej(MoveChain.READY.with(0, 2), 1.4, 1, 0, 0));
    for (int k = 0; k < 600; k++) {
      control.step();
    }
    control.halt(15);
    int frames = 0;
    while (!control.speedRadPerS().equals(Joints.ZERO)) {
      control.step();
      frames++;
    }
    assertTrue(frames > 500 && frames < 550, frames + " frames");
    assertFalse(control.fault().isPresent());
  }
}
