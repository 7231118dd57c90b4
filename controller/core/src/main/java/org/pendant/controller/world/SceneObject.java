package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.cell.BodyShape;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Scene object: a solid that the tool can touch. One without a mass stands still, whatever pushes
 * it; one with a mass falls, slides and can be pushed.
 */
public sealed interface SceneObject {
  /** How it is called, in 1 to 60 letters; unique in its scene. */
  String name();

  /** Where its frame is, or its middle; of a plane a point of it. */
  Pose poseInBase();

  /** What its surface is of. */
  Material material();

  /** What it weighs, kg, where it can move; 0 where it stands still. */
  default double massKg() {
    return 0;
  }

  /**
   * Everything behind a plane: a table, a floor, a wall.
   *
   * @param name how it is called
   * @param pointInBaseM a point of the plane, m, each -10 to 10
   * @param normalInBase the direction out of the solid; any length from 0.001 to 1000 will do, kept
   *     with length 1
   * @param material what it is of
   */
  record Plane(String name, Vector3 pointInBaseM, Vector3 normalInBase, Material material)
      implements SceneObject {
    static final Range NORMAL = new Range(-1000, 1000, "");
    static final Range NORMAL_LENGTH = new Range(0.001, 1000, "");

    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is outside its range
     */
    public Plane {
      ObjectName.require(name);
      pointInBaseM.require("point", SceneRange.POSITION);
      NORMAL_LENGTH.require("length of normal", normalInBase.length());
      normalInBase = normalInBase.unit();
    }

    @Override
    public Pose poseInBase() {
      return pointInBaseM.asPose();
    }
  }

  /**
   * What it is put together of, as objects without a mass in the base frame; itself where it is of
   * one piece.
   */
  default List<SceneObject> pieces() {
    return List.of(this);
  }

  /**
   * A block.
   *
   * @param name how it is called
   * @param poseInBase its centre, m, each -10 to 10, and orientation, rad, each -100 to 100
   * @param sizeM lengths of its sides along its own axes, m, each 0.001 to 10
   * @param material what it is of
   * @param massKg 0 where it stands still; else it can move, kg, 0.001 to 1000
   */
  record Box(String name, Pose poseInBase, Vector3 sizeM, Material material, double massKg)
      implements SceneObject {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is outside its range
     */
    public Box {
      ObjectName.require(name);
      for (int i = 0; i < Pose.SIZE; i++) {
        poseRange(i).require("pose[" + i + "]", poseInBase.get(i));
      }
      sizeM.require("size", SceneRange.SIZE);
      SceneRange.requireMass(massKg);
    }

    /** One that stands still. */
    public Box(String name, Pose poseInBase, Vector3 sizeM, Material material) {
      this(name, poseInBase, sizeM, material, 0);
    }

    /** What component {@code i} of the pose may be. */
    static Range poseRange(int i) {
      return i < 3 ? SceneRange.POSITION : SceneRange.ROTATION;
    }
  }

  /**
   * A round bar along its own z.
   *
   * @param name how it is called
   * @param poseInBase its centre, m, each -10 to 10, and orientation, rad, each -100 to 100
   * @param radiusM its radius, m, 0.001 to 10
   * @param lengthM its length, m, 0.001 to 10; that of a capsule without its ends
   * @param capsule whether it has half a ball at each end, rather than being flat there
   * @param material what it is of
   * @param massKg 0 where it stands still; else it can move, kg, 0.001 to 1000
   */
  record Rod(
      String name,
      Pose poseInBase,
      double radiusM,
      double lengthM,
      boolean capsule,
      Material material,
      double massKg)
      implements SceneObject {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is outside its range
     */
    public Rod {
      ObjectName.require(name);
      for (int i = 0; i < Pose.SIZE; i++) {
        Box.poseRange(i).require("pose[" + i + "]", poseInBase.get(i));
      }
      SceneRange.SIZE.require("radius", radiusM);
      SceneRange.SIZE.require("length", lengthM);
      SceneRange.requireMass(massKg);
    }

    /** The type of it in a file. */
    public String type() {
      return capsule ? "capsule" : "cylinder";
    }
  }

