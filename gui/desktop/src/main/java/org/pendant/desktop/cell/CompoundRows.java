package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.pendant.cell.BodyShape;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.unit.PoseRows;
import org.pendant.desktop.unit.RotationChoice;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.models.pose.Pose;

/** Compound rows: the parts of an object in its form, one of which is chosen. */
final class CompoundRows {
  /** What a new one is put together of: a foot, and an upright at its end. */
  static final List<SceneObject> BRACKET =
      List.of(
          new SceneObject.Box("foot", at(0, 0.005), new Vector3(0.1, 0.05, 0.01), Material.DEFAULT),
          new SceneObject.Box(
              "upright", at(0.045, 0.05), new Vector3(0.01, 0.05, 0.08), Material.DEFAULT));

  private final Items<SceneObject> items;
  private final PartsForm<SceneObject> form;
  private final RotationChoice rotation;
  private final Supplier<String> frame;
  private final JComboBox<String> choice =
      TitledCard.named(new JComboBox<>(), "cell-object-parts", text("thePartThatIsShownBelow"));
  private final JButton remove =
      button(text("removePart"), "part-remove", text("removeTheChosenPart"));
  private final JButton add = button(text("addPartMenu"), "part-add", text("addPart"));
  private final JPopupMenu shapes = new JPopupMenu();
  private int chosen;
  private boolean showing;

  /**
   * @param frame in words, what places of objects are in
   */
  CompoundRows(Items<SceneObject> items, RotationChoice rotation, Supplier<String> frame) {
    this.items = items;
    this.rotation = rotation;
    this.frame = frame;
    form = items.form();
    choice.addActionListener(event -> choose(choice.getSelectedIndex()));
    remove.addActionListener(event -> change(this::withoutChosen));
    add.addActionListener(event -> shapes.show(add, 0, add.getHeight()));
  }

  private static Pose at(double x, double z) {
    return new Pose(x, 0, z, 0, 0, 0);
  }

  private static JButton button(String title, String name, String tip) {
    JButton button = new JButton(title);
    TitledCard.compact(button);
    return TitledCard.named(button, "cell-object-" + name, tip);
  }

  /** Whether its parts have masses of their own. */
  static boolean weighsByParts(SceneObject.Compound compound) {
    return compound.parts().getFirst().massKg() > 0;
  }

  /** Adds the rows; they are there while the form shows a compound. */
  void add() {
    form.heading(() -> text("frameAndOrientation", frame.get()));
    PoseRows.addTo(
        form,
        "pose",
        rotation,
        SceneObject::poseInBase,
        (object, pose) -> ObjectShape.at(object, pose),
        object -> true);
    form.heading(text("partsInItsFrame"));
    form.add(text("partLabel"), choice);
    form.follow(this::show);
    adder(text("box"), "box", CompoundRows::box);
    adder(text("ball"), "ball", CompoundRows::ball);
    adder(text("cylinder"), "cylinder", name -> rod(name, false));
    adder(text("capsule"), "capsule", name -> rod(name, true));
    form.buttons(add, remove);
    form.naming("part-");
    form.text(
        "part-name",
        text("partName"),
        object -> part(object).name(),
        (object, name) -> with(object, ObjectShape.named(part(object), name.strip())));
    new ShapeRows(
            form,
            rotation,
            new ShapeRows.Part(this::part, this::with),
            "part-",
            () -> text("inItsFrame"))
        .add();
    form.check(
        "parts-weigh-differently",
        text("partsWeighDifferently"),
        text("whetherEachPartHasAMass"),
        object -> object instanceof SceneObject.Compound all && weighsByParts(all),
        CompoundRows::weighing);
    form.section(
        object -> object instanceof SceneObject.Compound all && weighsByParts(all),
        () ->
            form.numberRow(
                "part-mass",
                text("partMass"),
                Measure.KILOGRAM,
                object -> part(object).massKg(),
                (object, massKg) -> with(object, ObjectShape.weighing(part(object), massKg))));
    form.naming("");
  }

  private static SceneObject box(String name) {
    return new SceneObject.Box(name, at(0, 0.05), new Vector3(0.02, 0.02, 0.02), Material.DEFAULT);
  }

  private static SceneObject rod(String name, boolean capsule) {
    return new SceneObject.Rod(name, at(0, 0.05), 0.01, 0.04, capsule, Material.DEFAULT, 0);
  }

  private static SceneObject ball(String name) {
    return new SceneObject.Sphere(name, new Vector3(0, 0, 0.05), 0.01, Material.DEFAULT);
  }

  private void adder(String title, String word, PartMaker maker) {
    JMenuItem entry = TitledCard.named(new JMenuItem(title), "cell-object-part-add-" + word, title);
    entry.addActionListener(
        event ->
            change(
                all -> {
                  SceneObject fresh = maker.named(freshName(word, all.parts()));
                  List<SceneObject> parts = new ArrayList<>(all.parts());
                  parts.add(weighsByParts(all) ? ObjectShape.weighing(fresh, 0.1) : fresh);
                  chosen = parts.size() - 1;
                  return all.of(parts);
                }));
    shapes.add(entry);
  }

  private interface PartMaker {
    SceneObject named(String name);
  }

  private static String freshName(String word, List<SceneObject> parts) {
    for (int number = 1; ; number++) {
      String name = word + " " + number;
      if (parts.stream().noneMatch(each -> each.name().equals(name))) {
        return name;
      }
    }
  }

  private SceneObject.Compound withoutChosen(SceneObject.Compound all) {
    List<SceneObject> parts = new ArrayList<>(all.parts());
    parts.remove(place(all));
    return all.of(parts);
  }

  private void change(UnaryOperator<SceneObject.Compound> change) {
    Optional<SceneObject> object = items.chosen();
    if (object.isPresent() && object.get() instanceof SceneObject.Compound all) {
      items.replace(change.apply(all));
    }
  }

  private void choose(int place) {
    if (!showing && place >= 0 && place != chosen) {
      chosen = place;
      items.chosen().ifPresent(form::showAfresh);
    }
  }

  private void show(SceneObject object) {
    if (!(object instanceof SceneObject.Compound all)) {
      return;
    }
    showing = true;
    choice.removeAllItems();
    for (SceneObject part : all.parts()) {
      choice.addItem(part.name() + "  (" + ObjectShape.words(part) + ")");
    }
    chosen = place(all);
    choice.setSelectedIndex(chosen);
    add.setEnabled(all.parts().size() < BodyShape.Compound.MAX_PARTS);
    remove.setEnabled(all.parts().size() > 1);
    showing = false;
  }

  private int place(SceneObject.Compound all) {
    return Math.clamp(chosen, 0, all.parts().size() - 1);
  }

  /** The chosen part; an object that has none is its own. */
  private SceneObject part(SceneObject object) {
    return object instanceof SceneObject.Compound all ? all.parts().get(place(all)) : object;
  }

  private SceneObject with(SceneObject object, SceneObject part) {
    if (!(object instanceof SceneObject.Compound all)) {
      return object;
    }
    List<SceneObject> parts = new ArrayList<>(all.parts());
    parts.set(place(all), part);
    return all.of(parts);
  }

  /** With masses of the parts that make up that of the whole, or the other way round. */
  private static SceneObject weighing(SceneObject object, boolean byParts) {
    if (!(object instanceof SceneObject.Compound all)) {
      return object;
    }
    return byParts ? all.weighingByParts() : all.weighing(all.massKg());
  }
}
