package org.pendant.bench;

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
import org.pendant.controller.arm.ArmCommand;
import org.pendant.controller.arm.DynamicArm;
import org.pendant.controller.arm.ReadingNoise;
import org.pendant.controller.sensor.ArmSensors;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.servo.FrictionShare;

/** One frame of the simulated UR5e with a payload: swaying to and fro, held at rest, and free. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 4, time = 1)
public class ArmBenchmark {
  /** Frames of one sway. */
  private static final int FRAMES = 2000;

  private static final Joints MIDDLE_RAD = new Joints(0, -1.6, -1.6, -1.6, 1.6, 0);

  @Param({"sway", "hold", "free"})
  String does;

  @Param({"none", "measured"})
  String noise;

  private final ArmCommand[] commands = new ArmCommand[FRAMES];
  private DynamicArm arm;
  private int next;

  /** Makes the targets of a sway, or the same command again and again. */
  @Setup
  public void prepare() {
    ArmDescription description = ArmLibrary.load("ur5e");
    Payload payload = Payload.of(2, 0, 0, 0.1);
    ArmDynamics model = new ArmDynamics(description);
    model.setPayload(payload);
    ContactWorld world = new ContactWorld(Scene.EMPTY);
    ReadingNoise errors = ReadingNoise.NONE.withMeasured(noise.equals("measured"));
    arm = new DynamicArm(new DynamicArm.Setup(description, MIDDLE_RAD, model, world, errors, 1));
    arm.setLoad(payload);
    for (int frame = 0; frame < FRAMES; frame++) {
      commands[frame] =
          switch (does) {
            case "sway" -> sway(2 * Math.PI * (frame + 1) / FRAMES);
            case "hold" -> new ArmCommand.Servo(MIDDLE_RAD, Joints.ZERO, Joints.ZERO);
            case "free" -> pushing(2 * Math.PI * frame / FRAMES);
            default -> throw new IllegalStateException("does is " + does);
          };
    }
  }

  private static ArmCommand sway(double phaseRad) {
    double rate = 2 * Math.PI / (FRAMES * FrameTime.FRAME_S);
    double away = 0.3 * (1 - Math.cos(phaseRad));
    double speed = 0.3 * rate * Math.sin(phaseRad);
    double acceleration = 0.3 * rate * rate * Math.cos(phaseRad);
    double[] q = MIDDLE_RAD.toArray();
    for (int i = 0; i < q.length; i++) {
      q[i] += away;
    }
    return new ArmCommand.Servo(Joints.of(q), all(speed), all(acceleration));
  }

  private static ArmCommand pushing(double phaseRad) {
    return new ArmCommand.Torque(all(3 * Math.sin(phaseRad)), FrictionShare.MOST);
  }

  private static Joints all(double value) {
    return new Joints(value, value, value, value, value, value);
  }

  /** One frame. */
  @Benchmark
  public ArmSensors frame() {
    next = next + 1 == FRAMES ? 0 : next + 1;
    arm.step(commands[next]);
    return arm.sensors();
  }
}
