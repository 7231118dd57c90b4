package org.pendant.desktop.editor;

import java.util.function.Consumer;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.Actions;

/** Editor actions: what can be done in the editor, by name and key. */
final class EditorActions {
  /** Their ids begin so. */
  private static final String PREFIX = "editor.";

  private final Actions actions;
  private final ScriptEditor editor;

  private EditorActions(Actions actions, ScriptEditor editor) {
    this.actions = actions;
    this.editor = editor;
  }

  static void addTo(Actions actions, ScriptEditor editor) {
    EditorActions all = new EditorActions(actions, editor);
    all.writing();
    all.lines();
    all.going();
    all.names();
    all.searching();
    all.program();
  }

  private void writing() {
    write("undo", "Undo", "control Z", each -> each.area().undoLastAction());
    write("redo", "Redo", "control shift Z", each -> each.area().redoLastAction());
    write("complete", "Complete", "control SPACE", ProgramEditor::complete);
    write("signature", "Show parameters", "control shift SPACE", ProgramEditor::showSignature);
    write("quick-fix", "Quick fix", "alt ENTER", ProgramEditor::fix);
    write("format", "Format", "control shift I", each -> each.layoutCommands().format());
    write(
        "comment",
        "Toggle comment",
        "control SLASH",
        each -> each.layoutCommands().toggleComment());
    write(
        "indent",
        "Indent lines",
        "control CLOSE_BRACKET",
        each -> each.layoutCommands().shift(true));
    write(
        "outdent",
        "Outdent lines",
        "control OPEN_BRACKET",
        each -> each.layoutCommands().shift(false));
    add("fold", "Fold or unfold block", "control PERIOD", Folds::toggle);
    add("fold-all", "Fold all blocks", "control alt OPEN_BRACKET", each -> Folds.all(each, true));
    add(
        "unfold-all",
        "Unfold all blocks",
        "control alt CLOSE_BRACKET",
        each -> Folds.all(each, false));
  }

  private void lines() {
    write("move-up", "Move lines up", "alt UP", each -> each.layoutCommands().moveLines(false));
    write(
        "move-down", "Move lines down", "alt DOWN", each -> each.layoutCommands().moveLines(true));
    write("duplicate", "Duplicate lines", "control D", each -> each.layoutCommands().duplicate());
    write("delete-line", "Delete lines", "control shift K", each -> each.layoutCommands().delete());
  }

  private void going() {
    add("back", "Go back", "alt LEFT", each -> editor.navigation().back(each));
    add("forward", "Go forward", "alt RIGHT", each -> editor.navigation().forward(each));
    add("open-file", "Go to script\u2026", "control P", each -> editor.quickOpen().files());
    add(
        "symbol",
        "Go to function or global\u2026",
        "control shift O",
        each -> editor.quickOpen().symbols());
    add("next-tab", "Next program", "control TAB", each -> editor.turn(1));
    add("previous-tab", "Previous program", "control shift TAB", each -> editor.turn(-1));
  }

  private void names() {
    add("definition", "Go to definition", "F12", each -> each.names().goToDefinition());
    add("references", "Find references", "shift F12", each -> each.names().findReferences());
    write("rename", "Rename", "F2", each -> each.names().rename());
  }

  private void searching() {
    add("find", "Find", "control F", each -> editor.find().open(false));
    write("replace", "Find and replace", "control H", each -> editor.find().open(true));
    add("find-next", "Next match", "F3", each -> editor.find().step(true));
    add("find-previous", "Previous match", "shift F3", each -> editor.find().step(false));
    add("line", "Go to line", "control G", each -> each.layoutCommands().goToLine());
  }

  private void program() {
    add("close", "Close program", "control W", each -> editor.close());
    actions.add(
        new Action(
            PREFIX + "reopen",
            "Open the closed program again",
            "control shift T",
            editor.closer()::canReopen,
            editor.closer()::reopen));
    add(
        "breakpoint",
        "Toggle breakpoint",
        "F9",
        each -> each.toggleBreakpoint(each.area().lineAt(each.area().getCaretPosition())));
    actions.add(
        new Action(
                PREFIX + "follow",
                "Follow the running program in the script",
                "",
                () -> editor.component().isShowing(),
                editor::toggleFollow)
            .checked(editor::follows));
    add("larger", "Larger text", "control EQUALS", each -> each.zoom(1));
    add("smaller", "Smaller text", "control MINUS", each -> each.zoom(-1));
    add("usual-size", "Usual text size", "control 0", each -> each.zoom(0));
  }

  /** Something that changes the text, which is not possible where a tree generates it. */
  private void write(String id, String title, String keys, Consumer<ProgramEditor> run) {
    actions.add(
        new Action(
            PREFIX + id,
            title,
            keys,
            () -> editor.component().isShowing() && editor.current().editable(),
            () -> run.accept(editor.current())));
  }

  private void add(String id, String title, String keys, Consumer<ProgramEditor> run) {
    actions.add(
        new Action(
            PREFIX + id,
            title,
            keys,
            () -> editor.component().isShowing(),
            () -> run.accept(editor.current())));
  }
}
