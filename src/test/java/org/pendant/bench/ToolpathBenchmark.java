package org.pendant.bench;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
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
import org.pendant.models.pose.Poses;
import org.pendant.motion.MotionControl;
import org.pendant.motion.MotionTicket;
import org.pendant.motion.PlanningException;
import org.pendant.motion.toolpath.RunPlan;
import org.pendant.motion.toolpath.ToolConfiguration;
import org.pendant.motion.toolpath.Toolpaths;

/** A run of a thousand lines of 2 mm by a UR5e: one frame of it, and its planning. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 4, time = 1)
public class ToolpathBenchmark {
  private static final int LINES = 1000;
  private static final Joints START_RAD = new Joints(0, -1.6, -1.6, -1.6, 1.6, 0);

  @Param({"tool", "remote", "free"})
  String kind;

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private Toolpaths toolpaths;
  private RunPlan plan;
  private MotionControl motion;
  private MotionTicket ticket;

  /** Queues the lines: circles in the plane of the tool. */
  @Setup(Level.Trial)
  public void prepare() throws PlanningException {
    Pose flange = new ForwardKinematics(arm).flangePose(START_RAD);
    boolean remote = kind.equals("remote");
    Pose tool = new Pose(0, 0, 0.1, 0, 0, 0);
    ToolConfiguration toolConfiguration =
        new ToolConfiguration(remote, remote ? Poses.trans(flange, tool) : tool);
    toolpaths = new Toolpaths(arm, true);
    toolpaths.initialize(toolConfiguration, kind.equals("free"));
    Pose start = remote ? tool : Poses.trans(flange, tool);
    toolpaths.setPcs(start);
    for (int i = 1; i <= LINES; i++) {
      double angle = 0.04 * i;
      toolpaths.addLinear(
          new Pose(0.05 * Math.cos(angle) - 0.05, 0.05 * Math.sin(angle), 0, 0, 0, 0),
          1.2,
          0.1,
          0.001);
    }
    plan = plan();
    begin();
  }

  private void begin() throws PlanningException {
    motion = new MotionControl(arm, START_RAD);
    ticket = motion.start((from, speed) -> plan.begin(from));
  }

  /** One frame. */
  @Benchmark
  public double frame() throws PlanningException {
    if (ticket.finished()) {
      begin();
    }
    motion.step();
    return motion.scaling();
  }

  /** All of the planning. */
  @Benchmark
  public RunPlan plan() throws PlanningException {
    toolpaths.ended();
    return toolpaths.plan(LINES - 1, START_RAD, Pose.ZERO).result();
  }
}
