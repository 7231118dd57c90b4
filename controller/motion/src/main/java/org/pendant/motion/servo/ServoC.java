package org.pendant.motion.servo;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionFailure;
import org.pendant.motion.MotionSample;
import org.pendant.motion.MoveL;
import org.pendant.motion.PlanningException;
import org.pendant.motion.StopL;
import org.pendant.motion.ToolCurve;
import org.pendant.motion.ToolPathFollower;
import org.pendant.motion.profile.Profile;
import org.pendant.motion.profile.ProfileLimits;

/**
 * Circular servo motion: the TCP goes to a pose on an arc that continues its current direction. The
 * program continues at a radius before the pose; when nothing follows, the tool comes to rest in
 * it. A pose that lies behind, or too near for the arc, is approached in a straight line after a
 * stop.
 */
final class ServoC implements Motion {
  /** Slower than this, m/s, the tool has no direction to continue. */
  private static final double NO_DIRECTION_M_PER_S = 1e-6;

  private final Optional<StopL> stop;
  private final double stopS;
  private final ToolPathFollower follower;
  private final double handOverS;
  private final double durationS;

  private ServoC(Optional<StopL> stop, ToolPathFollower follower, Way way) {
    this.stop = stop;
    this.follower = follower;
    stopS = stop.isPresent() ? stop.get().durationS() : 0;
    durationS = stopS + way.durationS();
    boolean ends = way.settling.distance() == 0;
    handOverS = ends ? durationS : stopS + way.approach.durationS();
  }

  /** The arc with its law, over time in s. */
  private static final class Way implements ToolCurve {
    final TangentArc arc;
    final Profile approach;
    final Profile settling;
    final FadingTurn turn;

    Way(TangentArc arc, Profile approach, Profile settling, FadingTurn turn) {
      this.arc = arc;
      this.approach = approach;
      this.settling = settling;
      this.turn = turn;
    }

    double durationS() {
      return Math.max(approach.durationS() + settling.durationS(), turn.durationS());
    }

    private double covered(double timeS) {
      double rest = timeS - approach.durationS();
      return rest < 0 ? approach.position(timeS) : approach.distance() + settling.position(rest);
    }

    private double speed(double timeS) {
      double rest = timeS - approach.durationS();
      return rest < 0 ? approach.speed(timeS) : settling.speed(rest);
    }

    @Override
    public void at(double timeS, double[] transform) {
      turn.at(timeS, transform);
      arc.at(covered(timeS), transform);
    }

    @Override
    public void rate(double timeS, double[] twist) {
      arc.velocity(covered(timeS), speed(timeS), twist);
      turn.velocity(timeS, twist);
    }

    @Override
    public void bend(double timeS, double[] twist) {
      double rest = timeS - approach.durationS();
      double change = rest < 0 ? approach.acceleration(timeS) : settling.acceleration(rest);
      arc.acceleration(covered(timeS), speed(timeS), change, twist);
      turn.acceleration(timeS, twist);
    }
  }

  /**
   * Plans from a state of the joints.
   *
   * @throws PlanningException when the tool cannot stop before it turns back
   */
  static ServoC plan(
      ArmDescription arm,
      Joints from,
      Joints speed,
      Pose goal,
      Pose tcpInFlange,
      double acceleration,
      double fastest,
      double radiusM)
      throws PlanningException {
    ProfileLimits limits = ProfileLimits.of(fastest, acceleration);
    Begin begin = new Begin(arm, from, speed, tcpInFlange);
    Optional<Way> ahead = begin.way(goal, limits, radiusM);
    if (ahead.isPresent()) {
      return new ServoC(
          Optional.empty(), new ToolPathFollower(arm, ahead.get(), tcpInFlange, from), ahead.get());
    }
    StopL stop = stop(arm, from, speed, tcpInFlange, acceleration);
    MotionSample end = new MotionSample();
    Optional<MotionFailure> failure = stop.sample(stop.durationS(), end);
    if (failure.isPresent()) {
      throw new PlanningException(failure.get());
    }
    Joints rest = end.positionRad();
    Way way =
        new Begin(arm, rest, Joints.ZERO, tcpInFlange).way(goal, limits, radiusM).orElseThrow();
    // the stop that was asked for its end has gone there
    return new ServoC(
        Optional.of(stop(arm, from, speed, tcpInFlange, acceleration)),
        new ToolPathFollower(arm, way, tcpInFlange, rest),
        way);
  }

