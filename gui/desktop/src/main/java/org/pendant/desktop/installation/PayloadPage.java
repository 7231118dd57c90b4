package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationParts;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.world.Vector3;
import org.pendant.kit.form.EntryField;
import org.pendant.kit.form.Items;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** Payload page: the payloads, and the one that is active when a program starts. */
final class PayloadPage implements Page {
  private static final List<String> AXES = List.of("X", "Y", "Z");
  private static final List<String> INERTIA = List.of("Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz");

  private final Editing editing;
  private final TitledCard card = new TitledCard("payload", text("payload"), "[grow, fill]");
  private final Items<NamedPayload> items;
  private final PartsForm<Installation> active;

  PayloadPage(Editing editing) {
    this.editing = editing;
    items =
        new Items<>(
            "payload",
            text("payloads"),
            text("noPayloadYetTheFlangeCarries"),
            new Listed<>(
                editing,
                Installation::payloads,
                (parts, all) -> parts.payloads = all,
                PayloadPage::follow),
            payload -> isActive(payload) ? text("activeOne", payload.name()) : payload.name());
    items.adder(
        "add-payload",
        text("addPayload"),
        () -> new NamedPayload(items.freshName("Payload"), 0, new Vector3(0, 0, 0), Inertia.NONE));
    PartsForm<NamedPayload> form = items.form().in(editing.measures());
    form.text(
        "name",
        text("name"),
        NamedPayload::name,
        (before, name) ->
            new NamedPayload(name.strip(), before.massKg(), before.cogM(), before.inertia()));
    form.numberRow(
        "mass",
        text("mass"),
        Measure.KILOGRAM,
        NamedPayload::massKg,
        (before, kg) -> new NamedPayload(before.name(), kg, before.cogM(), before.inertia()));
    form.heading(text("centreOfGravityInTheFlange"));
    for (int i = 0; i < AXES.size(); i++) {
      int axis = i;
      form.numberRow(
          "C" + AXES.get(i),
          "C" + AXES.get(i),
          Measure.MILLIMETRE,
          now -> axis(now.cogM(), axis),
          (before, m) ->
              new NamedPayload(
                  before.name(), before.massKg(), with(before.cogM(), axis, m), before.inertia()));
    }
    form.heading(text("inertiaAboutTheCentreOfGravity"));
    addInertia(form);
    JButton set = new JButton(text("setPayload"));
    TitledCard.named(set, "payload-set", text("makeThisTheActivePayload"));
    set.addActionListener(
        event ->
            items
                .chosen()
                .ifPresent(payload -> editing.take(p -> p.activePayload = payload.name())));
    form.buttons(set);
    active = new PartsForm<>("payload-active", editing::whole, editing::takeWhole);
    active.choice(
        "active-payload",
        text("activePayload"),
        PayloadPage::names,
        name -> name.isEmpty() ? text("noPayload") : name,
        Installation::activePayload,
        (before, name) -> before.with(parts -> parts.activePayload = name));
    card.add(active.component());
    card.add(items.component());
  }

  private static void addInertia(PartsForm<NamedPayload> form) {
    JPanel grid =
        new JPanel(
            new MigLayout("insets 0, gap 6, wrap 4", "[][50:100:130, fill]16[][50:100:130, fill]"));
    grid.setOpaque(false);
    List<EntryField> fields = new ArrayList<>();
    for (int row = 0; row < AXES.size(); row++) {
      for (int index : new int[] {row, row + AXES.size()}) {
        String name = INERTIA.get(index);
        EntryField field =
            form.number(
                name.toLowerCase(Locale.ROOT),
                name,
                Measure.KILOGRAM_METRE2,
                now -> elements(now.inertia())[index],
                (before, value) -> {
                  double[] elements = elements(before.inertia());
                  elements[index] = value;
                  return new NamedPayload(
                      before.name(), before.massKg(), before.cogM(), Inertia.of(elements));
                });
        JLabel label = new JLabel(name);
        label.setLabelFor(field);
        grid.add(label);
        grid.add(field, "wmin 50, wmax 160");
        fields.add(field);
      }
    }
    form.grid(grid, fields);
    form.note(text("inKgMAll0For"));
  }

  private static double[] elements(Inertia inertia) {
    return new double[] {
      inertia.ixx(), inertia.iyy(), inertia.izz(), inertia.ixy(), inertia.ixz(), inertia.iyz()
    };
  }

  private static double axis(Vector3 vector, int axis) {
    return axis == 0 ? vector.x() : axis == 1 ? vector.y() : vector.z();
  }

  private static Vector3 with(Vector3 vector, int axis, double value) {
    return new Vector3(
        axis == 0 ? value : vector.x(),
        axis == 1 ? value : vector.y(),
        axis == 2 ? value : vector.z());
  }

  private boolean isActive(NamedPayload payload) {
    return payload.name().equals(editing.now().activePayload());
  }

  private static List<String> names(Installation installation) {
    List<String> names = new ArrayList<>(List.of(""));
    installation.payloads().forEach(each -> names.add(each.name()));
    return names;
  }

  private static void follow(
      InstallationParts parts, Optional<NamedPayload> before, Optional<NamedPayload> after) {
    if (before.isPresent() && before.get().name().equals(parts.activePayload)) {
      parts.activePayload = after.map(NamedPayload::name).orElse("");
    }
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    active.show(editing.now());
    items.show();
  }
}
