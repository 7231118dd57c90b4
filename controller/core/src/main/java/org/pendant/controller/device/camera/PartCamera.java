package org.pendant.controller.device.camera;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.pendant.controller.world.MovedObject;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Part camera: takes pictures of the objects that move. Each tells a part of the truth, as its
 * noise comes from a seed: the same questions have the same answers in each run.
 */
public final class PartCamera {
  /** The sum of so many uniform numbers of variance 1/12 has the variance 1, and is near normal. */
  private static final int UNIFORM_PARTS = 12;

  private final Supplier<List<MovedObject>> objects;
  private final View view;
  private final Optional<Pose> baseInCamera;
  private final Errors errors;
  private final SplittableRandom random;
  private List<MovedObject> last = List.of();
  private boolean sees;

  /**
   * By how much poses err.
   *
   * @param positionM standard deviation along each axis
   * @param rotationRad standard deviation about each axis
   * @param seed of the random numbers
   */
  public record Errors(double positionM, double rotationRad, long seed) {}

  /**
   * What it sees.
   *
   * @param inside whether an object is in its view
   * @param clear whether nothing hides one that is
   */
  public record View(Predicate<MovedObject> inside, Predicate<MovedObject> clear) {}

  /**
   * A camera that has taken no picture.
   *
   * @param objects where all objects are now; the same list while none moves
   * @param view what it sees of them
   * @param atInBase where it is, if it tells poses in its own frame and not in that of the base
   */
  public PartCamera(
      Supplier<List<MovedObject>> objects, View view, Optional<Pose> atInBase, Errors errors) {
    this.objects = objects;
    this.view = view;
    baseInCamera = atInBase.map(Poses::inverse);
    this.errors = errors;
    random = new SplittableRandom(errors.seed());
  }

  /** Whether a part is in its view in this frame, hidden or not. */
  public boolean sees() {
    List<MovedObject> now = objects.get();
    if (!now.equals(last)) {
      last = now;
      sees = now.stream().anyMatch(this::inside);
    }
    return sees;
  }

  private boolean inside(MovedObject each) {
    return each.there() && view.inside().test(each);
  }

  /**
   * Takes a picture: the parts in it, in the order of the scene.
   *
   * @param name of an object, which its copies have too; empty for all
   */
  public List<SeenPart> look(String name) {
    List<SeenPart> parts = new ArrayList<>();
    for (MovedObject each : objects.get()) {
      if (inside(each) && (name.isEmpty() || goesBy(each, name)) && view.clear().test(each)) {
        parts.add(new SeenPart(each.name(), told(each.poseInBase())));
      }
    }
    return parts;
  }

  /** Whether an object, or the one that it is a copy of, is called so. */
  public static boolean goesBy(MovedObject object, String name) {
    return object.name().equals(name) || object.original().equals(name);
  }

  private Pose told(Pose inBase) {
    Pose pose = baseInCamera.map(each -> Poses.trans(each, inBase)).orElse(inBase);
    double x = pose.x() + errors.positionM() * normal();
    double y = pose.y() + errors.positionM() * normal();
    double z = pose.z() + errors.positionM() * normal();
    double rx = errors.rotationRad() * normal();
    double ry = errors.rotationRad() * normal();
    double rz = errors.rotationRad() * normal();
    if (errors.rotationRad() == 0) {
      return new Pose(x, y, z, pose.rx(), pose.ry(), pose.rz());
    }
    Pose turned =
        Poses.trans(
            new Pose(0, 0, 0, rx, ry, rz), new Pose(0, 0, 0, pose.rx(), pose.ry(), pose.rz()));
    return new Pose(x, y, z, turned.rx(), turned.ry(), turned.rz());
  }

  private double normal() {
    double sum = -UNIFORM_PARTS / 2.0;
    for (int i = 0; i < UNIFORM_PARTS; i++) {
      sum += random.nextDouble();
    }
    return sum;
  }
}
