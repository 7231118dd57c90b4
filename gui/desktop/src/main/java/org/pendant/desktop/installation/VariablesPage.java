package org.pendant.desktop.installation;

import javax.swing.JComponent;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.kit.form.Items;
import org.pendant.kit.layout.TitledCard;

/** Variables page: variables that every program has, and that keep their values. */
final class VariablesPage implements Page {
  private final TitledCard card = new TitledCard("Variables", "[grow, fill]");
  private final Items<InstallationVariable> items;

  VariablesPage(Editing editing) {
    items =
        new Items<>(
            "variable",
            "Installation variables",
            "No variable yet. Every program made of nodes has the variables that you add here, and"
                + " what it leaves in them is what the next one begins with.",
            new Listed<>(editing, Installation::variables, (parts, all) -> parts.variables = all),
            each -> (each.favourite() ? "\u2605 " : "") + each.name() + " = " + each.value());
    items.adder(
        "Add variable", () -> new InstallationVariable(items.freshName("i_var"), "0", false));
    items
        .form()
        .text(
            "Name",
            InstallationVariable::name,
            (before, name) ->
                new InstallationVariable(name.strip(), before.value(), before.favourite()))
        .text(
            "Value",
            InstallationVariable::value,
            (before, value) ->
                new InstallationVariable(before.name(), value.strip(), before.favourite()))
        .check(
            "Favourite",
            InstallationVariable::favourite,
            (before, on) -> new InstallationVariable(before.name(), before.value(), on))
        .note("A value is a literal of the language: 5, 0.5, True, \"text\", [1, 2] or p[...].");
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