  private static StopL stop(
      ArmDescription arm, Joints from, Joints speed, Pose tcpInFlange, double acceleration) {
    return new StopL(
        arm, from, speed, tcpInFlange, acceleration, MoveL.ROTATION_FACTOR * acceleration);
  }

  /** What the tool does when it is told where to go. */
  private static final class Begin {
    private final double[] tcp = new double[Transforms.SIZE];
    private final double[] twist = new double[Joints.COUNT];

    Begin(ArmDescription arm, Joints from, Joints speed, Pose tcpInFlange) {
      double[] jacobian = new double[Jacobian.SIZE];
      new Jacobian(arm).at(from.toArray(), tcpInFlange, jacobian);
      Jacobian.twist(jacobian, speed.toArray(), twist);
      Transforms.of(new ForwardKinematics(arm).tcpPose(from, tcpInFlange), tcp);
    }

    /** The way to a goal; empty if the tool has to stop before. */
    Optional<Way> way(Pose goal, ProfileLimits limits, double radiusM) {
      double[] end = new double[Transforms.SIZE];
      Transforms.of(goal, end);
      double speed = Math.sqrt(twist[0] * twist[0] + twist[1] * twist[1] + twist[2] * twist[2]);
      boolean resting = speed < NO_DIRECTION_M_PER_S;
      TangentArc arc = resting ? straight(end) : ahead(end, speed);
      double begin = resting ? 0 : speed;
      double bound = Math.sqrt(limits.acceleration() / arc.curvature());
      if (arc.angleRad() > Math.PI / 2
          || begin > bound
          || limits.rampDistance(begin, 0) > arc.length()) {
        return resting ? Optional.of(along(arc, 0, limits, radiusM, end)) : Optional.empty();
      }
      ProfileLimits onArc = limits.withSpeed(Math.min(limits.speed(), bound));
      return Optional.of(along(arc, begin, onArc, radiusM, end));
    }

    private TangentArc straight(double[] end) {
      double[] chord = {end[9] - tcp[9], end[10] - tcp[10], end[11] - tcp[11]};
      double distance = TangentArc.length(chord);
      for (int i = 0; i < 3; i++) {
        chord[i] = distance > 0 ? chord[i] / distance : 0;
      }
      return new TangentArc(new double[] {tcp[9], tcp[10], tcp[11]}, chord, position(end));
    }

    private TangentArc ahead(double[] end, double speed) {
      double[] direction = {twist[0] / speed, twist[1] / speed, twist[2] / speed};
      return new TangentArc(new double[] {tcp[9], tcp[10], tcp[11]}, direction, position(end));
    }

    private static double[] position(double[] transform) {
      return new double[] {transform[9], transform[10], transform[11]};
    }

    private Way along(
        TangentArc arc, double begin, ProfileLimits limits, double radiusM, double[] end) {
      double last = Math.min(radiusM, arc.length());
      double first = arc.length() - last;
      // both parts can be driven: rest in the goal must stay possible, and be reached from here
      double between = Math.min(limits.fastestBegin(last, 0), limits.fastestEnd(first, begin));
      double passing = Math.max(between, slowest(begin, first, limits));
      Profile approach = limits.between(first, begin, first > 0 ? passing : begin);
      Profile settling = limits.between(last, first > 0 ? passing : begin, 0);
      double linearS = approach.durationS() + settling.durationS();
      double[] spin = {twist[3], twist[4], twist[5]};
      FadingTurn turn =
          new FadingTurn(
              tcp,
              spin,
              end,
              linearS,
              MoveL.ROTATION_FACTOR * limits.speed(),
              MoveL.ROTATION_FACTOR * limits.acceleration());
      return new Way(arc, approach, settling, turn);
    }

    /** The lowest speed that can be reached from {@code begin} over a distance. */
    private static double slowest(double begin, double distance, ProfileLimits limits) {
      return Math.sqrt(Math.max(0, begin * begin - 2 * limits.acceleration() * distance));
    }
  }

  @Override
  public double durationS() {
    return durationS;
  }

  @Override
  public double handOverS() {
    return handOverS;
  }

  @Override
  public String driver() {
    return "servoc";
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    if (timeS < stopS) {
      return stop.orElseThrow().sample(timeS, sample);
    }
    double moves = timeS < durationS ? 1 : 0;
    return follower.sample(timeS - stopS, moves, 0, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.empty();
  }
}
