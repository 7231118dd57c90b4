package org.pendant.desktop.shell;

import java.awt.Component;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.swing.text.JTextComponent;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;

/**
 * Clipboard actions: cut, copy and paste in the text that has the keyboard, be it the editor or a
 * field; where no text has it, they mean the nodes of the tree.
 */
final class ClipboardActions {
  private final ActionTable actions;
  private final Supplier<Component> focus;

  private ClipboardActions(ActionTable actions, Supplier<Component> focus) {
    this.actions = actions;
    this.focus = focus;
  }

  /**
   * Adds the three.
   *
   * @param focus what has the keyboard, also while a menu is open; null for nothing
   */
  static void addTo(ActionTable actions, Supplier<Component> focus) {
    ClipboardActions all = new ClipboardActions(actions, focus);
    all.add(
        "cut",
        ShellTexts.text("cut"),
        "control X",
        each -> writable(each) && hasSelection(each),
        JTextComponent::cut);
    all.add(
        "copy",
        ShellTexts.text("copy"),
        "control C",
        ClipboardActions::hasSelection,
        JTextComponent::copy);
    all.add(
        "paste",
        ShellTexts.text("paste"),
        "control V",
        ClipboardActions::writable,
        JTextComponent::paste);
  }

  /** Adds one by its name, which the tree's own has too. */
  private void add(
      String name,
      String title,
      String keys,
      Predicate<JTextComponent> possible,
      Consumer<JTextComponent> inText) {
    actions.add(
        new Action(
            "edit." + name,
            title,
            keys,
            () -> text().map(possible::test).orElseGet(() -> ofTree(name).isPresent()),
            () ->
                text()
                    .ifPresentOrElse(
                        inText, () -> ofTree(name).ifPresent(each -> each.run().run()))));
  }

  private Optional<JTextComponent> text() {
    return focus.get() instanceof JTextComponent text ? Optional.of(text) : Optional.empty();
  }

  /** What the tree does by this name, if it can now. */
  private Optional<Action> ofTree(String name) {
    return actions.find("tree." + name).filter(each -> each.enabled().getAsBoolean());
  }

  private static boolean writable(JTextComponent text) {
    return text.isEditable() && text.isEnabled();
  }

  private static boolean hasSelection(JTextComponent text) {
    return text.getSelectionStart() < text.getSelectionEnd();
  }
}
