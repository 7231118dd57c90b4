package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComponent;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.unit.RotationChoice;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.pose.Pose;

/** Objects card: the solids around the arm, and a form for the chosen one. */
final class ObjectsCard {
  /** A step in front of the base, where most arms reach. */
  private static final double IN_FRONT_M = 0.4;

  private static final double ABREAST_M = 0.15;
  private static final int MAX_ABREAST = 5;
  private static final int MAX_TRIES = 12;
  private static final Vector3 UP = new Vector3(0, 0, 1);

  private final SceneDraft draft;
  private final TitledCard card = new TitledCard("objects", text("objects"), "[grow, fill]");
  private final Drafted drafted = new Drafted();
  private final Items<SceneObject> items;

  /**
   * @param measures in which lengths and angles are shown
   */
  ObjectsCard(
      SceneDraft draft,
      RotationChoice rotation,
      Measures measures,
      Supplier<ControllerState> state) {
    this.draft = draft;
    items =
        new Items<>(
            "cell-object",
            text("objectsAroundTheArm"),
            text("nothingIsAroundTheArmAdd"),
            drafted,
            each -> each.name() + "  (" + ObjectShape.words(each) + ")");
    items.adder(
        "add-plane",
        text("addPlane"),
        () ->
            new SceneObject.Plane(
                items.freshName("Plane"), new Vector3(0, 0, 0), UP, Material.DEFAULT));
    items.adder(
        "add-box",
        text("addBox"),
        () ->
            new SceneObject.Box(
                items.freshName("Box"),
                new Pose(IN_FRONT_M, besideM(), 0.05, 0, 0, 0),
                new Vector3(0.1, 0.1, 0.1),
                Material.DEFAULT));
    items.adder(
        "add-ball",
        text("addBall"),
        () ->
            new SceneObject.Sphere(
                items.freshName("Ball"),
                new Vector3(IN_FRONT_M, besideM(), 0.05),
                0.05,
                Material.DEFAULT));
    items.adder(
        "add-cylinder",
        text("addCylinder"),
        () ->
            new SceneObject.Rod(
                items.freshName("Cylinder"),
                new Pose(IN_FRONT_M, besideM(), 0.05, 0, 0, 0),
                0.03,
                0.1,
                false,
                Material.DEFAULT,
                0));
    items.adder(
        "add-compound",
        text("addCompound"),
        () ->
            new SceneObject.Compound(
                items.freshName("Compound"),
                new Pose(IN_FRONT_M, besideM(), 0, 0, 0, 0),
                CompoundRows.BRACKET,
                Material.DEFAULT,
                0));
    items.asker(
        "add-mesh",
        text("addMeshItem"),
        take ->
            MeshDialog.show(
                card,
                draft,
                (name, part, massKg) ->
                    take.accept(
                        clear(
                            new SceneObject.Mesh(
                                items.freshName(name),
                                new Pose(IN_FRONT_M, besideM(), 0, 0, 0, 0),
                                part,
                                Material.DEFAULT,
                                massKg)))));
    PartsForm<SceneObject> form =
        items.form().in(measures).telling(why -> ShownRange.of(why, measures));
    form.text(
        "name",
        text("name"),
        SceneObject::name,
        (object, name) -> ObjectShape.named(object, name.strip()));
    new ShapeRows(form, rotation, ShapeRows.Part.WHOLE, "", this::frame).add();
    form.section(SceneObject.Plane.class::isInstance, () -> addPlane(form));
    form.section(
        SceneObject.Compound.class::isInstance,
        () -> new CompoundRows(items, rotation, this::frame).add());
    form.section(
        ObjectsCard::weighsAsOne,
        () -> {
          form.numberRow(
              "mass", text("mass"), Measure.KILOGRAM, SceneObject::massKg, ObjectShape::weighing);
          form.note(text("withAMassItFallsSlides"));
        });
    JButton here = new JButton(text("putAtTcp"));
    TitledCard.compact(here);
    TitledCard.named(here, "cell-object-here", text("putItWhereTheTcpIs"));
    here.addActionListener(
        event ->
            items
                .chosen()
                .ifPresent(
                    object -> {
                      Pose tcp = state.get().arm().targetTcpInBase();
                      items.replace(ObjectShape.at(object, new Vector3(tcp.x(), tcp.y(), tcp.z())));
                    }));
    form.buttons(here);
    addMaterial(form);
    card.add(items.component());
  }

  /** Whether it has one mass, which people set. */
  private static boolean weighsAsOne(SceneObject object) {
    return object instanceof SceneObject.Compound compound
        ? !CompoundRows.weighsByParts(compound)
        : !(object instanceof SceneObject.Plane);
  }

