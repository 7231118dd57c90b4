package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.desktop.program.Trees.MAIN;
import static org.pendant.desktop.program.Trees.comment;
import static org.pendant.desktop.program.Trees.folder;
import static org.pendant.desktop.program.Trees.shown;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.text.ProgramText;

final class TreeProgramTest {
  private final ProgramDocument document =
      ProgramDocument.untitled(
          "test.pendant", ProgramText.write(Trees.of(comment("a"), folder("F", comment("b")))));
  private final Deque<Runnable> work = new ArrayDeque<>();
  private final TreeProgram program =
      new TreeProgram(
          document,
          () -> Installation.NONE,
          work::add,
          Runnable::run,
          (shown, before, now) -> document.script().setText(now.text()),
          () -> 0);

  private void doWork() {
    while (!work.isEmpty()) {
      work.poll().run();
    }
  }

  private void add(String text) {
    program.change("Add", 0, program.tree().insert(MAIN, 0, List.of(comment(text))));
  }

  @Test
  void eachChangeIsInTheTextAtOnce() {
    assertFalse(document.modified());
    add("new");
    assertTrue(document.modified());
    assertEquals(program.tree().renumbered(), ProgramText.read(document.text()).tree());
    program.undo();
    assertFalse(document.modified());
    program.redo();
    assertEquals("new a F .b", shown(program.tree()));
  }

  @Test
  void aTextThatChangesOtherwiseIsReadAgainAndCanBeUndone() {
    document.setText(ProgramText.write(Trees.of(comment("z"))));
    assertEquals("z", shown(program.tree()));
    program.undo();
    assertEquals("a F .b", shown(program.tree()));
    assertEquals(program.tree().renumbered(), ProgramText.read(document.text()).tree());
  }

  @Test
  void nodesKeepTheirKeysWhenTheTextIsReadAgain() {
    long b = program.tree().nodes().getLast().key();
    ProgramTree other =
        Trees.of(comment("new"), comment("a"), folder("F", comment("c"), comment("b")));
    document.setText(ProgramText.write(other));
    assertEquals("new a F .c .b", shown(program.tree()));
    assertEquals(b, program.tree().nodes().getLast().key());
    assertEquals(6, program.tree().nodes().stream().map(each -> each.key()).distinct().count());
  }

  @Test
  void aTextThatIsNoTreeStaysAndIsToldByItsLines() {
    String broken = document.text().replace("comment", "commend");
    document.setText(broken);
    assertEquals(2, program.textProblems().size());
    add("lost?");
    assertEquals(broken, document.text());
    document.setText(broken.replace("commend", "comment"));
    assertEquals(List.of(), program.textProblems());
    assertEquals("a F .b", shown(program.tree()));
  }

  @Test
  void anEmptyTextIsANewProgram() {
    document.setText("");
    assertEquals(List.of(), program.textProblems());
    assertEquals("", shown(program.tree()));
  }

  @Test
  void theScriptFollowsAndIsNamedLikeTheProgram() {
    doWork();
    assertTrue(document.script().text().contains("def test"), document.script().text());
    assertEquals("test.script", document.script().name());
    add("new");
    boolean[] ran = {false};
    program.whenChecked(() -> ran[0] = true);
    assertFalse(ran[0]);
    doWork();
    assertTrue(ran[0]);
    assertEquals(program.script().text(), document.script().text());
    assertTrue(program.script().text().contains("new"));
  }

  @Test
  void workForATreeThatIsNoMoreIsLeftOut() {
    add("one");
    add("two");
    doWork();
    assertTrue(program.script().text().contains("two"));
    assertEquals(List.of(), program.problems());
  }

  @Test
  void anotherInstallationIsCheckedAgain() {
    doWork();
    program.check();
    assertEquals(1, work.size());
  }

  @Test
  void theScriptIsCalledLikeTheFileThatTheProgramIsSavedIn() {
    doWork();
    document.saved(document.toSaveAs(Path.of("cell.pendant")));
    doWork();
    assertTrue(document.script().text().contains("def cell"), document.script().text());
    assertEquals("cell.script", document.script().name());
  }
}
