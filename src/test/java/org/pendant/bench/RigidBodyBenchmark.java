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

/** A frame of rigid bodies of each shape, with a guided ball above them as the tool is. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@State(Scope.Thread)
public class RigidBodyBenchmark {
  private static final double[] ABOVE = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 5};
  private static final double[] SPEED = {0.1, 0, 0, 0, 0, 0};
  private static final double[] NUDGE = {0, 0, 0.02, 0, 0, 0};
  private static final BodySurface SURFACE =
      new BodySurface(0.5, 0, BodySurface.DEFAULT.stiffnessNPerM());

  /** Moment of inertia of hulls for each kg, m^2. */
  private static final double HULL_M2 = 0.08 * 0.08 / 6;

  /** So many frames go one way, and as many back. */
  private static final int TURN_FRAMES = 500;

  /** What the bodies do. */
  public enum Doing {
    /** 50 rest on the floor. */
    REST,
    /** 20 stand or lie on a belt that runs to and fro. */
    BELT,
    /** 20 are dragged over a table to and fro. */
    TABLE,
    /** 20 lie in a heap in a tray that is shaken. */
    PILE,
    /** 12 stand on one another, kept awake; balls stand in a row. */
    TOWER
  }

  /** What they are. */
  public enum Shape {
    /** Boxes. */
    BOX,
    /** Cylinders that stand. */
    CYLINDER,
    /** Cylinders that lie. */
    LYING_CYLINDER,
    /** Capsules that lie. */
    CAPSULE,
    /** Balls. */
    SPHERE,
    /** One after the other of all these. */
    MIX,
    /** Boxes as hulls of 8 corners. */
    HULL,
    /** Cylinders that stand, as hulls of 64 corners. */
    PRISM;

    private Shape at(int i) {
      return this == MIX ? values()[i % MIX.ordinal()] : this;
    }

    private BodyShape shape() {
      return switch (this) {
        case BOX, MIX -> new BodyShape.Box(0.08, 0.08, 0.08);
        case CYLINDER -> new BodyShape.Cylinder(0.04, 0.08);
        case LYING_CYLINDER -> new BodyShape.Cylinder(0.04, 0.08);
        case CAPSULE -> new BodyShape.Capsule(0.04, 0.06);
        case SPHERE -> new BodyShape.Sphere(0.04);
        case HULL ->
            new BodyShape.Hull(ConvexHull.block(0.08, 0.08, 0.08), HULL_M2, HULL_M2, HULL_M2);
        case PRISM ->
            new BodyShape.Hull(ConvexHull.prism(32, 0.04, 0.08), HULL_M2, HULL_M2, HULL_M2);
      };
    }

    private double tilt() {
      return this == LYING_CYLINDER || this == CAPSULE ? Math.PI / 2 : 0;
    }
  }

  /** What is measured. */
  @Param public Doing doing;

  /** Of which bodies. */
  @Param public Shape shape;

  private RigidBodyWorld world;
  private int frames;

  @Setup
  public void make() {
    List<BodyDescription> bodies = new ArrayList<>();
    bodies.add(
        BodyDescription.kinematic(
            "tool", new BodyShape.Sphere(0.01), Pose.ZERO.with(2, 5), SURFACE));
    bodies.add(
        doing == Doing.REST
            ? BodyDescription.fixed("floor", new BodyShape.HalfSpace(), Pose.ZERO, SURFACE)
            : wall("floor", 9, 2, 0.2, 0, 0, -0.1));
    if (doing == Doing.PILE) {
      bodies.add(wall("left", 0.02, 0.5, 2, -0.16, 0, 1));
      bodies.add(wall("right", 0.02, 0.5, 2, 0.16, 0, 1));
      bodies.add(wall("front", 0.3, 0.02, 2, 0, -0.16, 1));
      bodies.add(wall("back", 0.3, 0.02, 2, 0, 0.16, 1));
    }
    int first = bodies.size();
    int count = doing == Doing.REST ? 50 : doing == Doing.TOWER ? 12 : 20;
    for (int i = 0; i < count; i++) {
      Shape one = shape.at(i);
      bodies.add(BodyDescription.free("body " + i, one.shape(), place(i, one.tilt()), 1, SURFACE));
    }
    world = new RigidBodyWorld(bodies, 0, 0, -9.82);
    firstFree = first;
    frames = 0;
    for (int i = 0; i < 2 * TURN_FRAMES; i++) {
      frame();
    }
  }

  private int firstFree;

  private Pose place(int i, double tilt) {
    return switch (doing) {
      case TOWER ->
          shape == Shape.SPHERE || shape == Shape.CAPSULE || shape == Shape.MIX
              ? new Pose(0.1 * i, 0, 0.04, tilt, 0, 0)
              : new Pose(0.001 * (i % 2), 0, 0.04 + 0.08 * i, tilt, 0, 0);
      case PILE ->
          new Pose(
              0.09 * (i % 2) - 0.045,
              0.02 * (i % 3),
              0.08 + 0.16 * (i / 2),
              tilt,
              0.1 * (i % 3),
              0);
      case REST, BELT, TABLE -> new Pose(-3 + 0.15 * i, 0, 0.04, tilt, 0, 0);
    };
  }

  private static BodyDescription wall(
      String name, double sizeX, double sizeY, double sizeZ, double x, double y, double z) {
    return BodyDescription.fixed(
        name, new BodyShape.Box(sizeX, sizeY, sizeZ), new Pose(x, y, z, 0, 0, 0), SURFACE);
  }

  @Benchmark
  public void frame() {
    double way = frames++ / TURN_FRAMES % 2 == 0 ? 1 : -1;
    boolean turn = frames % TURN_FRAMES == 1;
    world.moveKinematic(0, ABOVE, SPEED);
    switch (doing) {
      case REST -> {}
      case BELT -> {
        if (turn) {
          world.runSurface(1, 0.2 * way, 0, 0);
        }
      }
      case TABLE -> {
        double[] dragged = {0.1 * way, 0, 0, 0, 0, 0};
        for (int i = firstFree; i < world.size(); i++) {
          world.throwBody(i, dragged);
        }
      }
      case PILE -> {
        if (turn) {
          world.runSurface(1, 0.2 * way, 0.1 * way, 0);
        }
      }
      case TOWER -> {
        if (shape == Shape.SPHERE || shape == Shape.CAPSULE || shape == Shape.MIX) {
          world.throwBody(firstFree + frames % 12, NUDGE);
        } else {
          world.throwBody(firstFree, new double[6]);
        }
      }
    }
    world.advance(FrameTime.FRAME_S);
  }
}