  /** A mesh that stands on z = 0, beside what does not leave it any room. */
  private SceneObject clear(SceneObject.Mesh mesh) {
    // in tenths of a millimetre, which people can read
    double upM = 0 - Math.rint(1e4 * mesh.part().triangles().least(2)) / 1e4;
    SceneObject first = ObjectShape.at(mesh, new Vector3(IN_FRONT_M, besideM(), upM));
    for (int i = 0; i < MAX_TRIES; i++) {
      SceneObject there =
          ObjectShape.at(
              mesh,
              new Vector3(IN_FRONT_M, Math.rint(1e4 * (besideM() + i * ABREAST_M)) / 1e4, upM));
      List<SceneObject> with = new ArrayList<>(draft.scene().objects());
      with.add(there);
      if (drafted.refusal(with).isEmpty()) {
        return there;
      }
    }
    return first;
  }

  /** Beside the others: what is new can be seen. */
  private double besideM() {
    long others =
        draft.scene().objects().stream()
            .filter(each -> !(each instanceof SceneObject.Plane))
            .count();
    return others % MAX_ABREAST * ABREAST_M;
  }

  /** What places are in: the base of the only arm, or the cell where there are several. */
  private String frame() {
    return SceneFrame.words(draft);
  }

  private void addPlane(PartsForm<SceneObject> form) {
    form.heading(() -> text("aPointOfIt", frame()));
    Axes.addTo(
        form, "point", text("point"), Measure.MILLIMETRE, ObjectShape::placeM, ObjectShape::at);
    form.heading(text("directionOutOfTheSolid"));
    Axes.addTo(
        form,
        "normal",
        text("normal"),
        Measure.PLAIN,
        object -> object instanceof SceneObject.Plane plane ? plane.normalInBase() : UP,
        (object, normal) ->
            object instanceof SceneObject.Plane plane
                ? new SceneObject.Plane(
                    plane.name(), plane.pointInBaseM(), normal, plane.material())
                : object);
  }

  private static void addMaterial(PartsForm<SceneObject> form) {
    form.heading(text("surface"));
    form.numberRow(
        "stiffness",
        text("stiffness"),
        Measure.NEWTON_PER_METRE,
        object -> object.material().stiffnessNPerM(),
        (object, stiffness) -> {
          Material now = object.material();
          return ObjectShape.of(
              object,
              new Material(stiffness, now.dampingSPerM(), now.friction(), now.restitution()));
        });
    form.numberRow(
        "damping",
        text("damping"),
        Measure.SECOND_PER_METRE,
        object -> object.material().dampingSPerM(),
        (object, damping) -> {
          Material now = object.material();
          return ObjectShape.of(
              object,
              new Material(now.stiffnessNPerM(), damping, now.friction(), now.restitution()));
        });
    form.numberRow(
        "friction",
        text("friction"),
        Measure.PLAIN,
        object -> object.material().friction(),
        (object, friction) -> {
          Material now = object.material();
          return ObjectShape.of(
              object,
              new Material(now.stiffnessNPerM(), now.dampingSPerM(), friction, now.restitution()));
        });
    form.numberRow(
        "restitution",
        text("restitution"),
        Measure.PLAIN,
        object -> object.material().restitution(),
        (object, restitution) -> {
          Material now = object.material();
          return ObjectShape.of(
              object,
              new Material(now.stiffnessNPerM(), now.dampingSPerM(), now.friction(), restitution));
        });
  }

  /** The objects of the draft. */
  private final class Drafted implements Items.Model<SceneObject> {
    @Override
    public List<SceneObject> list() {
      return draft.scene().objects();
    }

    @Override
    public String refusal(List<SceneObject> next) {
      return SceneRefusal.of(() -> with(next), draft, following(next));
    }

    private Map<String, String> following(List<SceneObject> next) {
      return Equipment.following(draft.equipment(), list(), next);
    }

    private Scene with(List<SceneObject> next) {
      Scene now = draft.scene();
      return now.withObjects(next);
    }

    @Override
    public void take(
        List<SceneObject> next, Optional<SceneObject> before, Optional<SceneObject> after) {
      draft.set(with(next), following(next));
    }
  }

  JComponent component() {
    return card;
  }

  /** Shows the form of an object. */
  void choose(String name) {
    draft.scene().objects().stream()
        .filter(each -> each.name().equals(name))
        .findFirst()
        .ifPresent(items::choose);
  }

  /** Shows the draft. */
  void show() {
    items.show();
  }
}