  /**
   * A solid made of triangles. One with a mass touches others with its convex hull.
   *
   * @param name how it is called
   * @param poseInBase where the origin of its file is, m, each -10 to 10, and its orientation, rad,
   *     each -100 to 100
   * @param part its triangles
   * @param material what it is of
   * @param massKg 0 where it stands still; else it can move, kg, 0.001 to 1000, evenly spread in
   *     the solid that the triangles are the surface of
   */
  record Mesh(String name, Pose poseInBase, MeshPart part, Material material, double massKg)
      implements SceneObject {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is outside its range, or if it has a mass and is too
     *     thin for a body, or goes through itself
     */
    public Mesh {
      ObjectName.require(name);
      for (int i = 0; i < Pose.SIZE; i++) {
        Box.poseRange(i).require("pose[" + i + "]", poseInBase.get(i));
      }
      SceneRange.requireMass(massKg);
      if (massKg > 0) {
        var _ = new MeshBody(part.triangles());
      }
    }

    /** One that stands still. */
    public Mesh(String name, Pose poseInBase, MeshPart part, Material material) {
      this(name, poseInBase, part, material, 0);
    }
  }

  /**
   * Several solids that are rigidly joined.
   *
   * @param name how it is called
   * @param poseInBase where its frame is, m, each -10 to 10, and its orientation, rad, each -100 to
   *     100
   * @param parts 1 to {@value BodyShape.Compound#MAX_PARTS} solids of one piece; what they call
   *     their pose in the base is one in its frame. One that moves meets others with the convex
   *     hulls of those that are meshes
   * @param material what all of it is of, whatever parts say
   * @param wholeKg what all of it weighs, kg, evenly spread in its parts; 0 where parts have a mass
   *     of their own, or it stands still
   */
  record Compound(
      String name, Pose poseInBase, List<SceneObject> parts, Material material, double wholeKg)
      implements SceneObject {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is outside its range, if a part is none, or if some
     *     have a mass and others have not
     */
    public Compound {
      ObjectName.require(name);
      parts = List.copyOf(parts);
      for (int i = 0; i < Pose.SIZE; i++) {
        Box.poseRange(i).require("pose[" + i + "]", poseInBase.get(i));
      }
      if (parts.isEmpty() || parts.size() > BodyShape.Compound.MAX_PARTS) {
        throw new IllegalArgumentException(
            text("partsCount", parts.size(), BodyShape.Compound.MAX_PARTS));
      }
      long weighed = parts.stream().filter(part -> part.massKg() > 0).count();
      if (wholeKg != 0 && weighed > 0) {
        throw new IllegalArgumentException(text("massOfWhole"));
      }
      if (weighed > 0 && weighed < parts.size()) {
        throw new IllegalArgumentException(text("partsWithMass", weighed, parts.size()));
      }
      SceneRange.requireMass(wholeKg);
      SceneRange.requireMass(parts.stream().mapToDouble(SceneObject::massKg).sum());
      for (SceneObject part : parts) {
        if (part instanceof Plane || part instanceof Compound) {
          throw new IllegalArgumentException(text("partsShapes"));
        }
        if (!SceneRange.holds(Poses.trans(poseInBase, part.poseInBase()))) {
          throw new IllegalArgumentException(text("beyondPlace", part.name()));
        }
        if (wholeKg > 0 && part instanceof Mesh mesh) {
          var _ = new MeshBody(mesh.part().triangles());
        }
      }
    }

    @Override
    public double massKg() {
      return wholeKg > 0 ? wholeKg : parts.stream().mapToDouble(SceneObject::massKg).sum();
    }

    /** What a part weighs, kg: its own mass, or its share of that of the whole by its volume. */
    double partKg(int part) {
      double ownKg = parts.get(part).massKg();
      return wholeKg > 0 ? wholeKg * volumeM3(parts.get(part)) / volumeM3() : ownKg;
    }

    /** What its parts fill, m^3; where they overlap, twice. */
    double volumeM3() {
      return parts.stream().mapToDouble(Compound::volumeM3).sum();
    }

    /** What a solid of one piece fills, m^3. */
    static double volumeM3(SceneObject part) {
      return switch (part) {
        case Box box -> box.sizeM().x() * box.sizeM().y() * box.sizeM().z();
        case Rod rod -> {
          double disc = Math.PI * rod.radiusM() * rod.radiusM();
          yield disc * (rod.lengthM() + (rod.capsule() ? 4 * rod.radiusM() / 3 : 0));
        }
        case Sphere ball -> 4 * Math.PI / 3 * ball.radiusM() * ball.radiusM() * ball.radiusM();
        case Mesh mesh -> mesh.part().triangles().volumeM3();
        case Plane _, Compound _ -> throw new IllegalArgumentException(text("noVolume"));
      };
    }

    /** The same elsewhere. */
    public Compound at(Pose otherInBase) {
      return new Compound(name, otherInBase, parts, material, wholeKg);
    }

    /** The same with another name. */
    public Compound named(String other) {
      return new Compound(other, poseInBase, parts, material, wholeKg);
    }

    /** The same with other parts. */
    public Compound of(List<SceneObject> others) {
      return new Compound(name, poseInBase, others, material, wholeKg);
    }

    /** The same of another material. */
    public Compound of(Material other) {
      return new Compound(name, poseInBase, parts, other, wholeKg);
    }

    /**
     * The same with another mass, evenly spread.
     *
     * @param kg 0 for one that stands still
     */
    public Compound weighing(double kg) {
      return new Compound(
          name, poseInBase, parts.stream().map(Compound::still).toList(), material, kg);
    }

    /** The same with parts that weigh what they do already, each by itself; 1 kg together if 0. */
    public Compound weighingByParts() {
      Compound heavy = massKg() > 0 ? this : weighing(1);
      List<SceneObject> weighed = new ArrayList<>();
      for (SceneObject part : parts) {
        // as people would write it; at least what a part may weigh
        double kg = Math.rint(1000 * heavy.partKg(weighed.size())) / 1000;
        weighed.add(weighing(part, Math.max(SceneRange.MASS.least(), kg)));
      }
      return new Compound(name, poseInBase, weighed, material, 0);
    }

    private static SceneObject weighing(SceneObject part, double kg) {
      return switch (part) {
        case Box box -> new Box(box.name(), box.poseInBase(), box.sizeM(), box.material(), kg);
        case Rod rod ->
            new Rod(
                rod.name(),
                rod.poseInBase(),
                rod.radiusM(),
                rod.lengthM(),
                rod.capsule(),
                rod.material(),
                kg);
        case Sphere ball ->
            new Sphere(ball.name(), ball.centreInBaseM(), ball.radiusM(), ball.material(), kg);
        case Mesh mesh ->
            new Mesh(mesh.name(), mesh.poseInBase(), mesh.part(), mesh.material(), kg);
        case Plane _, Compound _ -> part;
      };
    }

    @Override
    public List<SceneObject> pieces() {
      return parts.stream()
          .map(part -> MovedScene.at(part, name, Poses.trans(poseInBase, part.poseInBase())))
          .toList();
    }

    private static SceneObject still(SceneObject part) {
      return MovedScene.at(part, part.name(), part.poseInBase());
    }
  }

  /**
   * A ball.
   *
   * @param name how it is called
   * @param centreInBaseM its centre, m, each -10 to 10
   * @param radiusM its radius, m, 0.001 to 10
   * @param material what it is of
   * @param massKg 0 where it stands still; else it can move, kg, 0.001 to 1000
   */
  record Sphere(
      String name, Vector3 centreInBaseM, double radiusM, Material material, double massKg)
      implements SceneObject {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is outside its range
     */
    public Sphere {
      ObjectName.require(name);
      centreInBaseM.require("centre", SceneRange.POSITION);
      SceneRange.SIZE.require("radius", radiusM);
      SceneRange.requireMass(massKg);
    }

    @Override
    public Pose poseInBase() {
      return centreInBaseM.asPose();
    }

    /** One that stands still. */
    public Sphere(String name, Vector3 centreInBaseM, double radiusM, Material material) {
      this(name, centreInBaseM, radiusM, material, 0);
    }
  }
}
