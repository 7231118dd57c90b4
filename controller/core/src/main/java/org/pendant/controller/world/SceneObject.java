package org.pendant.controller.world;

import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/**
 * Scene object: a solid that the tool can touch. One without a mass stands still, whatever pushes
 * it; one with a mass falls, slides and can be pushed.
 */
public sealed interface SceneObject {
  /** How it is called, in 1 to 60 letters; unique in its scene. */
  String name();

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

    /** One that stands still. */
    public Sphere(String name, Vector3 centreInBaseM, double radiusM, Material material) {
      this(name, centreInBaseM, radiusM, material, 0);
    }
  }
}
