package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.desktop.program.Trees.MAIN;
import static org.pendant.desktop.program.Trees.comment;
import static org.pendant.desktop.program.Trees.shown;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.StepNames;
import org.pendant.project.program.script.GeneratedScript.NodeLines;

/** A program of PolyScope X on the Program screen. */
final class ForeignTreeTest {
  private static final String WAIT =
      """
      {"application": {"urscript": {"script": "reset_world_model()"}},
       "program": {
        "programContent": {"guid": "a", "contributedNode": {"type": "ur-program"}, "children": [
          {"guid": "b", "contributedNode": {"type": "ur-wait"},
           "programLabel": [{"value": "2 s"}]}]},
        "urscript": {"nodeIDList": ["0", "a", "b"],
          "script": "$ 1 \\"ur-program\\"\\n$ 2 \\"ur-wait\\"\\nsleep(2)"}}}
      """;

  @TempDir Path folder;
  private final List<String> told = new ArrayList<>();
  private String clipboard = "";
  private ProgramDocument document;
  private TreeProgram program;
  private TreeCommands commands;

  @BeforeEach
  void open() throws IOException {
    Path file = folder.resolve("wait.urpx");
    Files.writeString(file, WAIT);
    document = ProgramDocument.of(SavedProgram.read(file));
    program =
        new TreeProgram(
            document,
            () -> Installation.NONE,
            Runnable::run,
            Runnable::run,
            (shown, before, now) -> document.script().setText(now.text()),
            () -> 0);
    commands = new TreeCommands(new First(), new Board(), told::add);
    commands.setProgram(Optional.of(program));
  }

  /** The first node of PolyScope X is selected. */
  private final class First implements TreeCommands.Selection {
    @Override
    public Set<Long> selected() {
      return Set.of(key("ur-program"));
    }

    @Override
    public OptionalLong lead() {
      return OptionalLong.of(key("ur-program"));
    }

    @Override
    public void select(Collection<Long> keys) {
      throw new AssertionError("nothing has come");
    }
  }

  /** A clipboard of the test's own. */
  private final class Board implements TreeCommands.Clipboard {
    @Override
    public String get() {
      return clipboard;
    }

    @Override
    public void put(String text) {
      clipboard = text;
    }
  }

  private long key(String label) {
    return program.tree().nodes().stream()
        .filter(each -> StepNames.label(each).equals(label))
        .findFirst()
        .orElseThrow()
        .key();
  }

  @Test
  void showsTheNodesAsUsedAndWhatDoesNotRunAsSuppressed() {
    assertEquals(
        "ur-program .ur-wait 2 s -Script: wait.urpx Script: wait.urpx", shown(program.tree()));
    assertEquals(
        List.of(false, false, false, true, false),
        program.tree().nodes().stream().map(ProgramNode::suppressed).toList());
    assertEquals(List.of(), program.problems());
  }

  @Test
  void theLinesOfANodeAreThoseThatDoItsWork() {
    NodeLines place = program.script().of(key("ur-wait 2 s")).orElseThrow();
    List<String> lines = document.script().text().lines().toList();
    assertEquals("  sleep(2)", lines.get(place.first() - 1));
    assertEquals(place, program.script().at(place.first()).orElseThrow());
    assertEquals("wait.script", document.script().name());
  }

  @Test
  void nothingChangesItAndPeopleAreToldWhy() {
    String before = document.text();
    program.change("Add", 0, program.tree().insert(MAIN, 0, List.of(comment("new"))));
    List<Runnable> edits =
        List.of(
            () -> commands.add(NodeKind.HALT),
            () -> commands.addScript("x = 1"),
            commands::delete,
            commands::cut,
            commands::paste,
            commands::duplicate,
            commands::suppress,
            () -> commands.shift(true),
            () -> commands.rename(key("ur-program"), "other"));
    edits.forEach(Runnable::run);
    assertEquals(before, document.text());
    assertFalse(document.modified());
    assertEquals(edits.size(), told.size());
    assertEquals(
        Set.of(
            "wait.urpx is a program of PolyScope X, which is shown and not changed;"
                + " save it as a program of Pendant first"),
        Set.copyOf(told));
    assertFalse(commands.editable());
    assertFalse(commands.canChange());
  }

  @Test
  void nodesAreCopiedAsTheyStandInTheProgram() {
    assertTrue(commands.canCopy());
    commands.copy();
    assertTrue(clipboard.contains("suppressed folder name=\"ur-program\""), clipboard);
  }

  @Test
  void aCopyOfItThatIsSavedElsewhereCanBeChanged() {
    List<String> heard = new ArrayList<>();
    program.addListener(
        new TreeProgram.Listener() {
          @Override
          public void treeChanged() {
            heard.add(shown(program.tree()));
          }
        });
    document.saved(document.toSaveAs(folder.resolve("mine.pendant")));
    assertEquals(1, heard.size());
    assertTrue(program.tree().find(key("ur-program")).orElseThrow().suppressed());
    program.change("Add", 0, program.tree().insert(MAIN, 0, List.of(comment("new"))));
    assertTrue(shown(program.tree()).startsWith("new -ur-program"), shown(program.tree()));
    assertTrue(document.modified());
  }

  @Test
  void isShownAnewWhenItsFileHasChanged() throws IOException {
    Files.writeString(folder.resolve("wait.urpx"), WAIT.replace("\"2 s\"", "\"3 s\""));
    document.reloaded(SavedProgram.read(folder.resolve("wait.urpx")));
    assertTrue(shown(program.tree()).contains("ur-wait 3 s"), shown(program.tree()));
    assertEquals(Optional.empty(), program.undo());
  }
}
