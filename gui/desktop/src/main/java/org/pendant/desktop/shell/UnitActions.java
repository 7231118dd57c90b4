package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.UnaryOperator;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.RotationForm;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.Settings;

/** Unit actions: in what all screens show lengths, angles and rotations. */
final class UnitActions {
  private final ActionTable actions;
  private final Settings settings;

  private UnitActions(ActionTable actions, Settings settings) {
    this.actions = actions;
    this.settings = settings;
  }

  /** Adds an action for each choice. */
  static void addTo(ActionTable actions, Settings settings) {
    UnitActions units = new UnitActions(actions, settings);
    for (DisplayUnit each : DisplayUnit.of(DisplayUnit.Kind.LENGTH)) {
      units.add(
          "length-" + each.symbol(),
          each.title(),
          () -> units.now().length() == each,
          now -> new PoseForm(each, now.angle(), now.rotation()));
    }
    for (DisplayUnit each : DisplayUnit.of(DisplayUnit.Kind.ANGLE)) {
      units.add(
          "angle-" + each.symbol(),
          each.title(),
          () -> units.now().angle() == each,
          now -> new PoseForm(now.length(), each, now.rotation()));
    }
    for (RotationForm each : RotationForm.values()) {
      units.add(
          "rotation-" + each.name().toLowerCase(Locale.ROOT).replace('_', '-'),
          each.toString().toLowerCase(Locale.ROOT),
          () -> units.now().rotation() == each,
          now -> new PoseForm(now.length(), now.angle(), each));
    }
  }

  private PoseForm now() {
    return FormMemory.read(settings);
  }

  private void add(
      String id, String title, BooleanSupplier chosen, UnaryOperator<PoseForm> choice) {
    actions.add(
        Action.of(
                "unit." + id,
                text("unitsAre", title),
                "",
                () -> FormMemory.write(settings, choice.apply(now())))
            .chosen(chosen));
  }
}
