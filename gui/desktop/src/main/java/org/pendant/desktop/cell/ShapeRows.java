package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.util.function.BinaryOperator;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.unit.PoseRows;
import org.pendant.desktop.unit.RotationChoice;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;

/**
 * Shape rows: where a solid of one piece is, and how large, in a form. It is the object that the
 * form shows, or a part of it.
 *
 * @param part which solid
 * @param name with which names of fields begin
 * @param frame in words, what its pose is in
 */
record ShapeRows(
    PartsForm<SceneObject> form,
    RotationChoice rotation,
    ShapeRows.Part part,
    String name,
    Supplier<String> frame) {
  private static final Vector3 UNIT = new Vector3(1, 1, 1);

  /**
   * A solid of an object.
   *
   * @param get what it is
   * @param with the object with another one in its place
   */
  record Part(UnaryOperator<SceneObject> get, BinaryOperator<SceneObject> with) {
    /** The object itself. */
    static final Part WHOLE = new Part(object -> object, (object, part) -> part);

    SceneObject change(SceneObject object, UnaryOperator<SceneObject> change) {
      return with.apply(object, change.apply(get.apply(object)));
    }
  }

  /** Adds the rows of all shapes, each of which is there for its own. */
  void add() {
    section(SceneObject.Box.class, this::addBox);
    section(SceneObject.Sphere.class, this::addBall);
    section(SceneObject.Rod.class, this::addRod);
    section(SceneObject.Mesh.class, this::addMesh);
  }

  private void section(Class<? extends SceneObject> shape, Runnable rows) {
    form.section(object -> shape.isInstance(part.get.apply(object)), rows);
  }

  private void addPose(String what) {
    form.heading(() -> text("placeAndOrientation", what, frame.get()));
    PoseRows.addTo(
        form,
        name + "pose",
        rotation,
        object -> part.get.apply(object).poseInBase(),
        (object, pose) -> part.change(object, solid -> ObjectShape.at(solid, pose)),
        object -> true);
  }

  private void addBox() {
    addPose(text("centre"));
    form.heading(text("lengthsAlongItsOwnAxes"));
    Axes.addTo(
        form,
        "length",
        text("length"),
        Measure.MILLIMETRE,
        object -> part.get.apply(object) instanceof SceneObject.Box box ? box.sizeM() : UNIT,
        (object, sizeM) ->
            part.change(
                object,
                solid ->
                    solid instanceof SceneObject.Box box
                        ? new SceneObject.Box(
                            box.name(), box.poseInBase(), sizeM, box.material(), box.massKg())
                        : solid));
  }

  private void addBall() {
    form.heading(() -> text("centreIn", frame.get()));
    Axes.addTo(
        form,
        "centre",
        text("centre"),
        Measure.MILLIMETRE,
        object -> ObjectShape.placeM(part.get.apply(object)),
        (object, at) -> part.change(object, solid -> ObjectShape.at(solid, at)));
    form.numberRow(
        "radius",
        text("radius"),
        Measure.MILLIMETRE,
        object -> part.get.apply(object) instanceof SceneObject.Sphere ball ? ball.radiusM() : 1,
        (object, radiusM) ->
            part.change(
                object,
                solid ->
                    solid instanceof SceneObject.Sphere ball
                        ? new SceneObject.Sphere(
                            ball.name(),
                            ball.centreInBaseM(),
                            radiusM,
                            ball.material(),
                            ball.massKg())
                        : solid));
  }

  private void addRod() {
    addPose(text("centre"));
    form.heading(text("alongItsOwnZ"));
    form.numberRow(
        "radius",
        text("radius"),
        Measure.MILLIMETRE,
        object -> part.get.apply(object) instanceof SceneObject.Rod rod ? rod.radiusM() : 1,
        (object, radiusM) ->
            part.change(
                object,
                solid ->
                    solid instanceof SceneObject.Rod rod
                        ? sized(rod, radiusM, rod.lengthM())
                        : solid));
    form.numberRow(
        "length",
        text("length"),
        Measure.MILLIMETRE,
        object -> part.get.apply(object) instanceof SceneObject.Rod rod ? rod.lengthM() : 1,
        (object, lengthM) ->
            part.change(
                object,
                solid ->
                    solid instanceof SceneObject.Rod rod
                        ? sized(rod, rod.radiusM(), lengthM)
                        : solid));
  }

  private static SceneObject sized(SceneObject.Rod rod, double radiusM, double lengthM) {
    return new SceneObject.Rod(
        rod.name(),
        rod.poseInBase(),
        radiusM,
        lengthM,
        rod.capsule(),
        rod.material(),
        rod.massKg());
  }

  private void addMesh() {
    addPose(text("originOfItsFile"));
  }
}
