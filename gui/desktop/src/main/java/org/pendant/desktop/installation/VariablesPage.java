package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import javax.swing.JComponent;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.kit.form.Items;
import org.pendant.kit.layout.TitledCard;

/** Variables page: variables that every program has, and that keep their values. */
final class VariablesPage implements Page {
  private final TitledCard card = new TitledCard("variables", text("variables"), "[grow, fill]");
  private final Items<InstallationVariable> items;

  VariablesPage(Editing editing) {
    items =
        new Items<>(
            "variable",
            text("installationVariables"),
            text("noVariableYetEveryProgramMade"),
            new Listed<>(editing, Installation::variables, (parts, all) -> parts.variables = all),
            each -> (each.favourite() ? "\u2605 " : "") + each.name() + " = " + each.value());
    items.adder(
        "add-variable",
        text("addVariable"),
        () -> new InstallationVariable(items.freshName("i_var"), "0", false));
    items
        .form()
        .text(
            "name",
            text("name"),
            InstallationVariable::name,
            (before, name) ->
                new InstallationVariable(name.strip(), before.value(), before.favourite()))
        .text(
            "value",
            text("value"),
            InstallationVariable::value,
            (before, value) ->
                new InstallationVariable(before.name(), value.strip(), before.favourite()))
        .check(
            "favourite",
            text("favourite"),
            InstallationVariable::favourite,
            (before, on) -> new InstallationVariable(before.name(), before.value(), on))
        .note(text("aValueIsALiteralOf"));
    card.add(items.component());
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public void show() {
    items.show();
  }
}
