package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.BooleanSupplier;
import javax.swing.KeyStroke;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.Actions;
import org.pendant.project.program.NodeKind;

/** Tree actions: what can be done on the Program screen, by name and key. */
final class TreeActions {
  /** Their ids begin so. */
  static final String PREFIX = "tree.";

  /** Those that add nodes begin so. */
  static final String ADD = PREFIX + "add-";

  /** What is meant for the tree alone: elsewhere on the screen its keys mean something else. */
  private static final Set<String> IN_TREE =
      Set.of(
          "cut",
          "copy",
          "paste",
          "delete",
          "duplicate",
          "move-up",
          "move-down",
          "suppress",
          "rename",
          "fold");

  private final Actions actions;
  private final ProgramView view;
  private final TreeCommands commands;

  private TreeActions(Actions actions, ProgramView view, TreeCommands commands) {
    this.actions = actions;
    this.view = view;
    this.commands = commands;
  }

  static void addTo(Actions actions, ProgramView view, TreeCommands commands) {
    TreeActions all = new TreeActions(actions, view, commands);
    all.add(
        "undo",
        text("undoInTheProgram"),
        "control Z",
        () -> commands.undoes().isPresent(),
        commands::undo);
    all.add(
        "redo",
        text("doAgainInTheProgram"),
        "control shift Z",
        () -> commands.redoes().isPresent(),
        commands::redo);
    all.nodes();
    all.going();
    for (NodeKind kind : NodeKind.values()) {
      if (kind.group() != NodeKind.Group.GIVEN) {
        all.add(
            "add-" + kind.name().toLowerCase(Locale.ROOT).replace('_', '-'),
            text("addAction", KindTitles.of(kind)),
            "",
            commands::editable,
            () -> commands.add(kind));
      }
    }
  }

  private void nodes() {
    node("cut", text("cutNodes"), "control X", commands::cut);
    add(
        "copy",
        text("copyNodes"),
        "control C",
        () -> commands.canCopy() && view.keysMeanTree(),
        commands::copy);
    add(
        "paste",
        text("pasteNodes"),
        "control V",
        () -> commands.editable() && view.keysMeanTree(),
        commands::paste);
    node("delete", text("deleteNodes"), "DELETE", commands::delete);
    node("duplicate", text("duplicateNodes"), "control D", commands::duplicate);
    node("move-up", text("moveNodesUp"), "alt UP", () -> commands.shift(false));
    node("move-down", text("moveNodesDown"), "alt DOWN", () -> commands.shift(true));
    node("suppress", text("suppressNodesOrUseThemAgain"), "control SLASH", commands::suppress);
    node("rename", text("renameNode"), "F2", view::rename);
    add(
        "fold",
        text("foldOrUnfoldNode"),
        "control PERIOD",
        () -> commands.ready() && view.keysMeanTree(),
        view::toggleFold);
  }

  private void going() {
    add(
        "fold-all",
        text("foldAllNodes"),
        "control alt OPEN_BRACKET",
        commands::ready,
        () -> view.foldAll(true));
    add(
        "unfold-all",
        text("unfoldAllNodes"),
        "control alt CLOSE_BRACKET",
        commands::ready,
        () -> view.foldAll(false));
    add("find", text("findInTheProgram"), "control F", commands::ready, view::find);
    add(
        "find-next",
        text("nextMatchInTheProgram"),
        "F3",
        commands::ready,
        () -> view.findNext(true));
    add(
        "find-previous",
        text("matchBeforeInTheProgram"),
        "shift F3",
        commands::ready,
        () -> view.findNext(false));
    add(
        "breakpoint",
        text("breakpointAtTheNodeOrNone"),
        "F9",
        commands::ready,
        view::toggleBreakpoint);
    add(
        "palette",
        text("findANodeToAdd"),
        "control shift A",
        commands::editable,
        view::focusPalette);
    add("form", text("goToTheFormOfThe"), "", commands::ready, view::focusForm);
    add("to-tree", text("goToTheTree"), "", commands::ready, view::focusTree);
    add("script", text("showTheNodeInTheScript"), "", commands::ready, view::showInScript);
    add("as-text", text("editTheProgramFileAsText"), "", view::canEditText, view::editAsText);
    add("close", text("closeProgram"), "control W", () -> view.hasProgram(), view::close);
    actions.add(
        new Action(
                PREFIX + "follow",
                text("followTheRunningProgramInThe"),
                "",
                () -> view.component().isShowing(),
                view::toggleFollow)
            .checked(view::follows));
  }

  private void node(String id, String title, String keys, Runnable run) {
    add(id, title, keys, () -> commands.canChange() && view.keysMeanTree(), run);
  }

  private void add(String id, String title, String keys, BooleanSupplier enabled, Runnable run) {
    actions.add(
        new Action(
            PREFIX + id,
            title,
            keys,
            () -> view.component().isShowing() && enabled.getAsBoolean(),
            run));
  }

  /**
   * Does what a key is for on this screen, whatever it means elsewhere.
   *
   * @param inTree whether keys go to the tree itself
   */
  static boolean perform(Actions actions, KeyStroke stroke, boolean inTree) {
    List<Action> meant =
        actions.all().stream()
            .filter(each -> each.id().startsWith(PREFIX))
            .filter(each -> inTree || !IN_TREE.contains(each.id().substring(PREFIX.length())))
            .filter(each -> stroke.equals(KeyStroke.getKeyStroke(actions.keysOf(each.id()))))
            .filter(each -> each.enabled().getAsBoolean())
            .toList();
    meant.stream().findFirst().ifPresent(each -> actions.run(each.id()));
    return !meant.isEmpty();
  }
}
