package org.pendant.bench;

import java.util.ArrayList;
import java.util.List;
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
import org.pendant.cell.BodyDescription;
import org.pendant.cell.BodyShape;
import org.pendant.cell.BodySurface;
import org.pendant.cell.RigidBodyWorld;
import org.pendant.models.mesh.ConvexHull;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;

/** A frame of rigid bodies on a floor, with a guided ball above them as the tool is. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@State(Scope.Thread)
public class RigidBodyBenchmark {
  private static final double[] ABOVE = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 5};
  private static final double[] SPEED = {0.1, 0, 0, 0, 0, 0};

  /** What the bodies do: boxes that rest, boxes that slide, a tower of 12. */
  public enum Doing {
    /** 50 boxes at rest. */
    REST,
    /** 20 boxes that are dragged over the floor. */
    SLIDE,
    /** 12 boxes on one another, kept awake. */
    TOWER
  }

  /** What they are: boxes, the same as hulls, or prisms of 32 sides with 64 corners. */
  public enum Made {
    /** Boxes of the physics library. */
    BOX,
    /** Hulls of 8 corners. */
    HULL,
    /** Hulls of 64 corners. */
    PRISM
  }

  /** What is measured. */
  @Param public Doing doing;

  /** Of what. */
  @Param public Made made;

  private RigidBodyWorld world;

  @Setup
  public void make() {
    BodySurface surface = new BodySurface(0.5, 0, BodySurface.DEFAULT.stiffnessNPerM());
    List<BodyDescription> bodies = new ArrayList<>();
    bodies.add(
        BodyDescription.kinematic(
            "tool", new BodyShape.Sphere(0.01), Pose.ZERO.with(2, 5), surface));
    bodies.add(BodyDescription.fixed("floor", new BodyShape.HalfSpace(), Pose.ZERO, surface));
    int count =
        switch (doing) {
          case REST -> 50;
          case SLIDE -> 20;
          case TOWER -> 12;
        };
    for (int i = 0; i < count; i++) {
      Pose pose =
          doing == Doing.TOWER
              ? new Pose(0, 0, 0.05 + 0.1 * i, 0, 0, 0)
              : new Pose(-4 + 0.15 * i, 0, 0.05, 0, 0, 0);
      bodies.add(BodyDescription.free("box " + i, shape(), pose, 1, surface));
    }
    world = new RigidBodyWorld(bodies, 0, 0, -9.82);
    for (int i = 0; i < 1000; i++) {
      frame();
    }
  }

  private BodyShape shape() {
    double moment = 0.01 / 6;
    return switch (made) {
      case BOX -> new BodyShape.Box(0.1, 0.1, 0.1);
      case HULL -> new BodyShape.Hull(ConvexHull.block(0.1, 0.1, 0.1), moment, moment, moment);
      case PRISM -> new BodyShape.Hull(ConvexHull.prism(32, 0.05, 0.1), moment, moment, moment);
    };
  }

  @Benchmark
  public void frame() {
    world.moveKinematic(0, ABOVE, SPEED);
    if (doing == Doing.SLIDE) {
      for (int i = 2; i < world.size(); i++) {
        world.throwBody(i, SPEED);
      }
    } else if (doing == Doing.TOWER) {
      world.throwBody(2, new double[6]);
    }
    world.advance(FrameTime.FRAME_S);
  }
}
