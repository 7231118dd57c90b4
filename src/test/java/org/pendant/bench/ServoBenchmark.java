package org.pendant.bench;

import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.PlanningException;
import org.pendant.motion.servo.FrictionShare;
import org.pendant.motion.servo.Servoing;

/**
 * One frame of a stream: the motion that was asked for with a time of one frame, planned and
 * stepped. Of {@code servoc} most frames only step.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 4, time = 1)
public class ServoBenchmark {
  private static final Joints READY = new Joints(0, -1.5708, -1.5708, -1.5708, 1.5708, 0);
  private static final Pose TCP = new Pose(0.01, -0.02, 0.12, 0.1, -0.3, 0.2);
  private static final OptionalDouble A_FRAME = OptionalDouble.of(FrameTime.FRAME_S);

  @Param({"speedj", "speedl", "servoj", "servoc", "torque"})
  String does;

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final double[] twist = new double[Joints.COUNT];
  private MotionControl control;
  private Servoing servoing;
  private MotionTicket ticket;
  private Pose start;
  private long frame;

  /** Begins the stream. */
  @Setup
  public void begin() throws PlanningException {
    control = new MotionControl(arm, READY);
    servoing = new Servoing(arm, control);
    start = new ForwardKinematics(arm).tcpPose(READY, TCP);
    if (!does.equals("torque")) {
      ticket = control.continueWith(next());
    }
  }

  /** To and fro, a second each. */
  private double sway() {
    return Math.cos(Math.PI * frame / FrameTime.FRAMES_PER_SECOND);
  }

  private MotionPlan next() {
    double sway = sway();
    return switch (does) {
      case "speedj" ->
          servoing.speedJ(new Joints(0.2 * sway, 0, 0.1 * sway, 0, 0, sway), 5, A_FRAME);
      case "speedl" -> {
        twist[1] = 0.1 * sway;
        twist[5] = 0.2 * sway;
        yield servoing.speedL(TCP, twist, 2, 2, A_FRAME);
      }
      case "servoj" -> servoing.servoJ(READY.with(0, 0.2 * sway), FrameTime.FRAME_S, 0.1, 300);
      case "servoc" -> servoing.servoC(beside(frame % 2 == 0 ? 0.05 : -0.05), TCP, 1, 0.1, 0.01);
      default -> throw new IllegalStateException("does is " + does);
    };
  }

  private Pose beside(double y) {
    return new Pose(start.x(), start.y() + y, start.z(), start.rx(), start.ry(), start.rz());
  }

  /** One frame. */
  @Benchmark
  public double frame() throws PlanningException {
    frame++;
    if (does.equals("torque")) {
      servoing.giveTorque(READY, FrictionShare.MOST);
      control.step();
      control.guide(READY, Joints.ZERO);
      return control.scaling();
    }
    if (ticket.finished()) {
      ticket = control.continueWith(next());
    }
    control.step();
    if (ticket.failure().isPresent()) {
      throw new IllegalStateException(ticket.failure().get().message());
    }
    return control.scaling();
  }
}
