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
import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.io.DigitalIo;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionControl;
import org.pendant.motion.offset.ConveyorTracking;
import org.pendant.motion.offset.OffsetType;
import org.pendant.motion.offset.PathOffsetting;

/** The target of one frame of a UR5e that a conveyor or a path offset carries to and fro. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 4, time = 1)
public class OffsetBenchmark {
  /** Frames in which a belt runs in one direction. */
  private static final int FRAMES = 500;

  private static final Joints START_RAD = new Joints(0, -1.6, -1.6, -1.6, 1.6, 0);

  @Param({"linear", "circular", "offset"})
  String carriedBy;

  private final Encoders encoders = new Encoders();
  private final DigitalIo io = new DigitalIo();
  private final PathOffsetting offset = new PathOffsetting();
  private MotionControl motion;
  private int frame;

  /** Begins to carry. */
  @Setup(Level.Trial)
  public void prepare() {
    motion = new MotionControl(ArmLibrary.load("ur5e"), START_RAD);
    ConveyorTracking conveyor = new ConveyorTracking();
    motion.addOffset(conveyor);
    motion.addOffset(offset);
    encoders.get(0).run(5000);
    switch (carriedBy) {
      case "linear" -> conveyor.trackLinear(new Pose(0, 1, 0, 0, 0, 0), 100_000, encoders.get(0));
      case "circular" -> conveyor.trackCircular(Pose.ZERO, 1_000_000, true, encoders.get(0));
      case "offset" -> {
        offset.setAlpha(0.01);
        offset.enable();
      }
      default -> throw new IllegalStateException("carriedBy is " + carriedBy);
    }
  }

  /** One frame. */
  @Benchmark
  public double frame() {
    if (frame++ % FRAMES == 0) {
      turnRound();
    }
    encoders.step(io);
    motion.step();
    return motion.scaling();
  }

  private void turnRound() {
    boolean forward = frame / FRAMES % 2 == 0;
    encoders.get(0).run(forward ? 5000 : -5000);
    offset.set(new Pose(0, forward ? 0.02 : -0.02, 0, 0, 0, 0), OffsetType.BASE);
  }
}
