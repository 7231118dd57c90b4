package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

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
    write("undo", text("undo"), "control Z", each -> each.area().undoLastAction());
    write("redo", text("redo"), "control shift Z", each -> each.area().redoLastAction());
    write("complete", text("complete"), "control SPACE", ProgramEditor::complete);
    write("signature", text("showParameters"), "control shift SPACE", ProgramEditor::showSignature);
    write("quick-fix", text("quickFix"), "alt ENTER", ProgramEditor::fix);
    write("format", text("format"), "control shift I", each -> each.layoutCommands().format());
    write(
        "comment",
        text("toggleComment"),
        "control SLASH",
        each -> each.layoutCommands().toggleComment());
    write(
        "indent",
        text("indentLines"),
        "control CLOSE_BRACKET",
        each -> each.layoutCommands().shift(true));
    write(
        "outdent",
        text("outdentLines"),
        "control OPEN_BRACKET",
        each -> each.layoutCommands().shift(false));
    add("fold", text("foldOrUnfoldBlock"), "control PERIOD", Folds::toggle);
    add(
        "fold-all",
        text("foldAllBlocks"),
        "control alt OPEN_BRACKET",
        each -> Folds.all(each, true));
    add(
        "unfold-all",
        text("unfoldAllBlocks"),
        "control alt CLOSE_BRACKET",
        each -> Folds.all(each, false));
  }

  private void lines() {
    write("move-up", text("moveLinesUp"), "alt UP", each -> each.layoutCommands().moveLines(false));
    write(
        "move-down",
        text("moveLinesDown"),
        "alt DOWN",
        each -> each.layoutCommands().moveLines(true));
    write(
        "duplicate",
        text("duplicateLines"),
        "control D",
        each -> each.layoutCommands().duplicate());
    write(
        "delete-line",
        text("deleteLines"),
        "control shift K",
        each -> each.layoutCommands().delete());
  }

  private void going() {
    add("back", text("goBack"), "alt LEFT", each -> editor.navigation().back(each));
    add("forward", text("goForward"), "alt RIGHT", each -> editor.navigation().forward(each));
    add("open-file", text("goToScript"), "control P", each -> editor.quickOpen().files());
    add(
        "symbol",
        text("goToFunctionOrGlobal"),
        "control shift O",
        each -> editor.quickOpen().symbols());
    add("next-tab", text("nextProgram"), "control TAB", each -> editor.turn(1));
    add("previous-tab", text("previousProgram"), "control shift TAB", each -> editor.turn(-1));
  }

  private void names() {
    add("definition", text("goToDefinition"), "F12", each -> each.names().goToDefinition());
    add("references", text("findReferences"), "shift F12", each -> each.names().findReferences());
    write("rename", text("rename"), "F2", each -> each.names().rename());
  }

  private void searching() {
    add("find", text("find"), "control F", each -> editor.find().open(false));
    write("replace", text("findAndReplace"), "control H", each -> editor.find().open(true));
    add("find-next", text("nextMatch"), "F3", each -> editor.find().step(true));
    add("find-previous", text("previousMatch"), "shift F3", each -> editor.find().step(false));
    add("line", text("goToLine"), "control G", each -> each.layoutCommands().goToLine());
  }

  private void program() {
    add("close", text("closeProgram"), "control W", each -> editor.close());
    actions.add(
        new Action(
            PREFIX + "reopen",
            text("openTheClosedProgramAgain"),
            "control shift T",
            editor.closer()::canReopen,
            editor.closer()::reopen));
    add(
        "breakpoint",
        text("toggleBreakpoint"),
        "F9",
        each -> each.toggleBreakpoint(each.area().lineAt(each.area().getCaretPosition())));
    actions.add(
        new Action(
                PREFIX + "follow",
                text("followTheRunningProgramInThe"),
                "",
                () -> editor.component().isShowing(),
                editor::toggleFollow)
            .checked(editor::follows));
    add("larger", text("largerText"), "control EQUALS", each -> each.zoom(1));
    add("smaller", text("smallerText"), "control MINUS", each -> each.zoom(-1));
    add("usual-size", text("usualTextSize"), "control 0", each -> each.zoom(0));
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
